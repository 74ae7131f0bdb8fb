// Block pivoting from a cold start takes a few solves, and does not cycle where points have neither pressure nor gap.
#include "scenes/random.h"
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

// F F' + ridge I, with whole numbers, whose ties are exact, or next to singular; a third of the points have pressure, a third a
// gap, a third neither.
void ties_do_not_cycle() {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    scenes::Random random(seed, 1);
    const bool whole = random.chance(0.7);
    const auto n = static_cast<std::size_t>(random.between(1, 40)), rank = whole ? n : (n + 1) / 2;
    Field factor(n * rank), matrix(n * n), p(n), w(n);
    for (double& value : factor) value = whole ? static_cast<double>(random.between(-2, 2)) : random.uniform(-1, 1);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        matrix[i * n + j] = i == j ? (whole ? 1 : 1e-8) : 0;
        for (std::size_t k = 0; k < rank; ++k) matrix[i * n + j] += factor[i * rank + k] * factor[j * rank + k];
      }
    if (seed % 5 == 0)  // an M-matrix: no entry beside the diagonal is positive
      for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] = 0;
    for (std::size_t i = 0; seed % 5 == 0 && i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double value = random.chance(0.5) ? 0 : random.uniform();
        matrix[i * n + j] = matrix[j * n + i] = -value;
        matrix[i * n + i] += value + 0.01;
        matrix[j * n + j] += value + 0.01;
      }
    if (seed % 5 == 0 && n == 1) matrix[0] = 1;
    for (std::size_t k = 0; seed % 5 == 1 && k < n; ++k) {  // of different scales
      const double scale = random.decades(-1, 1);
      for (std::size_t j = 0; j < n; ++j) matrix[k * n + j] *= scale;
      for (std::size_t j = 0; j < n; ++j) matrix[j * n + k] *= scale;
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
