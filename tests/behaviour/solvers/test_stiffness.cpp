// The stiffness costs few products and is right to ten digits, for every operator that multiplies but cannot factor.
#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr std::int32_t boundaries[] = {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC};

// At most half of those of the contact.
void check_extra_products(const Problem& problem, const Pair& pair) {
  const Answer without = solved(problem, pair, {{RC_OPT_TOL, "1e-8"}}),
               with = solved(problem, pair, {{RC_OPT_TOL, "1e-8"}, {RC_OPT_STIFFNESS, "1"}});
  const std::int64_t extra = with.result.products - without.result.products;
  report(pair.solver + ", " + pair.backend + ": " + std::to_string(without.result.products) + " products, " +
         std::to_string(extra) + " more for the stiffness of " + std::to_string(with.result.contacts) + " points");
  check(2 * extra <= without.result.products, "too many products");
  check(extra >= 5, "a residual of 1e-8 takes more products");
}

void a_stiffness_takes_few_products() {
  for (const std::int32_t boundary : boundaries)
    for (const double depth : {0.3, 0.9}) {
      const Problem problem = rugged_problem(256, 256, depth, boundary);
      check_extra_products(problem, {"haar-cg", "fft"});
      check_extra_products(at_load(problem, solved(problem, {"haar-cg", "fft"}).result.load), {"haar-cg", "fft"});
    }
  check_extra_products(rugged_problem(256, 256, 0.3, RC_BOUNDARY_FREE), {"haar-cg", "split"});
}

void a_warm_step_stays_cheap() {
  for (const std::int32_t boundary : boundaries) {
    Problem problem = rugged_problem(64, 64, 0.5, boundary);
    std::int64_t products[2];
    for (const int with : {0, 1}) {
      Contact contact(problem, {"haar-cg", "fft"}, {{RC_OPT_TOL, "1e-8"}, {RC_OPT_STIFFNESS, std::to_string(with)}});
      contact.solve(problem);
      problem.target *= 1.001;
      products[with] = contact.solve(problem).result.products;
      problem.target /= 1.001;
    }
    report("a warm step takes " + std::to_string(products[0]) + " products, with its stiffness " + std::to_string(products[1]));
    check(products[1] <= products[0] + 12, "too many products");
  }
}

// Against factors of H on the contact set.
void a_stiffness_is_right_to_the_tolerance() {
  for (const std::int32_t boundary : boundaries)
    for (const double depth : {0.1, 0.5, 0.9, 0.99}) {
      const Problem problem = rugged_problem(48, 36, depth, boundary);
      const Settings settings = {{RC_OPT_STIFFNESS, "1"}, {RC_OPT_TOL, "1e-9"}};
      const double exact = solved(problem, {"nnls", "dense"}, settings).result.stiffness;
      for (const char* backend : {"fft", "split"}) {
        const Pair pair{"haar-cg", backend};
        if (!obstacle(pair, problem.system, RC_CONTROL_APPROACH).empty()) continue;
        check_near(solved(problem, pair, settings).result.stiffness, exact, 1e-9 * exact, backend);
      }
    }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.stiffness",
                   RC_TESTS(a_stiffness_takes_few_products, a_warm_step_stays_cheap, a_stiffness_is_right_to_the_tolerance), argc,
                   argv);
}
