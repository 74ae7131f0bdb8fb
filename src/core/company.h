// With whom a process solves a contact. Alone it has every point of the grid. By rows several processes share the grid: each has
// the points of its rows, all of them are unknowns, and all processes call the same functions. Alike each has every point and
// does what the others do; they agree on stops. If a process is alone, each function below is the plain action.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/chunks.h"
#include "core/ranks.h"

namespace rc {

class Company {
 public:
  Company() = default;
  // The ranks must outlive the company.
  static Company sharing(const Ranks& ranks) { return {std::shared_ptr<const Ranks>(std::shared_ptr<void>(), &ranks), {}}; }
  // The processes that share rows, each working on all points; the same on a grid of half as many rows.
  Company made_alike() const { return {{}, rows_}; }
  Company halved() const { return {std::make_shared<const Ranks>(rows_->halved()), {}}; }

  // Processes that do the same by themselves, without a word to each other.
  static Company repeated() {
    Company company;
    company.repeated_ = true;
    return company;
  }

  // Whether this process has a part of the rows. Then every point stays an unknown, and nothing that needs all points here is
  // done: systems on subsets, solvers inside solvers, answers that solvers keep for the next step.
  bool by_rows() const { return rows_ != nullptr; }
  // A component that fails here may work on another process: "auto" continues without it only if no other process must do the
  // same.
  bool may_pass_over() const { return !rows_ && !alike_ && !repeated_; }
  // Clocks of several processes differ: they stop together, between iterations.
  bool stops_between_products() const { return !alike_; }

  // The rows for a component, in `room`, which must outlive its use; null: this process has all rows.
  const rc_rows* shown_in(SharedRows& room) const {
    if (!rows_) return nullptr;
    room = SharedRows(*rows_);
    return &room;
  }
  const Ranks* rows() const { return rows_.get(); }  // for components that work on rows; null: this process has them all
  std::int64_t own_rows(std::int64_t ny) const { return rows_ ? rows_->rows() : ny; }
  std::int64_t all_rows(std::int64_t ny) const { return rows_ ? rows_->all_rows() : ny; }
  std::int64_t first_row() const { return rows_ ? rows_->first_row() : 0; }
  std::int64_t first_row_of(std::int64_t process) const { return rows_->first()[static_cast<std::size_t>(process)]; }  // by rows
  std::int64_t size() const { return rows_ ? rows_->size() : 1; }
  std::int64_t self() const { return rows_ ? rows_->rank() : 0; }
  int halvings() const { return rows_ ? rows_->halvings() : 0; }  // how often a piece of rows can be halved
  Chunks chunks(std::int64_t nx) const { return Chunks::of(rows_.get(), nx); }

  // An action that may throw, and fails everywhere if it fails in one process.
  template <class Action> void on_all(const Action& action) const { rc::on_all(rows_.get(), action); }
  bool any(bool mine) const { return rows_ ? rows_->any(mine) : mine; }
  // As many values as each process has, in the order of their rows.
  template <class Value> std::vector<Value> joined(std::vector<Value> mine) const {
    return rows_ ? rows_->of_any(mine) : std::move(mine);
  }
  // The sum of one value of each process, if the order does not matter.
  template <class Part> Part united(const Part& mine) const {
    if (!rows_) return mine;
    Part total{};
    for (const Part& part : rows_->of_each(mine)) total = total + part;
    return total;
  }
  // The sum of what add(part, entry) adds for entries 0 .. n-1, by pieces of a fixed size: of entries, or of the rows of `nx`
  // points that processes share. entry(k): its point among the `points` of this process, ascending with k.
  template <class Part, class Entry, class Add>
  Part sum_over(std::size_t n, std::int64_t points, std::int64_t nx, const rc_team& team, const Entry& entry,
                const Add& add) const {
    constexpr std::int64_t entries_of_a_piece = std::int64_t{1} << 16;
    if (!rows_)
      return reduce<Part>(
          static_cast<std::int64_t>(n), team,
          [&](std::int64_t begin, std::int64_t count) {
            Part part;
            for (std::int64_t k = begin; k < begin + count; ++k) add(part, entry(static_cast<std::size_t>(k)));
            return part;
          },
          Part{}, {}, Chunks{entries_of_a_piece});
    const Chunks pieces = chunks(nx);
    std::vector<Part> parts(static_cast<std::size_t>(pieces.count(points)));
    for (std::size_t k = 0; k < n; ++k) add(parts[entry(k) / static_cast<std::size_t>(pieces.values)], entry(k));
    return total<Part>(parts.size(), [&](std::size_t i) { return parts[i]; });
  }
  // The sum of parts 0 .. n-1, one for each piece of rows, of all processes in the order of their rows. It takes no memory.
  template <class Part, class Of> Part total(std::size_t n, const Of& part) const {
    Part sum{};
    for (std::size_t i = 0; i < n; ++i)
      if (rows_)
        rows_->put_part(i, part(i));
      else
        sum = sum + part(i);
    if (rows_) rows_->each_part<Part>([&](const Part& each) { sum = sum + each; });
    return sum;
  }
  double largest(double mine) const;
  // By rows: one value of each process, in their order; all rows of `nx` values, from this process's.
  template <class Value> std::vector<Value> of_each(const Value& mine) const { return rows_->of_each(mine); }
  template <class Value> void gather_rows(const Value* mine, std::int64_t nx, Value* all) const {
    rows_->gather_rows(mine, nx, all);
  }
  // By rows: an action that all do alike, with exchanges in it; if it fails in one process, all throw the same Error.
  template <class Action> void together(const Action& action) const { rows_->together(action); }

  // At the begin of a step.
  void forget_stop() const {
    if (rows_) rows_->forget_stop();
  }
  // Once an iteration, with what this process's monitor says. Returns what holds for all.
  rc_status agreed(rc_status mine) const;
  // Before a product: the stop that all have agreed on; nothing if this process decides by itself.
  std::optional<rc_status> stop() const {
    if (rows_) return rows_->stop();
    return stops_between_products() ? std::nullopt : std::optional<rc_status>(RC_OK);
  }

 private:
  Company(std::shared_ptr<const Ranks> rows, std::shared_ptr<const Ranks> alike)
      : rows_(std::move(rows)), alike_(std::move(alike)) {}

  std::shared_ptr<const Ranks> rows_, alike_;
  bool repeated_ = false;
};

}  // namespace rc
