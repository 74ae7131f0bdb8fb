#include "atlas.h"

#include <algorithm>
#include <cmath>

namespace failures {

Answer truth_of(const Problem& problem) { return solved(problem, {"nnls", "dense"}, {{"tol", "1e-12"}}); }

std::vector<std::string> solvers_on(const std::string& backend, const Problem& problem) {
  std::vector<std::string> names;
  for (const std::string& solver : solver_names())
    if (obstacle({solver, backend}, problem.system, problem.control).empty()) names.push_back(solver);
  check(!names.empty(), "no solver runs on " + backend);
  return names;
}

double difference(const Field& a, const Field& b) {
  double worst = 0;
  for (std::size_t i = 0; i < b.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  const double size = largest(b);
  return size > 0 ? worst / size : worst;
}

void check_honest(const Answer& answer, const Field& truth, double tolerance, const std::string& what) {
  check(answer.status >= 0, what + ": " + answer.message);
  if (answer.status != RC_OK) {
    check(!answer.message.empty(), what + ": no message with " + rc_status_name(answer.status));
    return;
  }
  const double error = difference(answer.p, truth);
  check(error <= tolerance, what + ": certified, but the pressures are off by " + text(error));
}

}  // namespace failures
