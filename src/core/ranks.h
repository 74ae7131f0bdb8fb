// The ranks that share a grid by rows: which rows each has, and how they exchange what they have. A failure of one rank is
// recorded at once; this rank continues to take part, and all get it at the next checked exchange.
#pragma once

#include <roughcontact/plugin.h>
#include <roughcontact/ranks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/caught.h"

namespace rc {

// How rows are handed out: in pieces of 2^halvings rows, so that they can be halved so often. Sums are made piece by piece.
struct RowPieces {
  RowPieces(std::int64_t ny, std::int64_t ranks);

  std::int64_t count() const { return (ny + rows - 1) / rows; }
  std::int64_t first_row(std::int64_t rank) const;  // also of rank = ranks: ny

  std::int64_t ny, ranks;
  int halvings;
  std::int64_t rows;  // of a piece
};

class Ranks {
  struct Link;

 public:
  // All ranks make one at the same time. Throws the same Error on all if one lacks memory.
  Ranks(const rc_exchange& exchange, std::int64_t ny);
  // The same ranks on a grid of so many rows, sums: with memory for sums over them; on one of half as many rows, each with half
  // of its own.
  Ranks on(std::int64_t ny, bool sums) const;
  Ranks halved() const;
  Ranks(Ranks&&) = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  std::int64_t rank() const { return link_->exchange.rank; }
  std::int64_t size() const { return link_->exchange.ranks; }
  std::int64_t all_rows() const { return first_.back(); }
  const std::vector<std::int64_t>& first() const { return first_; }  // rows, [size + 1]
  std::int64_t first_row() const { return first_[static_cast<std::size_t>(rank())]; }
  std::int64_t rows() const { return rows_of(rank()); }
  std::int64_t rows_of(std::int64_t rank) const {
    return first_[static_cast<std::size_t>(rank) + 1] - first_[static_cast<std::size_t>(rank)];
  }
  bool has_last_row() const { return rows() > 0 && first_row() + rows() == all_rows(); }
  // Ranks with the rows before and after; -1: none. around: the first row comes after the last.
  std::int64_t previous(bool around = false) const;
  std::int64_t next(bool around = false) const { return rows() == 0 ? -1 : !has_last_row() ? rank() + 1 : around ? 0 : -1; }
  int halvings() const { return halvings_; }  // of a piece's rows, until one is left
  std::int64_t piece_rows() const { return std::int64_t{1} << halvings_; }
  std::int64_t pieces_of(std::int64_t rank) const { return (rows_of(rank) + piece_rows() - 1) / piece_rows(); }

  // Records this rank's failure; the first one counts.
  void failed(rc_status status, const char* message) const noexcept;
  // Runs an action that may throw. Then this rank has failed.
  template <class Action> void guarded(const Action& action) const {
    caught(
        [&]() -> rc_status {
          action();
          return RC_OK;
        },
        [&](rc_status status, const char* what) {
          failed(status, what);
          return status;
        });
  }

  // Runs an action that all ranks perform, with the same exchanges in it. If one fails, wherever that is, the others learn of it
  // before their next exchange, or at the end: all throw the same Error, and exchange nothing more.
  template <class Action> void together(const Action& action) const {
    if (link_->together) return action();
    link_->together = true;
    link_->agreed = RC_OK;
    guarded(action);
    finish_together();
  }

  // A part of such an action that saves the exchanges of statuses: nothing in it may fail on one rank alone, but in guarded().
  class Unwatched {
   public:
    explicit Unwatched(const Ranks* ranks) : link_(ranks ? ranks->link_ : nullptr), before_(link_ && link_->together) {
      if (link_) link_->together = false;
    }
    ~Unwatched() {
      if (link_) link_->together = before_;
    }
    Unwatched(const Unwatched&) = delete;
    Unwatched& operator=(const Unwatched&) = delete;

   private:
    std::shared_ptr<Link> link_;
    bool before_;
  };

  // A stop that one rank asks for reaches all of them with the next checked exchange.
  void ask_stop(rc_status stop) const { link_->asked_stop = std::max(link_->asked_stop, stop); }
  rc_status stop() const { return link_->stop; }
  void forget_stop() const { link_->asked_stop = link_->stop = RC_OK; }

  // Checked exchanges: throw the same Error on every rank if any has failed.
  void agree() const { exchange_statuses(); }
  // Part number i of this rank's pieces, and then those of the pieces of all ranks, in their order. They lie in memory that is
  // there already, so that a sum cannot lack it.
  template <class Part> void put_part(std::size_t i, const Part& part) const {
    static_assert(std::is_trivially_copyable_v<Part> && sizeof(Part) <= most_part_bytes);
    std::memcpy(link_->sent.data() + sizeof(Head) + i * sizeof(Part), &part, sizeof part);
  }
  template <class Part, class Visit> void each_part(const Visit& visit) const {
    sum_parts(sizeof(Part));
    const std::byte* from = link_->received.data();
    for (std::int64_t r = 0; r < size(); ++r) {
      from += sizeof(Head);
      for (std::int64_t piece = pieces_of(r); piece > 0; --piece, from += sizeof(Part)) {
        Part part;
        std::memcpy(&part, from, sizeof part);
        visit(part);
      }
    }
  }
  // One value of each rank, in their order.
  template <class Value> std::vector<Value> of_each(const Value& mine) const {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::vector<Value> all;
    guarded([&] { all.resize(static_cast<std::size_t>(size())); });
    std::fill(link_->bytes.begin(), link_->bytes.end(), sizeof(Value));
    checked(&mine, link_->bytes, all.data());
    return all;
  }

  // The values of all ranks, in the order of ranks; their numbers may differ.
  template <class Value> std::vector<Value> of_any(const std::vector<Value>& mine) const {
    const std::vector<std::int64_t> bytes = of_each(static_cast<std::int64_t>(mine.size() * sizeof(Value)));
    std::vector<Value> all;
    guarded([&] {
      all.resize(static_cast<std::size_t>(std::accumulate(bytes.begin(), bytes.end(), std::int64_t{0})) / sizeof(Value));
    });
    checked(mine.data(), bytes, all.data());
    return all;
  }
  bool any(bool mine) const {
    const std::vector<char> all = of_each(static_cast<char>(mine));
    return std::any_of(all.begin(), all.end(), [](char each) { return each != 0; });
  }

  // Unchecked ones: the next checked one reports a failure of theirs. While all perform one action, those of `gather` and `shift`
  // begin as checked ones do; before a transposition, and what goes with it, call watch().
  void watch() const {
    if (link_->together) exchange_statuses();
  }
  void gather(const void* mine, const std::int64_t* bytes, void* all) const;
  void gather_unwatched(const void* mine, const std::int64_t* bytes, void* all) const;
  void transpose(const void* from, const std::int64_t* sent, void* into, const std::int64_t* received) const;
  void shift(std::int64_t to, const void* from, std::int64_t sent, std::int64_t source, void* into, std::int64_t received) const;
  // A row of values to the next rank; the previous rank's into `into`. And back.
  template <class Value> void down(const Value* from, Value* into, std::int64_t count, bool around = false) const {
    pass(next(around), from, previous(around), into, count);
  }
  template <class Value> void up(const Value* from, Value* into, std::int64_t count, bool around = false) const {
    pass(previous(around), from, next(around), into, count);
  }
  // The rows of all ranks [all_rows * columns], from this rank's.
  template <class Value> void gather_rows(const Value* mine, std::int64_t columns, Value* all) const {
    for (std::int64_t r = 0; r < size(); ++r)
      link_->bytes[static_cast<std::size_t>(r)] = rows_of(r) * columns * static_cast<std::int64_t>(sizeof(Value));
    gather(mine, link_->bytes.data(), all);
  }

  rc_ranks_counts& counts() const { return link_->counts; }

 private:
  static constexpr std::size_t most_part_bytes = 256;  // of each piece and rank that a small exchange carries

  // Goes before the bytes of each rank: its status, and the stop that it asks for.
  struct Head {
    std::int32_t status, stop;
  };
  struct Link {
    explicit Link(const rc_exchange& with);
    void make_room(std::int64_t pieces);

    rc_exchange exchange;
    rc_ranks_counts counts = RC_RANKS_COUNTS_INIT;
    rc_status failed = RC_OK, asked_stop = RC_OK, stop = RC_OK;
    char message[400] = "";
    // While all perform one action: each exchange begins with one of statuses alone, which a rank that has failed joins instead.
    bool together = false;
    rc_status agreed = RC_OK;  // the failure that all ranks know
    char agreed_message[420] = "";
    // Memory for small exchanges, allocated beforehand, so that no rank lacks it when others already take part.
    std::vector<std::int64_t> bytes, with_head;  // [ranks]
    std::vector<std::byte> sent, received;
  };

  Ranks(std::shared_ptr<Link> link, std::vector<std::int64_t> first, int halvings)
      : link_(std::move(link)), first_(std::move(first)), halvings_(halvings) {}
  template <class Value>
  void pass(std::int64_t to, const Value* from, std::int64_t source, Value* into, std::int64_t count) const {
    const auto bytes = count * static_cast<std::int64_t>(sizeof(Value));
    if (to != rank()) return shift(to, from, to >= 0 ? bytes : 0, source, into, source >= 0 ? bytes : 0);
    watch();  // as ranks without rows do
    std::copy_n(from, count, into);
  }
  void sum_parts(std::size_t size) const;
  void checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const;
  void exchange_checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const;
  void exchange_with_heads(std::byte* sent, std::byte* received) const;
  void exchange_statuses() const;
  void finish_together() const;
  [[noreturn]] void raise(std::int64_t first, rc_status status) const;
  std::int64_t sent_to_others(const std::int64_t* sent) const;

  std::shared_ptr<Link> link_;
  std::vector<std::int64_t> first_;
  int halvings_;
};

// An action that may throw, and fails on all ranks if it fails on one; ranks null: it just runs.
template <class Action> void on_all(const Ranks* ranks, const Action& action) {
  if (!ranks) return action();
  ranks->guarded(action);
  ranks->agree();
}

// The ranks as components see them; null: this process has the whole grid.
struct SharedRows : rc_rows {
  SharedRows() : rc_rows{}, of(nullptr) {}
  explicit SharedRows(const Ranks& ranks);
  static const Ranks* ranks_of(const rc_rows* rows) { return rows ? static_cast<const SharedRows*>(rows)->of : nullptr; }

  const Ranks* of;
};

}  // namespace rc
