// The cost of derivatives, counted in products with H.
#include <random>

#include "calls.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// Waves with noise on every cell, pressed in by a multiple of the mean gap.
Problem rugged(std::int64_t side, double depth, std::int32_t boundary) {
  Problem problem = rough_problem(side, side, boundary);
  std::mt19937 random(5);
  for (double& gap : problem.gap) gap += 1e-6 * static_cast<double>(random() % 100000);
  problem.target =
      problem.lowest_gap() + depth * (sum(problem.gap) / static_cast<double>(problem.points()) - problem.lowest_gap());
  return problem;
}

void check_products(const Problem& problem) {
  const Contact contact(problem, {"haar-cg", "fft"}, {{RC_OPT_TOL, "1e-8"}});
  const Answer answer = contact.solve(problem);
  check_status(answer, RC_OK);
  std::mt19937 generator(2);
  Cotangents by;
  for (std::size_t i = 0; i < problem.points(); ++i) {
    by.p.push_back(1e-3 * static_cast<double>(generator() % 2000) - 1);
    by.gap.push_back(1e-3 * static_cast<double>(generator() % 2000) - 1);
  }
  const double solve = static_cast<double>(answer.result.products);
  const Gradient whole = gradient(contact, problem.points(), by), load = gradient(contact, problem.points());
  check_equal(whole.status, RC_OK, whole.message);
  check_equal(load.status, RC_OK, load.message);
  report(std::to_string(answer.result.contacts) + " points: " + std::to_string(answer.result.products) +
         " products, a gradient " + std::to_string(whole.result.products) + ", of load or approach " +
         std::to_string(load.result.products));
  check(static_cast<double>(whole.result.products) <= 0.9 * solve, "too many products for a gradient");
  check(static_cast<double>(load.result.products) <= 0.4 * solve, "too many products for one of load or approach");
  check(load.result.products >= 3, "a residual of 1e-8 takes more products");
}

void a_gradient_takes_few_products() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const double depth : {0.3, 0.9}) {
      const Problem problem = rugged(128, depth, boundary);
      check_products(problem);
      check_products(at_load(problem, solved(problem, {"haar-cg", "fft"}).result.load));
    }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("derivatives.products", {{"a_gradient_takes_few_products", a_gradient_takes_few_products}}, argc, argv);
}
