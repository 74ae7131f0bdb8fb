// Block pivoting never cycles: random problems with ties, without scale, near singular, each checked without the library. There
// are a few thousand; the environment variable RC_TEST_PROBLEMS sets another number.
#include <algorithm>
#include <cstdlib>
#include <map>

#include "random_problems.h"
#include "support/contact.h"
#include "support/reference_cases.h"

namespace pairs {

namespace {

using pivoting::RandomProblem;

constexpr double tol = 1e-9;
constexpr std::int64_t most_solves_of_a_case = 10, most_solves = 150;

std::uint64_t number_of_problems() {
  const char* value = std::getenv("RC_TEST_PROBLEMS");
  if (value && *value) return std::strtoull(value, nullptr, 10);
  return quick() ? 500 : 4000;
}

Problem as_problem(const RandomProblem& given) {
  Problem problem;
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.nx = given.n;
  problem.system.ny = 1;
  problem.system.dense = given.matrix.data();
  problem.system.dense_ld = given.n;
  problem.gap = given.u;
  for (double& value : problem.gap) value = -value;
  return problem;
}

// The energy norm of p - q bounds what the two disagree about: it is what H can see of it.
double distance(const RandomProblem& given, const Field& p, const Field& q) {
  const auto n = static_cast<std::size_t>(given.n);
  double seen = 0, size = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      seen += (p[i] - q[i]) * given.matrix[i * n + j] * (p[j] - q[j]);
      size += q[i] * given.matrix[i * n + j] * q[j];
    }
  return size > 0 ? std::sqrt(std::max(seen, 0.0) / size) : largest(p);
}

struct Tally {
  std::int64_t solved = 0, enumerated = 0, constructed = 0, by_single_pivots = 0;
  std::map<std::int64_t, std::int64_t> solves;
  double worst = 0;
};

void solve_and_judge(std::uint64_t number, Tally& tally) {
  const RandomProblem given = pivoting::make_problem(number);
  const std::string which = "problem " + std::to_string(number) + " (" + given.kind + ", n = " + std::to_string(given.n) + ")";
  const Problem problem = as_problem(given);
  const Settings settings = {{RC_OPT_TOL, text(tol)}};
  const Answer answer = solve(problem, {"nnls", "dense"}, settings);
  check_status(answer, RC_OK, which);
  const pivoting::Violation violation = pivoting::violation(given, answer.p);
  const double worst = std::max({violation.tension, violation.overlap, violation.complementarity});
  check(worst <= 1.01 * tol, which + ": violates its conditions by " + text(worst));
  tally.worst = std::max(tally.worst, worst);
  ++tally.solved;
  ++tally.solves[answer.result.iterations];
  check(answer.result.iterations <= most_solves, which + ": " + std::to_string(answer.result.iterations) + " solves");
  if (given.solution) {
    ++tally.constructed;
    check_near(distance(given, answer.p, *given.solution), 0, 1e-4, which + ", distance from the solution it was made of");
  }
  if (const auto enumerated = pivoting::solution_by_enumeration(given)) {
    ++tally.enumerated;
    check_near(distance(given, answer.p, *enumerated), 0, 1e-4, which + ", distance from the solution by enumeration");
  }
  if (number % 10 == 0) {
    ++tally.by_single_pivots;
    const Answer single = solve(problem, {"nnls", "dense"}, {{RC_OPT_TOL, text(tol)}, {"nnls.pivoting", "single"}});
    check_status(single, RC_OK, which + ", by single pivots");
    check_near(distance(given, single.p, answer.p), 0, 1e-4, which + ", distance from single pivots");
  }
}

void random_problems_end() {
  Tally tally;
  const std::uint64_t count = number_of_problems();
  for (std::uint64_t number = 1; number <= count; ++number) solve_and_judge(number, tally);
  report(std::to_string(tally.solved) + " problems certified; checked by their construction " +
         std::to_string(tally.constructed) + ", by enumeration " + std::to_string(tally.enumerated) + ", by single pivots " +
         std::to_string(tally.by_single_pivots) + "; worst violation " + text(tally.worst));
  std::string histogram = "solves: problems";
  for (const auto& [solves, problems] : tally.solves)
    histogram += "  " + std::to_string(solves) + ": " + std::to_string(problems);
  report(histogram);
}

void a_few_solves(const ReferenceCase& reference) {
  if (quick() && reference.candidates > 1024) throw Skipped("left out of the reduced set");
  const Answer answer = solved(reference.problem, {"nnls", "dense"});
  check(answer.result.iterations <= most_solves_of_a_case, std::to_string(answer.result.iterations) + " solves");
  report(std::to_string(reference.candidates) + " candidates, " + std::to_string(answer.result.iterations) + " solves");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = {{"block_pivoting_never_cycles_and_is_right", random_problems_end}};
  const auto reference = read_reference_cases();
  for (const ReferenceCase& each : reference.cases)
    tests.push_back({"cold_start_needs_at_most_10_solves/" + each.name, [&each] { a_few_solves(each); }});
  return run_group("solvers.pivoting", tests, argc, argv);
}
