#include "core/ranks.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <numeric>

namespace rc {

namespace {

constexpr int most_halvings = 5;
constexpr std::int64_t small_bytes = 256;  // of each piece and rank that a small exchange carries

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
  const auto most = static_cast<std::size_t>(small_bytes * (pieces + exchange.ranks));
  if (sent.size() >= most) return;
  sent.resize(most);
  received.resize(most);
}

Ranks::Ranks(const rc_exchange& exchange, std::int64_t ny) {
  const RowPieces pieces(ny, exchange.ranks);
  link_ = std::make_shared<Link>(exchange);
  link_->make_room(pieces.count());
  first_ = first_rows(pieces);
  halvings_ = pieces.halvings;
}

Ranks Ranks::on(std::int64_t ny) const {
  const RowPieces pieces(ny, size());
  link_->make_room(pieces.count());
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
  std::snprintf(link_->message, sizeof link_->message, "%s", message);
}

std::int64_t Ranks::sent_to_others(const std::int64_t* sent) const {
  return std::accumulate(sent, sent + size(), std::int64_t{0}) - sent[rank()];
}

void Ranks::gather(const void* mine, const std::int64_t* bytes, void* all) const {
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
  if (to < 0 && source < 0) return;
  const rc_exchange& exchange = link_->exchange;
  ++link_->counts.shifts;
  link_->counts.shifted += sent;
  if (const char* const what = exchange.shift(exchange.user, to, from, sent, source, into, received))
    failed(RC_ERR_EXTERNAL, what);
}

void Ranks::sum_parts(const void* mine, std::size_t size_of_part, void* all) const {
  for (std::int64_t r = 0; r < size(); ++r)
    link_->bytes[static_cast<std::size_t>(r)] = size_of_part > 0 ? pieces_of(r) * static_cast<std::int64_t>(size_of_part) : 0;
  ++link_->counts.reductions;
  link_->counts.reduced += link_->bytes[static_cast<std::size_t>(rank())];
  exchange_checked(mine, link_->bytes, all);
}

void Ranks::checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const {
  ++link_->counts.gathers;
  link_->counts.gathered += bytes[static_cast<std::size_t>(rank())];
  exchange_checked(mine, bytes, all);
}

// What this rank has not heard from others it has to tell them.
void Ranks::finish_alike() const {
  if (link_->told == RC_OK) guarded([&] { exchange_statuses(); });
  link_->alike = false;
  link_->failed = RC_OK;
  if (link_->told == RC_OK) return;
  fail(std::exchange(link_->told, RC_OK), static_cast<const char*>(link_->told_message));
}

void Ranks::exchange_statuses() const {
  ++link_->counts.gathers;
  std::fill(link_->with_head.begin(), link_->with_head.end(), sizeof(Head));
  exchange_with_heads(nullptr, link_->sent.data(), link_->received.data());
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
  } else if (link_->alike) {
    exchange_statuses();
  }
  std::transform(bytes.begin(), bytes.end(), link_->with_head.begin(), [](std::int64_t each) { return each + head; });
  exchange_with_heads(mine, sent, received);
  auto* to = static_cast<std::byte*>(all);
  for (const std::int64_t count : bytes) {
    if (count > 0) to = std::copy_n(received + head, count, to);
    received += head + count;
  }
}

// link_->with_head: the bytes of each rank, its head included.
void Ranks::exchange_with_heads(const void* mine, std::byte* sent, std::byte* received) const {
  const rc_exchange& exchange = link_->exchange;
  const std::int64_t own = link_->with_head[static_cast<std::size_t>(rank())];
  const Head head{link_->failed, link_->asked_stop};
  std::memcpy(sent, &head, sizeof head);
  if (own > static_cast<std::int64_t>(sizeof head))
    std::memcpy(sent + sizeof head, mine, static_cast<std::size_t>(own) - sizeof head);
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

// With the message of the first rank that failed.
void Ranks::raise(std::int64_t first, rc_status status) const {
  const rc_exchange& exchange = link_->exchange;
  std::fill(link_->with_head.begin(), link_->with_head.end(), 0);
  link_->with_head[static_cast<std::size_t>(first)] = sizeof link_->message;
  char message[sizeof link_->message] = "";
  exchange.gather(exchange.user, link_->message, link_->with_head.data(), message);
  message[sizeof message - 1] = 0;
  link_->failed = RC_OK;
  forget_stop();
  link_->told = status;
  std::snprintf(link_->told_message, sizeof link_->told_message, "rank %d: %s", static_cast<int>(first), message);
  fail(status, static_cast<const char*>(link_->told_message));
}

}  // namespace rc
