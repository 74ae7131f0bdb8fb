// Block pivoting from a cold start takes a few solves, and does not cycle where points have neither pressure nor gap.
#include "scenes/matrices.h"
#include "support/contact.h"
#include "support/naive.h"
#include "support/reference_cases.h"

namespace pairs {

namespace {

constexpr std::int64_t most_solves = 10;

void a_few_solves(const ReferenceCase& reference) {
  if (quick() && reference.candidates > 1024) throw Skipped("left out of the reduced set");
  const Answer answer = solved(reference.problem, {"nnls", "dense"});
  check(answer.result.iterations <= most_solves, std::to_string(answer.result.iterations) + " solves");
  report(std::to_string(reference.candidates) + " candidates, " + std::to_string(answer.result.iterations) + " solves");
}

// Whole numbers, whose ties are exact, or the scenes' matrices; a third of the points have pressure, a third a gap, a third
// neither.
void ties_do_not_cycle() {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    scenes::Random random(seed, 1);
    const bool whole = random.chance(0.5);
    const auto n = static_cast<std::size_t>(random.between(1, 40));
    Field factor(n * n), matrix = whole ? Field(n * n) : scenes::random_matrix(n, random), p(n), w(n);
    for (double& value : factor) value = static_cast<double>(random.between(-2, 2));
    for (std::size_t i = 0; whole && i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        matrix[i * n + j] = i == j ? 1 : 0;
        for (std::size_t k = 0; k < n; ++k) matrix[i * n + j] += factor[i * n + k] * factor[j * n + k];
      }
    for (std::size_t i = 0; i < n; ++i) {
      const std::int64_t role = random.below(3);
      const double value = whole ? static_cast<double>(random.between(1, 4)) : random.uniform(0.05, 1.05);
      (role == 0 ? p : w)[i] = role == 2 ? 0 : value;
    }
    Problem problem;
    problem.system.op = RC_OPERATOR_DENSE;
    problem.system.nx = static_cast<std::int64_t>(n);
    problem.system.ny = 1;
    problem.system.dense = matrix.data();
    problem.system.dense_ld = static_cast<std::int64_t>(n);
    problem.gap = product(matrix, p);
    for (std::size_t i = 0; i < n; ++i) problem.gap[i] = w[i] - problem.gap[i];
    for (const char* pivoting : {"block", "single"}) {
      const std::string which = "seed " + std::to_string(seed) + ", " + pivoting;
      const Answer answer = solve(problem, {"nnls", "dense"}, {{RC_OPT_TOL, "1e-9"}, {"nnls.pivoting", pivoting}});
      check_status(answer, RC_OK, which);
      check(answer.result.iterations <= 150, which + ": " + std::to_string(answer.result.iterations) + " solves");
      Field off = p;
      for (std::size_t i = 0; i < n; ++i) off[i] -= answer.p[i];
      const Field seen = product(matrix, off), all = product(matrix, p);
      double error = 0, size = 0;
      for (std::size_t i = 0; i < n; ++i) error += off[i] * seen[i], size += p[i] * all[i];
      check(error <= 1e-8 * size + 1e-300, which + ": another solution");
    }
  }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = {{"ties_do_not_cycle", ties_do_not_cycle}};
  const auto reference = read_reference_cases();
  for (const ReferenceCase& each : reference.cases)
    tests.push_back({"cold_start_needs_at_most_10_solves/" + each.name, [&each] { a_few_solves(each); }});
  return run_group("solvers.pivoting", tests, argc, argv);
}
