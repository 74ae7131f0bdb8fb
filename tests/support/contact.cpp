#include "support/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/registry.h"

namespace pairs {

namespace {

void require(rc_status status, const char* call) {
  if (status != RC_OK) throw Failure(std::string(call) + ": " + rc_status_name(status) + ": " + rc_last_error());
}

// Values no answer contains, to show what was written.
Answer blank(std::size_t points) {
  Answer answer;
  answer.p.assign(points, -7);
  answer.gap.assign(points, -7);
  answer.result = RC_RESULT_INIT;
  return answer;
}

template <class Call> void complete(Answer& answer, Call call) {
  answer.result.p.data = answer.p.data();
  answer.result.gap.data = answer.gap.data();
  answer.status = call(&answer.result);
  answer.message = rc_last_error();
  // The answer may be copied: its arrays are p and gap.
  answer.result.p.data = answer.result.gap.data = nullptr;
}

}  // namespace

double Problem::lowest_gap() const {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (included(i)) lowest = std::min(lowest, gap[i]);
  return lowest;
}

rc_step Problem::step() const {
  rc_step step = RC_STEP_INIT;
  step.control = control;
  step.target = target;
  step.undeformed_gap.data = gap.data();
  step.mask.data = mask.empty() ? nullptr : mask.data();
  return step;
}

double Answer::worst_residual() const {
  return std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
}

Options make_options(const Pair& pair, const std::string& kernel, const Settings& settings, rc_context* context) {
  rc_options* made = nullptr;
  require(rc_options_create(context, &made), "rc_options_create");
  Options options(made);
  Settings all = {{RC_OPT_SOLVER, pair.solver}, {RC_OPT_BACKEND, pair.backend}, {RC_OPT_KERNEL, kernel}, {RC_OPT_TOL, "1e-12"}};
  all.insert(all.end(), settings.begin(), settings.end());
  for (const auto& [key, value] : all) require(rc_options_set_text(made, key.c_str(), value.c_str()), "rc_options_set_text");
  return options;
}

Contact::Contact(const Problem& problem, const Pair& pair, const Settings& settings, rc_context* context)
    : points_(problem.points()) {
  Settings all;
  if (may_fail(pair, problem)) all.push_back({"greedy.repair", "1"});
  all.insert(all.end(), settings.begin(), settings.end());
  const Options options = make_options(pair, problem.kernel, all, context);
  rc_contact* made = nullptr;
  require(rc_contact_create(&problem.system, options.get(), &made), "rc_contact_create");
  contact_.reset(made);
}

Answer Contact::solve(const rc_step& step) const {
  Answer answer = blank(points_);
  complete(answer, [&](rc_result* result) { return rc_contact_solve(handle(), &step, result); });
  return answer;
}

Answer Contact::certify(const rc_step& step, const Field& p) const {
  Answer answer = blank(points_);
  answer.p = p;
  complete(answer, [&](rc_result* result) { return rc_contact_certify(handle(), &step, result); });
  return answer;
}

Answer solve(const Problem& problem, const Pair& pair, const Settings& settings) {
  return Contact(problem, pair, settings).solve(problem);
}

Answer solved(const Problem& problem, const Pair& pair, const Settings& settings) {
  Answer answer = solve(problem, pair, settings);
  check_status(answer, RC_OK);
  return answer;
}

void check_status(const Answer& answer, rc_status expected, const std::string& what) {
  check(answer.status == expected,
        what + ": " + rc_status_name(answer.status) + " instead of " + rc_status_name(expected) + "; " + answer.message);
}

Problem at_load(Problem problem, double load) {
  problem.control = RC_CONTROL_LOAD;
  problem.target = load;
  return problem;
}

}  // namespace pairs
