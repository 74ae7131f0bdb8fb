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

Ranks::Ranks(const rc_exchange& exchange, std::int64_t ny) : link_(std::make_shared<Link>()) {
  const RowPieces pieces(ny, exchange.ranks);
  link_->exchange = exchange;
  first_ = first_rows(pieces);
  halvings_ = pieces.halvings;
}

Ranks Ranks::on(std::int64_t ny) const {
  const RowPieces pieces(ny, size());
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

void Ranks::gather(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const {
  const rc_exchange& exchange = link_->exchange;
  ++link_->counts.gathers;
  link_->counts.gathered += bytes[static_cast<std::size_t>(rank())];
  if (const char* const what = exchange.gather(exchange.user, mine, bytes.data(), all)) failed(RC_ERR_EXTERNAL, what);
}

void Ranks::transpose(const void* from, const std::int64_t* sent, void* into, const std::int64_t* received) const {
  const rc_exchange& exchange = link_->exchange;
  ++link_->counts.transpositions;
  link_->counts.transposed += sent_to_others(sent);
  if (const char* const what = exchange.transpose(exchange.user, from, sent, into, received)) failed(RC_ERR_EXTERNAL, what);
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
  std::vector<std::int64_t> bytes;
  for (std::int64_t r = 0; r < size(); ++r)
    bytes.push_back(size_of_part > 0 ? pieces_of(r) * static_cast<std::int64_t>(size_of_part) : 0);
  ++link_->counts.reductions;
  link_->counts.reduced += bytes[static_cast<std::size_t>(rank())];
  if (link_->alike) exchange_statuses();
  exchange_checked(mine, bytes, all);
}

void Ranks::exchange_statuses() const {
  ++link_->counts.gathers;
  exchange_checked(nullptr, std::vector<std::int64_t>(static_cast<std::size_t>(size()), 0), nullptr);
}

void Ranks::checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const {
  ++link_->counts.gathers;
  link_->counts.gathered += bytes[static_cast<std::size_t>(rank())];
  if (link_->alike) exchange_statuses();
  exchange_checked(mine, bytes, all);
}

// What this rank has not heard from others it has to tell them.
void Ranks::finish_alike() const {
  if (link_->told == RC_OK) guarded([&] { exchange_statuses(); });
  link_->alike = false;
  if (link_->told == RC_OK) return;
  link_->failed = RC_OK;
  fail(std::exchange(link_->told, RC_OK), static_cast<const char*>(link_->told_message));
}

// Each rank's status, and the stop that it asks for, go before its bytes.
void Ranks::exchange_checked(const void* mine, const std::vector<std::int64_t>& bytes, void* all) const {
  struct Head {
    std::int32_t status, stop;
  };
  constexpr auto head = static_cast<std::int64_t>(sizeof(Head));
  const rc_exchange& exchange = link_->exchange;
  const auto here = static_cast<std::size_t>(rank());
  std::vector<std::int64_t> with_head = bytes;
  for (std::int64_t& each : with_head) each += head;
  std::vector<std::byte> sent(static_cast<std::size_t>(with_head[here])),
      received(static_cast<std::size_t>(std::accumulate(with_head.begin(), with_head.end(), std::int64_t{0})));
  const Head own{link_->failed, link_->asked_stop};
  std::memcpy(sent.data(), &own, head);
  if (bytes[here] > 0) std::memcpy(sent.data() + head, mine, static_cast<std::size_t>(bytes[here]));
  if (const char* const what = exchange.gather(exchange.user, sent.data(), with_head.data(), received.data())) {
    failed(RC_ERR_EXTERNAL, what);
  }
  std::vector<rc_status> statuses;
  const std::byte* from = received.data();
  auto* to = static_cast<std::byte*>(all);
  for (const std::int64_t count : bytes) {
    Head its{};
    std::memcpy(&its, from, head);
    statuses.push_back(its.status);
    link_->stop = std::max(link_->stop, its.stop);
    if (count > 0) {
      std::memcpy(to, from + head, static_cast<std::size_t>(count));
      to += count;
    }
    from += head + count;
  }
  if (std::any_of(statuses.begin(), statuses.end(), [](rc_status each) { return each != RC_OK; })) raise(statuses);
}

// With the message of the first rank that failed.
void Ranks::raise(const std::vector<rc_status>& statuses) const {
  const rc_exchange& exchange = link_->exchange;
  const auto first = std::find_if(statuses.begin(), statuses.end(), [](rc_status each) { return each != RC_OK; });
  std::vector<std::int64_t> bytes(statuses.size(), 0);
  bytes[static_cast<std::size_t>(first - statuses.begin())] = sizeof link_->message;
  char message[sizeof link_->message] = "";
  exchange.gather(exchange.user, link_->message, bytes.data(), message);
  message[sizeof message - 1] = 0;
  link_->failed = RC_OK;
  forget_stop();
  link_->told = *first;
  std::snprintf(link_->told_message, sizeof link_->told_message, "rank %d: %s", static_cast<int>(first - statuses.begin()),
                message);
  fail(*first, static_cast<const char*>(link_->told_message));
}

}  // namespace rc
