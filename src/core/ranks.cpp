#include "core/ranks.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <numeric>

namespace rc {

namespace {

constexpr int most_halvings = 5;

}  // namespace

RowPieces::RowPieces(std::int64_t all_rows, std::int64_t all_ranks)
    : ny(all_rows),
      ranks(all_ranks),
      halvings(std::min(most_halvings, (static_cast<int>(std::bit_width(static_cast<std::uint64_t>(all_rows))) - 1) / 2)),
      rows(std::int64_t{1} << halvings) {}

// Ranks without rows come last, so that neighbours in rank are neighbours in rows.
std::int64_t RowPieces::first_row(std::int64_t rank) const {
  const std::int64_t with_rows = std::min(ranks, count());
  return std::min(std::min(rank, with_rows) * count() / with_rows * rows, ny);
}

namespace {

std::vector<std::int64_t> first_rows(const RowPieces& pieces) {
  std::vector<std::int64_t> first;
  for (std::int64_t rank = 0; rank <= pieces.ranks; ++rank) first.push_back(pieces.first_row(rank));
  return first;
}

}  // namespace

Ranks::Link::Link(const rc_exchange& with)
    : exchange(with), bytes(static_cast<std::size_t>(with.ranks)), with_head(bytes.size()) {}

void Ranks::Link::make_room(std::int64_t pieces) {
  const auto most = most_part_bytes * static_cast<std::size_t>(pieces + exchange.ranks);
  if (received.size() >= most) return;
  sent.resize(most);
  received.resize(most);
}

namespace {

// The first rank that is not ready, or the number of ranks. An exchange that needs no memory: after k shifts a rank knows of the
// 2^k before it. failed: null, or what an exchange said.
std::int64_t first_unready(const rc_exchange& exchange, bool ready, const char*& failed) {
  std::int64_t first = ready ? exchange.ranks : exchange.rank;
  for (std::int64_t step = 1; step < exchange.ranks; step *= 2) {
    const std::int64_t to = (exchange.rank + step) % exchange.ranks,
                       from = (exchange.rank + exchange.ranks - step) % exchange.ranks;
    std::int64_t other = exchange.ranks;
    const char* const what = exchange.shift(exchange.user, to, &first, sizeof first, from, &other, sizeof other);
    if (what && !failed) failed = what;
    first = std::min(first, other);
  }
  return first;
}

}  // namespace

Ranks::Ranks(const rc_exchange& exchange, std::int64_t ny) {
  const RowPieces pieces(ny, exchange.ranks);
  halvings_ = pieces.halvings;
  bool ready = false;
  try {
    first_ = first_rows(pieces);
    auto link = std::make_shared<Link>(exchange);
    link->make_room(pieces.count());
    link_ = std::move(link);
    ready = true;
  } catch (const std::bad_alloc&) {
  }
  const char* said = nullptr;
  const std::int64_t unready = first_unready(exchange, ready, said);
  if (unready < exchange.ranks) fail(RC_ERR_MEMORY, "rank ", unready, ": out of memory");
  if (said) failed(RC_ERR_EXTERNAL, said);
}

Ranks Ranks::on(std::int64_t ny, bool sums) const {
  const RowPieces pieces(ny, size());
  if (sums) link_->make_room(pieces.count());
  return {link_, first_rows(pieces), pieces.halvings};
}

Ranks Ranks::halved() const {
  std::vector<std::int64_t> first = first_;
  for (std::int64_t& row : first) row = (row + 1) / 2;
  return {link_, std::move(first), halvings_ - 1};
}

void Ranks::failed(rc_status status, const char* message) const noexcept {
  if (link_->failed != RC_OK || status == RC_OK) return;
  link_->failed = status;
  std::snprintf(link_->message, sizeof link_->message, "%.*s", static_cast<int>(sizeof link_->message - 1), message);
}

std::int64_t Ranks::sent_to_others(const std::int64_t* sent) const {
  return std::accumulate(sent, sent + size(), std::int64_t{0}) - sent[rank()];
}

void Ranks::gather(const void* mine, const std::int64_t* bytes, void* all) const {
  watch();
  gather_unwatched(mine, bytes, all);
}

void Ranks::gather_unwatched(const void* mine, const std::int64_t* bytes, void* all) const {
  const rc_exchange& exchange = link_->exchange;
  ++link_->counts.gathers;
  link_->counts.gathered += bytes[rank()];
  if (const char* const what = exchange.gather(exchange.user, mine, bytes, all)) failed(RC_ERR_EXTERNAL, what);
}

void Ranks::transpose(const void* from, const std::int64_t* sent, void* into, const std::int64_t* received) const {
  const rc_exchange& exchange = link_->exchange;
  ++link_->counts.transpositions;
  link_->counts.transposed += sent_to_others(sent);
  if (const char* const what = exchange.transpose(exchange.user, from, sent, into, received)) failed(RC_ERR_EXTERNAL, what);
}

std::int64_t Ranks::previous(bool around) const {
  if (rows() == 0) return -1;
  if (rank() > 0) return rank() - 1;
  if (!around) return -1;
  std::int64_t last = size() - 1;
  while (rows_of(last) == 0) --last;
  return last;
}

void Ranks::shift(std::int64_t to, const void* from, std::int64_t sent, std::int64_t source, void* into,
                  std::int64_t received) const {
  watch();
  if (to < 0 && source < 0) return;
  const rc_exchange& exchange = link_->exchange;
  ++link_->counts.shifts;
  link_->counts.shifted += sent;
  if (const char* const what = exchange.shift(exchange.user, to, from, sent, source, into, received))
    failed(RC_ERR_EXTERNAL, what);
}

void Ranks::sum_parts(std::size_t size_of_part) const {
  watch();
  const auto head = static_cast<std::int64_t>(sizeof(Head));
  for (std::int64_t r = 0; r < size(); ++r)
    link_->with_head[static_cast<std::size_t>(r)] = head + pieces_of(r) * static_cast<std::int64_t>(size_of_part);
  ++link_->counts.reductions;
  link_->counts.reduced += link_->with_head[static_cast<std::size_t>(rank())] - head;
  exchange_with_heads(link_->sent.data(), link_->received.data());
}

void Ranks::checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const {
  ++link_->counts.gathers;
  link_->counts.gathered += bytes[static_cast<std::size_t>(rank())];
  exchange_checked(mine, bytes, all);
}

// Ends a stretch in which all ranks do the same; exchanges failures that have not been exchanged yet.
void Ranks::finish_together() const {
  if (link_->agreed == RC_OK) guarded([&] { exchange_statuses(); });
  link_->together = false;
  link_->failed = RC_OK;
  if (link_->agreed == RC_OK) return;
  fail(std::exchange(link_->agreed, RC_OK), static_cast<const char*>(link_->agreed_message));
}

void Ranks::exchange_statuses() const {
  if (link_->together && link_->agreed != RC_OK) fail(link_->agreed, static_cast<const char*>(link_->agreed_message));
  ++link_->counts.gathers;
  std::fill(link_->with_head.begin(), link_->with_head.end(), sizeof(Head));
  exchange_with_heads(link_->sent.data(), link_->received.data());
}

// For a large exchange memory is needed, which each must have got before any waits for it.
void Ranks::exchange_checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const {
  constexpr auto head = static_cast<std::int64_t>(sizeof(Head));
  const std::int64_t total = std::accumulate(bytes.begin(), bytes.end(), head * size());
  const std::int64_t own = bytes[static_cast<std::size_t>(rank())] + head;
  std::vector<std::byte> room;
  std::byte *sent = link_->sent.data(), *received = link_->received.data();
  const bool large = total > static_cast<std::int64_t>(link_->received.size());
  if (large) {
    guarded([&] { room.resize(static_cast<std::size_t>(own + total)); });
    exchange_statuses();
    sent = room.data();
    received = sent + own;
  } else {
    watch();
  }
  if (own > head) std::memcpy(sent + head, mine, static_cast<std::size_t>(own - head));
  std::transform(bytes.begin(), bytes.end(), link_->with_head.begin(), [](std::int64_t each) { return each + head; });
  exchange_with_heads(sent, received);
  auto* to = static_cast<std::byte*>(all);
  for (const std::int64_t count : bytes) {
    if (count > 0) to = std::copy_n(received + head, count, to);
    received += head + count;
  }
}

// link_->with_head: the bytes of each rank, its head included. sent: room for this rank's head, and what follows it.
void Ranks::exchange_with_heads(std::byte* sent, std::byte* received) const {
  const rc_exchange& exchange = link_->exchange;
  const Head head{link_->failed, link_->asked_stop};
  std::memcpy(sent, &head, sizeof head);
  if (const char* const what = exchange.gather(exchange.user, sent, link_->with_head.data(), received))
    failed(RC_ERR_EXTERNAL, what);
  std::int64_t first = -1;
  rc_status status = RC_OK;
  for (std::int64_t r = 0; r < size(); received += link_->with_head[static_cast<std::size_t>(r++)]) {
    Head its{};
    std::memcpy(&its, received, sizeof its);
    link_->stop = std::max(link_->stop, its.stop);
    if (its.status == RC_OK || first >= 0) continue;
    first = r;
    status = its.status;
  }
  if (first >= 0) raise(first, status);
}

// Throws the message of the first rank that failed.
void Ranks::raise(std::int64_t first, rc_status status) const {
  const rc_exchange& exchange = link_->exchange;
  std::fill(link_->with_head.begin(), link_->with_head.end(), 0);
  link_->with_head[static_cast<std::size_t>(first)] = sizeof link_->message;
  char message[sizeof link_->message] = "";
  exchange.gather(exchange.user, link_->message, link_->with_head.data(), message);
  message[sizeof message - 1] = 0;
  link_->failed = RC_OK;
  forget_stop();
  link_->agreed = status;
  std::snprintf(link_->agreed_message, sizeof link_->agreed_message, "rank %d: %s", static_cast<int>(first), message);
  fail(status, static_cast<const char*>(link_->agreed_message));
}

}  // namespace rc
