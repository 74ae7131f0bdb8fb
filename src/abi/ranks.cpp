// rc_ranks_*
#include "core/ranks.h"

#include <memory>

#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/steps.h"
#include "contact/calls/agreement.h"
#include "contact/calls/shared_contact.h"

struct rc_ranks_contact {
  rc::SharedContact contact;
};

namespace {

using namespace rc;

rc_exchange checked(const rc_exchange* given) {
  const rc_exchange exchange = read<rc_exchange>(given, "rc_exchange", RC_EXCHANGE_INIT);
  if (exchange.refused) fail(RC_ERR_ARGUMENT, exchange.refused);
  if (exchange.ranks < 1 || exchange.rank < 0 || exchange.rank >= exchange.ranks)
    fail(RC_ERR_ARGUMENT, "rc_exchange.rank = ", exchange.rank, " of rc_exchange.ranks = ", exchange.ranks,
         " must be 0 .. ranks - 1");
  if (!exchange.gather || !exchange.transpose || !exchange.shift)
    fail(RC_ERR_ARGUMENT, "rc_exchange.gather, transpose or shift is null");
  return exchange;
}

rc_system with_rows(const rc_system* given) {
  const rc_system system = read<rc_system>(given, "rc_system", RC_SYSTEM_INIT);
  if (system.nx < 1 || system.ny < 1)
    fail(RC_ERR_SHAPE, "rc_system.nx = ", system.nx, " and rc_system.ny = ", system.ny, " must be >= 1");
  return system;
}

template <class Body> rc_status with_contact(const char* where, rc_ranks_contact* contact, const Body& body) {
  return guard(where, [&] {
    if (!contact) fail(RC_ERR_ARGUMENT, "contact is null");
    return body(contact->contact);
  });
}

template <class Body>
rc_status with_step(const char* where, rc_ranks_contact* contact, const rc_step* step, rc_result* result, const Body& body) {
  return with_contact(where, contact, [&](SharedContact& c) {
    rc_step asked = RC_STEP_INIT;
    rc_result answer = RC_RESULT_INIT;
    on_all(&c.ranks(), [&] {
      asked = read_step(step);
      answer = read_result(result);
      check_host_array(asked.undeformed_gap, "rc_step.undeformed_gap", Types::floats);
      check_host_array(asked.mask, "rc_step.mask");
      check_host_array(asked.p0, "rc_step.p0", Types::floats);
      check_host_array(answer.p, "rc_result.p", Types::floats);
      check_host_array(answer.gap, "rc_result.gap", Types::floats);
    });
    const Numbers numbers = body(c, asked, outputs_of(answer));
    write(numbers, c.system(), answer);
    write(result, answer);
    return numbers.status;
  });
}

}  // namespace

extern "C" {

rc_status rc_ranks_rows(int64_t rank, int64_t ranks, const rc_system* system, int64_t* first, int64_t* count) {
  return guard("rc_ranks_rows", [&] {
    if (!first || !count) fail(RC_ERR_ARGUMENT, "first or count is null");
    if (ranks < 1 || rank < 0 || rank >= ranks)
      fail(RC_ERR_ARGUMENT, "rank = ", rank, " of ranks = ", ranks, " must be 0 .. ranks - 1");
    const RowPieces pieces(with_rows(system).ny, ranks);
    *first = pieces.first_row(rank);
    *count = pieces.first_row(rank + 1) - *first;
    return RC_OK;
  });
}

rc_status rc_ranks_contact_create(const rc_exchange* exchange, const rc_system* system, const rc_options* options,
                                  rc_ranks_contact** out) {
  return guard("rc_ranks_contact_create", [&] {
    if (out) *out = nullptr;
    const Ranks meeting(checked(exchange), 1);
    std::unique_ptr<rc_ranks_contact> made;
    meeting.together([&] {
      if (!out) fail(RC_ERR_ARGUMENT, "out is null");
      const rc_system asked = with_rows(system);
      const rc_options chosen = options ? *options : rc_options{Context::standard(), {}};
      check_agreement(meeting, facts_of(asked, chosen));
      made.reset(new rc_ranks_contact{{meeting, asked, chosen}});
    });
    *out = made.release();
    return RC_OK;
  });
}

void rc_ranks_contact_destroy(rc_ranks_contact* contact) {
  const HostsCall call;
  delete contact;
}

rc_status rc_ranks_contact_solve(rc_ranks_contact* contact, const rc_step* step, rc_result* result) {
  return with_step("rc_ranks_contact_solve", contact, step, result,
                   [](SharedContact& c, const rc_step& s, const Outputs& outputs) { return c.solve(s, outputs); });
}

rc_status rc_ranks_contact_solve_history(rc_ranks_contact* contact, rc_history* path) {
  return with_contact("rc_ranks_contact_solve_history", contact, [&](SharedContact& c) {
    rc_history asked = RC_HISTORY_INIT;
    on_all(&c.ranks(), [&] { asked = read_history(path); });
    return c.solve_history(asked, path->completed);
  });
}

rc_status rc_ranks_contact_certify(rc_ranks_contact* contact, const rc_step* step, rc_result* result) {
  return with_step("rc_ranks_contact_certify", contact, step, result,
                   [](SharedContact& c, const rc_step& s, const Outputs& outputs) { return c.certify(s, outputs); });
}

rc_status rc_ranks_contact_counts(rc_ranks_contact* contact, rc_ranks_counts* out) {
  return with_contact("rc_ranks_contact_counts", contact, [&](SharedContact& c) {
    check_size(out, "rc_ranks_counts");
    rc_ranks_counts counts = c.ranks().counts();
    counts.struct_size = sizeof counts;
    write(out, counts);
    return RC_OK;
  });
}

}  // extern "C"
