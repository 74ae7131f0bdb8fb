// Problems that strain double precision: every solver of the registry certifies the right pressures or says that it did not.
#include "atlas.h"

namespace failures {

namespace {

constexpr double certified_to = 1e-8, right = 1e-4;

void check_scene(const Problem& problem, const std::string& backend) {
  const Answer truth = truth_of(problem);
  for (const std::string& solver : solvers_on(backend, problem)) {
    const Answer answer =
        solve(problem, {solver, backend},
              {{"tol", text(certified_to)}, {"max_iter", "20000"}, {"greedy.repair", "0"}, {"time_limit", "60"}});
    check_honest(answer, truth.p, right, solver);
    if (answer.status != RC_OK) report(solver + ": " + answer.message);
    check(solver == "greedy" || answer.status == RC_OK, solver + ": " + answer.message);
  }
}

void automatic_choice_certifies(const Problem& problem) {
  const Answer answer = solve(problem, automatic, {{"tol", text(certified_to)}});
  check_status(answer, RC_OK, "auto");
  check_honest(answer, truth_of(problem).p, right, "auto");
}

// The diagonal of eq9 is 36 % too small: the matrix is worse conditioned the larger the contact.
void eq9_costs_more_than_love_as_the_contact_grows() {
  for (const std::int64_t levels : {5, 6, 7}) {
    Problem problem = midpoint_problem(levels, 1);
    problem.target *= 2;
    const auto products = [&](const char* kernel) {
      problem.kernel = kernel;
      const Answer answer = solved(problem, {"polonsky-keer", "fft"}, {{"tol", "1e-8"}});
      return answer.result.products;
    };
    const std::int64_t eq9 = products("eq9"), love = products("love");
    report(std::to_string(problem.system.nx) + "^2: eq9 " + std::to_string(eq9) + ", love " + std::to_string(love));
    check(eq9 > love, "eq9 should cost more products");
  }
}

}  // namespace

}  // namespace failures

int main(int argc, char** argv) {
  using namespace failures;
  std::vector<pairs::Test> tests;
  for (const auto& each : strained_problems(full() ? 64 : quick() ? 8 : 16)) {
    for (const char* backend : {"dense", "fft"})
      tests.push_back({each.first + " on " + backend, [=] { check_scene(each.second, backend); }});
    tests.push_back({each.first + ", automatic", [=] { automatic_choice_certifies(each.second); }});
  }
  tests.push_back({"eq9_costs_more_than_love_as_the_contact_grows", eq9_costs_more_than_love_as_the_contact_grows});
  return pairs::run_group("failures.conditioning", tests, argc, argv);
}
