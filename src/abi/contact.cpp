// rc_contact_*, rc_solve
#include <limits>

#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/steps.h"
#include "contact/calls/history.h"

namespace {

using namespace rc;

// This process's contact. Throws for one that ranks share.
Contact& own(rc_contact& handle) {
  if (auto* const contact = std::get_if<Contact>(&handle.contact)) return *contact;
  fail(RC_ERR_INCOMPATIBLE, "ranks share the contact: it has rc_contact_solve, rc_contact_solve_history and rc_contact_certify");
}

template <class Body> rc_status exclusively(const char* where, rc_contact* contact, const Body& body) {
  return rc::exclusively(where, contact, "contact", [&](rc_contact& entered) { return body(own(entered)); });
}

// The same, for functions that a callback of this contact may call.
template <class Body> rc_status exclusively_or_inside(const char* where, rc_contact* contact, const Body& body) {
  if (contact && contact->entrance.inside()) return guard(where, [&] { return body(own(*contact)); });
  return exclusively(where, contact, body);
}

// The same, for functions that contacts shared by ranks have too.
template <class Body> rc_status exclusively_any(const char* where, rc_contact* contact, const Body& body) {
  return rc::exclusively(where, contact, "contact", [&](rc_contact& entered) { return std::visit(body, entered.contact); });
}

const Ranks* ranks_of(const Contact&) { return nullptr; }
const Ranks* ranks_of(const SharedContact& contact) { return &contact.ranks(); }

// Ranks gather the arrays, or give them to operators on rows.
void check_hosts(const rc_step& step, const rc_result& result) {
  check_host_array(step.undeformed_gap, "rc_step.undeformed_gap", Types::floats);
  check_host_array(step.mask, "rc_step.mask");
  check_host_array(step.p0, "rc_step.p0", Types::floats);
  check_host_array(result.p, "rc_result.p", Types::floats);
  check_host_array(result.gap, "rc_result.gap", Types::floats);
}

template <class Any, class Body> rc_status with_step(Any& contact, const rc_step* step, rc_result* result, const Body& body) {
  const Ranks* const ranks = ranks_of(contact);
  rc_step asked = RC_STEP_INIT;
  rc_result answer = RC_RESULT_INIT;
  on_all(ranks, [&] {
    asked = read_step(step);
    answer = read_result(result);
    if (ranks) check_hosts(asked, answer);
  });
  const Numbers numbers = body(contact, asked, outputs_of(answer));
  write(numbers, contact.system(), answer);
  write(result, answer);
  return numbers.status;
}

rc_status solved(Contact& contact, const rc_history& asked, rc_history& history) {
  return solve_history(contact, asked, wants_of(asked), history.completed);
}
rc_status solved(SharedContact& contact, const rc_history& asked, rc_history& history) {
  return contact.solve_history(asked, history.completed);
}

}  // namespace

extern "C" {

rc_status rc_contact_create(const rc_system* system, const rc_options* options, rc_contact** out) {
  return guard("rc_contact_create", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    *out = new rc_contact(std::in_place_type<Contact>, read_system(system), options_or_defaults(options));
    return RC_OK;
  });
}

void rc_contact_destroy(rc_contact* contact) {
  const HostsCall call;
  delete contact;
}

rc_status rc_contact_set_options(rc_contact* contact, const rc_options* options) {
  return exclusively("rc_contact_set_options", contact, [&](Contact& c) {
    if (!options) fail(RC_ERR_ARGUMENT, "options is null");
    c.set_options(*options);
    return RC_OK;
  });
}

rc_status rc_contact_on_progress(rc_contact* contact, rc_progress_fn fn, void* user, int64_t every) {
  return exclusively("rc_contact_on_progress", contact, [&](Contact& c) {
    if (every < 1) fail(RC_ERR_ARGUMENT, "every = ", every, " must be >= 1");
    c.watcher().progress = {fn, user, every};
    return RC_OK;
  });
}

rc_status rc_contact_solve(rc_contact* contact, const rc_step* step, rc_result* result) {
  return exclusively_any("rc_contact_solve", contact, [&](auto& c) {
    return with_step(c, step, result,
                     [](auto& each, const rc_step& s, const Outputs& outputs) { return each.solve(s, outputs); });
  });
}

rc_status rc_contact_certify(rc_contact* contact, const rc_step* step, rc_result* result) {
  return exclusively_any("rc_contact_certify", contact, [&](auto& c) {
    return with_step(c, step, result,
                     [](auto& each, const rc_step& s, const Outputs& outputs) { return each.certify(s, outputs); });
  });
}

rc_status rc_contact_solve_history(rc_contact* contact, rc_history* path) {
  return exclusively_any("rc_contact_solve_history", contact, [&](auto& c) {
    rc_history asked = RC_HISTORY_INIT;
    on_all(ranks_of(c), [&] { asked = read_history(path); });
    return solved(c, asked, *path);
  });
}

rc_status rc_contact_level(rc_contact* contact, int64_t i, rc_level* out) {
  return exclusively("rc_contact_level", contact, [&](Contact& c) {
    rc_level level = read<rc_level>(out, "rc_level", RC_LEVEL_INIT);
    check_host_array(level.p, "rc_level.p");
    c.grid().grids().describe(i, level);
    level.approach *= c.problem().compliance;
    write(out, level);
    return RC_OK;
  });
}

rc_status rc_contact_points(rc_contact* contact, int64_t room, rc_array index, rc_array p, int64_t* n) {
  return exclusively_or_inside("rc_contact_points", contact, [&](const Contact& c) {
    if (!n) fail(RC_ERR_ARGUMENT, "n is null");
    if (room < 0) fail(RC_ERR_ARGUMENT, "room = ", room, " must be >= 0");
    *n = c.grid().memory().contact_points(room, host_values<std::int64_t>(index, "index"), host_values<double>(p, "p"));
    return RC_OK;
  });
}

rc_status rc_contact_explain(rc_contact* contact, const char** out) {
  return exclusively("rc_contact_explain", contact, [&](Contact& c) {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    const StepOutcome& last = c.grid().memory().outcome;
    contact->explanation = explained(c.problem().options, c.problem().system, last.choice, last.failed);
    *out = contact->explanation.c_str();
    return RC_OK;
  });
}

rc_status rc_contact_gradient(rc_contact* contact, rc_gradient* gradient) {
  return exclusively("rc_contact_gradient", contact, [&](Contact& c) {
    rc_gradient asked = read<rc_gradient>(gradient, "rc_gradient", RC_GRADIENT_INIT);
    check_host_array(asked.dJ_dp, "rc_gradient.dJ_dp");
    check_host_array(asked.dJ_dgap, "rc_gradient.dJ_dgap");
    check_host_array(asked.dJ_dundeformed_gap, "rc_gradient.dJ_dundeformed_gap");
    const rc_status status = c.gradient(asked);
    if (status == RC_OK || status == RC_STOP_STALLED) write(gradient, asked);
    return status;
  });
}

rc_status rc_contact_tangent(rc_contact* contact, rc_tangent* tangent) {
  return exclusively("rc_contact_tangent", contact, [&](Contact& c) {
    rc_tangent asked = read<rc_tangent>(tangent, "rc_tangent", RC_TANGENT_INIT);
    check_host_array(asked.dundeformed_gap, "rc_tangent.dundeformed_gap");
    check_host_array(asked.dp, "rc_tangent.dp");
    check_host_array(asked.dgap, "rc_tangent.dgap");
    const rc_status status = c.tangent(asked);
    if (status == RC_OK || status == RC_STOP_STALLED) write(tangent, asked);
    return status;
  });
}

rc_status rc_contact_reset(rc_contact* contact) {
  return exclusively("rc_contact_reset", contact, [&](Contact& c) {
    c.forget(Forgotten::grids);
    return RC_OK;
  });
}

rc_status rc_contact_indentation(rc_contact* contact, rc_array indentation) {
  return exclusively("rc_contact_indentation", contact, [&](Contact& c) {
    double* const to = host_values<double>(indentation, "indentation");
    if (!to) fail(RC_ERR_ARGUMENT, "indentation is null");
    c.grid().write_indentation({to, static_cast<std::size_t>(c.problem().system.points())});
    return RC_OK;
  });
}

rc_status rc_contact_creep(rc_contact* contact, rc_array creep, double* time) {
  return exclusively("rc_contact_creep", contact, [&](Contact& c) {
    double* const to = host_values<double>(creep, "creep");
    const Creep& left = c.grid().creep();
    if (!to) fail(RC_ERR_ARGUMENT, "creep is null");
    if (left.none()) fail(RC_ERR_ARGUMENT, "the contact's bodies do not creep: rc_system.creep_terms is 0");
    const System& system = c.system();
    left.write({to, (system.creep.size() + 1) * static_cast<std::size_t>(system.points())}, c.problem().team());
    if (time) *time = left.empty() ? std::numeric_limits<double>::quiet_NaN() : left.time();
    return RC_OK;
  });
}

rc_status rc_contact_restore(rc_contact* contact, const rc_state* state) {
  return exclusively("rc_contact_restore", contact, [&](Contact& c) {
    const rc_state given = read<rc_state>(state, "rc_state", RC_STATE_INIT);
    check_host_arrays<rc_const_array>({{"rc_state.undeformed_gap", given.undeformed_gap},
                                       {"rc_state.mask", given.mask},
                                       {"rc_state.p", given.p},
                                       {"rc_state.p_before", given.p_before},
                                       {"rc_state.indentation", given.indentation},
                                       {"rc_state.creep", given.creep}});
    c.restore(given);
    return RC_OK;
  });
}

void rc_contact_cancel(rc_contact* contact) {
  if (contact) std::visit([](auto& each) { each.watcher().cancel(); }, contact->contact);
}

rc_status rc_solve(const rc_system* system, const rc_step* step, const rc_options* options, rc_result* result) {
  return guard("rc_solve", [&] {
    Contact contact(read_system(system), options_or_defaults(options));
    return with_step(contact, step, result, [](Contact& each, rc_step s, const Outputs& outputs) {
      s.borrow = 1;  // the arrays outlive the contact
      return each.solve(s, outputs);
    });
  });
}

}  // extern "C"
