// The cost of derivatives, counted in products with H.
#include <random>

#include "calls.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

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
      const Problem problem = rugged_problem(128, 128, depth, boundary);
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
