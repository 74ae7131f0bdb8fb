// Tables, times and calls that are refused, with the message.
#include <roughcontact/derivatives.h>
#include <roughcontact/law.h>

#include <functional>

#include "creep.h"

namespace pairs {

void bad_tables_are_refused() {
  const auto refused = [](const Table& table, const char* named) {
    const Problem problem = creeping(rough_problem(8, 8), table);
    rc_contact* contact = nullptr;
    check(rc_contact_create(&problem.system, nullptr, &contact) == RC_ERR_ARGUMENT && !contact, named);
    check(std::string(rc_last_error()).find(named) != std::string::npos, rc_last_error());
  };
  refused({{-1}, {1}}, "creep_ratio[0] = -1");
  refused({{1, nan}, {1, 1}}, "creep_ratio[1]");
  refused({{1}, {0}}, "creep_time[0] = 0");
  refused({{1, 1}, {1, -2}}, "creep_time[1] = -2");
  refused({{1}, {HUGE_VAL}}, "creep_time[0]");
  refused({{0.5, 0.5}, {1, 2}, RC_CREEP_MODULI}, "relax to 0");
  refused({{1}, {1}, 2}, "creep_by = 2");
  Problem problem = creeping(rough_problem(8, 8), one);
  rc_contact* contact = nullptr;
  problem.system.creep_terms = -1;
  check(rc_contact_create(&problem.system, nullptr, &contact) == RC_ERR_ARGUMENT, "a negative number of terms");
  problem.system.creep_terms = 1001;
  check(rc_contact_create(&problem.system, nullptr, &contact) == RC_ERR_ARGUMENT, "more terms than there may be");
  problem.system.creep_terms = 1;
  problem.system.creep_time.data = nullptr;
  check(rc_contact_create(&problem.system, nullptr, &contact) == RC_ERR_ARGUMENT, "no times");
}

void bad_calls_are_refused() {
  const Problem elastic = rough_problem(12, 10), problem = creeping(elastic, one);
  const Contact contact(problem, automatic), without(elastic, automatic);
  const auto refused = [](rc_status status, rc_status expected, const char* named) {
    check_equal(status, expected, named);
    check(std::string(rc_last_error()).find(named) != std::string::npos, rc_last_error());
  };
  Field targets(2, problem.target), loads(2, -7);
  Field back{2, 1}, endless{1, HUGE_VAL};
  rc_history history = history_of(problem, targets, back, loads);
  refused(rc_contact_solve_history(contact.handle(), &history), RC_ERR_ARGUMENT, "rc_history.times[1] = 1");
  history.times = RC_IN(endless.data());
  refused(rc_contact_solve_history(contact.handle(), &history), RC_ERR_ARGUMENT, "rc_history.times[1]");
  history.times = {};
  refused(rc_contact_solve_history(contact.handle(), &history), RC_ERR_ARGUMENT, "rc_history.times is null");
  check_same(loads, Field(2, -7), "nothing is written");

  const Answer answer = contact.solve(at(problem, {1, problem.target}));
  const Field creep = creep_of(contact, 2 * problem.points());
  rc_state state = state_of(problem, answer, creep, 1);
  refused(rc_contact_restore(without.handle(), &state), RC_ERR_ARGUMENT, "rc_state.creep is given");
  state.creep = {};
  refused(rc_contact_restore(contact.handle(), &state), RC_ERR_ARGUMENT, "rc_state.creep is null");
  Field spoiled = creep;
  spoiled[7] = nan;
  state = state_of(problem, answer, spoiled, 1);
  refused(rc_contact_restore(contact.handle(), &state), RC_ERR_ARGUMENT, "rc_state.creep[7]");
  state = state_of(problem, answer, creep, HUGE_VAL);
  refused(rc_contact_restore(contact.handle(), &state), RC_ERR_ARGUMENT, "rc_state.time");
  check_same(creep_of(contact, 2 * problem.points()), creep, "after refused restores");
  Field out(problem.points());
  refused(rc_contact_creep(without.handle(), RC_OUT(out.data()), nullptr), RC_ERR_ARGUMENT, "do not creep");
  refused(rc_contact_creep(contact.handle(), RC_OUT(nullptr), nullptr), RC_ERR_ARGUMENT, "creep is null");

  rc_gradient gradient = RC_GRADIENT_INIT;
  refused(rc_contact_gradient(contact.handle(), &gradient), RC_ERR_INCOMPATIBLE, "rc_system.creep_terms");
  rc_tangent tangent = RC_TANGENT_INIT;
  refused(rc_contact_tangent(contact.handle(), &tangent), RC_ERR_INCOMPATIBLE, "rc_system.creep_terms");
  rc_law* law = nullptr;
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  spec.undeformed_gap = RC_IN(problem.gap.data());
  refused(rc_law_create(&problem.system, nullptr, &spec, &law), RC_ERR_INCOMPATIBLE, "rc_system.creep_terms");
}

}  // namespace pairs
