// If "auto" tries several backends and none can solve, the message begins with the first one's reason.
#include "honesty_tests.h"
#include "support/contact.h"

namespace pairs {

namespace {

void auto_tells_the_first_cause() {
  constexpr std::int64_t n = 600;
  Field matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) matrix[i * (n + 1)] = 1;
  Problem problem;
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.nx = problem.system.dense_ld = n;
  problem.system.dense = matrix.data();
  problem.gap.assign(n, 0);
  problem.target = 1;
  const std::string first = solved(problem, automatic).result.backend;
  Settings small;
  for (const char* backend : {"dense", "cholmod"}) {
    rc_options* options = nullptr;
    check(rc_options_create(nullptr, &options) == RC_OK, rc_last_error());
    const std::string key = std::string(backend) + ".memory_limit";
    if (rc_options_set_text(options, key.c_str(), "1") == RC_OK) small.push_back({key, "1"});
    rc_options_destroy(options);
  }
  const Answer answer = solve(problem, automatic, small);
  check_status(answer, RC_ERR_MEMORY);
  check(answer.message.find(first + ":") < answer.message.find("failed, too"), answer.message);
  if (small.size() > 1) check(answer.message.find("failed, too") != std::string::npos, answer.message);
}

}  // namespace

std::vector<Test> first_causes() { return {{"auto_tells_the_first_cause", auto_tells_the_first_cause}}; }

}  // namespace pairs
