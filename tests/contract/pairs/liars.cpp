// Solvers of a plugin that claim success with wrong pressures. An honest one beside them shows that they are called correctly.
#include <algorithm>
#include <cmath>
#include <limits>

#include "certificate_tests.h"
#include "support/contact.h"
#include "support/plugins.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();

// A lie: the pressure of every point, or as a share of the load; that of the first point; the approach; the status.
struct Lie {
  const char* name;
  double p, first, approach;
  rc_status status;
  bool by_load;
};
constexpr Lie lies[] = {
    {"no-pressure", 0, 0, 0, RC_OK, false},
    {"uniform-pressure", 1, 1, 1, RC_OK, true},
    {"tension", -1, -1, 0, RC_OK, false},
    {"not-a-number", none, none, none, RC_OK, true},
    {"infinity", 0, endless, 0, RC_OK, false},
    {"nonsense-status", 0, 0, 0, 4711, false},
    {"failure-without-words", 0, 0, 0, RC_ERR_NUMERIC, false},
};

template <std::size_t which> rc_status tell(const rc_host*, const rc_problem* problem, const rc_options*, double* p, double* d) {
  constexpr Lie lie = lies[which];
  const bool by_load = problem->control == RC_CONTROL_LOAD;
  std::fill_n(p, problem->n, lie.p * (by_load ? problem->load : 1) / static_cast<double>(lie.by_load ? problem->n : 1));
  if (lie.first != lie.p) p[0] = lie.first;
  if (by_load) *d = lie.approach;
  return lie.status;
}

rc_status by_pivoting(const rc_host*, const rc_problem* problem, const rc_options*, double* p, double*) {
  return support::inner_solve(problem, "nnls", p);
}

template <std::size_t which>
const rc_solver liar = support::solver(lies[which].name, tell<which>,
                                       RC_CONTROL_APPROACH | (lies[which].by_load ? std::uint32_t{RC_CONTROL_LOAD} : 0));
const rc_solver honest = support::solver("by-pivoting", by_pivoting);
const rc_solver* const list[] = {&liar<0>, &liar<1>, &liar<2>, &liar<3>, &liar<4>, &liar<5>, &liar<6>, &honest};
static_assert(std::size(list) == std::size(lies) + 1);

Context make_context() {
  rc_context* made = nullptr;
  check(rc_context_create(0, nullptr, nullptr, nullptr, &made) == RC_OK, rc_last_error());
  Context context(made);
  for (const rc_solver* each : list) check(support::add(made, *each) == RC_OK, rc_last_error());
  return context;
}

const Settings settings = {{RC_OPT_TOL, "1e-9"}, {RC_OPT_MAX_ITER, "200000"}};

Answer answer_of(const std::string& name, const Problem& problem) {
  const Context context = make_context();
  return Contact(problem, {name, "dense"}, settings, context.get()).solve(problem);
}

Problem problem_at(std::int32_t control) {
  const Problem problem = rough_problem(8, 6);
  return control == RC_CONTROL_LOAD ? at_load(problem, 3) : problem;
}

void honest_solver_is_certified() {
  const Problem problem = problem_at(RC_CONTROL_APPROACH);
  const Answer answer = answer_of("by-pivoting", problem);
  check_status(answer, RC_OK);
  check_near(answer.p, solved(problem, automatic).p, 1e-7, "p");
}

void lie_is_uncertified(const std::string& name, std::int32_t control) {
  const Problem problem = problem_at(control);
  const Answer answer = answer_of(name, problem);
  check_status(answer, RC_UNCERTIFIED);
  check(!answer.message.empty(), "the message is empty");
  check(!(answer.worst_residual() <= 1e-9), "the residuals hide the lie");
}

// Where there is nothing to certify a failure is as good, but never RC_OK.
void garbage_is_not_certified(const std::string& name, std::int32_t control) {
  const Answer answer = answer_of(name, problem_at(control));
  check(answer.status == RC_UNCERTIFIED || answer.status == RC_STOP_STALLED || answer.status == RC_ERR_NUMERIC ||
            answer.status == RC_ERR_INTERNAL,
        std::string("status ") + rc_status_name(answer.status) + " (" + std::to_string(answer.status) + ")");
  check(!answer.message.empty(), "the message is empty");
}

void lie_is_not_the_next_start() {
  const Context context = make_context();
  const Problem problem = problem_at(RC_CONTROL_APPROACH);
  const Contact contact(problem, {"uniform-pressure", "dense"}, settings, context.get());
  check_status(contact.solve(problem), RC_UNCERTIFIED);
  const Options honest = make_options({"by-pivoting", "dense"}, problem.kernel, settings, context.get());
  check(rc_contact_set_options(contact.handle(), honest.get()) == RC_OK, rc_last_error());
  const Answer warm = contact.solve(problem), cold = answer_of("by-pivoting", problem);
  check_same(warm.p, cold.p, "p after a lie and p of a fresh contact");
}

}  // namespace

std::vector<Test> tests_of_liars() {
  std::vector<Test> tests = {{"an_honest_solver_from_outside_is_certified", honest_solver_is_certified},
                             {"a_lie_is_not_the_next_warm_start", lie_is_not_the_next_start}};
  for (const char* name : {"no-pressure", "uniform-pressure", "tension"})
    tests.push_back(
        {std::string("a_lying_solver_is_uncertified/approach/") + name, [=] { lie_is_uncertified(name, RC_CONTROL_APPROACH); }});
  tests.push_back(
      {"a_lying_solver_is_uncertified/load/uniform-pressure", [] { lie_is_uncertified("uniform-pressure", RC_CONTROL_LOAD); }});
  for (const char* name : {"no-pressure", "tension"})
    tests.push_back(
        {std::string("garbage_is_not_certified/load/") + name, [=] { garbage_is_not_certified(name, RC_CONTROL_LOAD); }});
  for (const char* name : {"not-a-number", "infinity", "nonsense-status", "failure-without-words"})
    for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD})
      tests.push_back({std::string("garbage_is_not_certified/") + (control == RC_CONTROL_LOAD ? "load/" : "approach/") + name,
                       [=] { garbage_is_not_certified(name, control); }});
  return tests;
}

}  // namespace pairs
