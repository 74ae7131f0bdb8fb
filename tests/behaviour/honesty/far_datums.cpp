// Gaps far from zero: answers do not depend on the datum of the heights, except for the digits that the approach has.
#include <algorithm>
#include <cmath>

#include "honesty_tests.h"
#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double epsilon = 2.220446049250313e-16;

std::vector<Pair> some_pairs() {
  std::vector<Pair> pairs;
  for (const std::string& solver : solver_names())
    if (solver != "greedy") pairs.push_back({solver, solver == "nnls" ? "dense" : "fft"});
  return pairs;
}

// The same surface from its lowest gap on, so that the given numbers are the same to the last bit.
void check_offset(Problem problem, double offset, const Settings& settings, double allowed) {
  for (double& h : problem.gap) h += offset;
  Problem from_zero = problem;
  for (double& h : from_zero.gap) h -= problem.lowest_gap();
  for (const Pair& pair : some_pairs()) {
    const Answer far = solved(problem, pair, settings), near = solved(from_zero, pair, settings);
    const std::string what = pair.name() + ", gaps from " + text(problem.lowest_gap());
    check_near(far.p, near.p, allowed * largest(near.p), what);
    check_near(far.result.approach, problem.lowest_gap() + near.result.approach,
               2 * epsilon * std::abs(problem.lowest_gap()) + allowed * near.result.approach, what);
    check(far.result.load_lower <= problem.target * (1 + allowed) && problem.target * (1 - allowed) <= far.result.load_upper,
          what + ": the interval is " + text(far.result.load_lower) + " to " + text(far.result.load_upper));
  }
}

// A compression of 1e-9 above a lowest gap of 0.5: the approach itself is known to 5e-8 of it.
void a_light_load_far_from_zero() {
  for (const double offset : {0.5, 3e3}) {
    Problem problem = rough_problem(16, 16);
    for (double& h : problem.gap) h *= 1e-3;
    check_offset(at_load(problem, 1e-9), offset, {{RC_OPT_TOL, "1e-8"}}, 1e-6);
  }
}

void heights_far_from_zero() {
  const Problem problem = rough_problem(24, 20);
  for (const double offset : {1e6, -1e6}) check_offset(at_load(problem, 5), offset, {{RC_OPT_TOL, "1e-10"}}, 1e-7);
}

void periodic_heights_far_from_zero() {
  const Problem problem = rough_problem(24, 20, RC_BOUNDARY_PERIODIC);
  check_offset(at_load(problem, 5), 1e6, {{RC_OPT_TOL, "1e-10"}}, 1e-7);
}

// Few of many points in contact, where a backend screens the others.
void few_contacts_far_from_zero() {
  Problem problem;
  const std::int64_t side = 640;
  problem.system.nx = problem.system.ny = side;
  problem.gap = paraboloid(side, side, 1, 301, 299, 50);
  problem = at_load(problem, 1e-3);
  for (double& h : problem.gap) h += 1e3;
  const Answer answer = solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
  check(answer.result.contacts > 0 && answer.result.contacts < 100, "contacts: " + text(answer.result.contacts));
}

// Approach control takes the approach as it is given.
void given_approaches_far_from_zero() {
  Problem problem = rough_problem(24, 20);
  problem.target += 1e6;
  for (double& h : problem.gap) h += 1e6;
  for (const Pair& pair : some_pairs()) {
    const Answer answer = solved(problem, pair, {{RC_OPT_TOL, "1e-10"}});
    check(answer.result.approach == problem.target, pair.name() + ": another approach");
  }
}

}  // namespace

std::vector<Test> far_datums() {
  return RC_TESTS(a_light_load_far_from_zero, heights_far_from_zero, periodic_heights_far_from_zero, few_contacts_far_from_zero,
                  given_approaches_far_from_zero);
}

}  // namespace pairs
