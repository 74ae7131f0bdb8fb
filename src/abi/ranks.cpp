// rc_ranks_*
#include "core/ranks.h"

#include <memory>

#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/sized_struct.h"
#include "abi/steps.h"
#include "contact/calls/agreement.h"

namespace {

using namespace rc;

rc_exchange checked(const rc_exchange* given) {
  const rc_exchange exchange = read<rc_exchange>(given, "rc_exchange", RC_EXCHANGE_INIT);
  if (exchange.refused) fail(RC_ERR_ARGUMENT, exchange.refused);
  if (exchange.ranks < 1 || exchange.rank < 0 || exchange.rank >= exchange.ranks)
    fail(RC_ERR_ARGUMENT, "rc_exchange.rank = ", exchange.rank, " of rc_exchange.ranks = ", exchange.ranks,
         " must be 0 .. ranks - 1");
  return exchange;
}

const rc_exchange& with_functions(const rc_exchange& exchange) {
  if (!exchange.gather || !exchange.transpose || !exchange.shift)
    fail(RC_ERR_ARGUMENT, "rc_exchange.gather, transpose or shift is null");
  return exchange;
}

rc_system with_rows(const rc_system* given) {
  const rc_system system = read_system(given);
  if (system.nx < 1 || system.ny < 1)
    fail(RC_ERR_SHAPE, "rc_system.nx = ", system.nx, " and rc_system.ny = ", system.ny, " must be >= 1");
  return system;
}

}  // namespace

extern "C" {

rc_status rc_ranks_rows(const rc_exchange* exchange, const rc_system* system, int64_t* first, int64_t* count) {
  return guard("rc_ranks_rows", [&] {
    if (!first || !count) fail(RC_ERR_ARGUMENT, "first or count is null");
    const rc_exchange between = checked(exchange);
    const RowPieces pieces(with_rows(system).ny, between.ranks);
    *first = pieces.first_row(between.rank);
    *count = pieces.first_row(between.rank + 1) - *first;
    return RC_OK;
  });
}

rc_status rc_ranks_contact_create(const rc_exchange* exchange, const rc_system* system, const rc_options* options,
                                  rc_contact** out) {
  return guard("rc_ranks_contact_create", [&] {
    if (out) *out = nullptr;
    const Ranks meeting(with_functions(checked(exchange)), 1);
    std::unique_ptr<rc_contact> made;
    meeting.together([&] {
      if (!out) fail(RC_ERR_ARGUMENT, "out is null");
      const rc_system asked = with_rows(system);
      const rc_options chosen = options_or_defaults(options);
      check_agreement(meeting, facts_of(asked, chosen));
      made = std::make_unique<rc_contact>(std::in_place_type<SharedContact>, meeting, asked, chosen);
    });
    *out = made.release();
    return RC_OK;
  });
}

rc_status rc_ranks_contact_counts(rc_contact* contact, rc_ranks_counts* out) {
  return exclusively("rc_ranks_contact_counts", contact, "contact", [&](const rc_contact& entered) {
    check_size(out, "rc_ranks_counts");
    const auto* const shared = std::get_if<SharedContact>(&entered.contact);
    if (!shared) fail(RC_ERR_INCOMPATIBLE, "no ranks share the contact: rc_contact_create has made it");
    rc_ranks_counts counts = shared->ranks().counts();
    counts.struct_size = sizeof counts;
    write(out, counts);
    return RC_OK;
  });
}

}  // extern "C"
