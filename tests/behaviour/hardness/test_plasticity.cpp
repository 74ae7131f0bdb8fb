// A sphere pressed on a flat, from Hertz's first yield to full plasticity, and proofs beside what they are about.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "capped_cases.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 50;

Problem sphere(std::int64_t n, double cell, double hardness) {
  Problem problem;
  problem.system.nx = problem.system.ny = n;
  problem.system.hx = problem.system.hy = cell;
  problem.system.modulus = 2;
  problem.system.hardness = hardness;
  const double middle = 0.5 * static_cast<double>(n - 1);
  problem.gap = paraboloid(n, n, cell, middle, middle, radius);
  return problem;
}

const Settings settings = {{RC_OPT_TOL, "1e-10"}};
const Pair pair = {"polonsky-keer", "fft"};

// The largest pressure of Hertz is (6 F E*^2 / (pi^3 R^2))^(1/3); it reaches the hardness c at F = pi^3 R^2 c^3 / (6 E*^2).
void first_yield_is_that_of_hertz() {
  const double hardness = 0.1;
  Problem problem = sphere(64, 0.25, hardness);
  const double modulus = problem.system.modulus;
  const double yield = pi * pi * pi * radius * radius * hardness * hardness * hardness / (6 * modulus * modulus);
  check_equal(solve(at_load(problem, 0.97 * yield), pair, settings).result.capped, 0, "points at the hardness before yield");
  const Answer after = solve(at_load(problem, 1.03 * yield), pair, settings);
  check_status(after, RC_OK);
  check(after.result.capped > 0 && after.result.capped < after.result.contacts, "it yields in the middle");
}

// Where the hardness is far below the modulus nothing but the overlap of the bodies is left: a disc of area 2 pi R d bears the
// hardness, and the volume of the indentation is the spherical cap's, pi R d^2.
void full_plasticity_is_rigid() {
  for (const double approach : {0.2, 0.5}) {
    Problem problem = sphere(96, 0.2, 1e-8);
    problem.target = approach;
    const Answer answer = solve(problem, pair, settings);
    check_status(answer, RC_OK);
    const double area = 2 * pi * radius * approach, load = area * problem.system.hardness;
    check_near(answer.result.contact_area, area, 0.01 * area, "area");
    check_near(answer.result.load, load, 0.01 * load, "load");
    check_near(answer.result.plastic_volume, pi * radius * approach * approach, 0.01 * pi * radius * approach * approach,
               "volume");
    check(answer.result.capped >= answer.result.contacts - 8, "nearly all contact is plastic");
    // The area bears the load at the hardness.
    check(answer.result.contact_area * problem.system.hardness >= answer.result.load * (1 - 1e-12), "A >= F / H");
  }
}

// The load falls below Hertz's as the hardness does, and the area is at least F / H.
void softer_is_less() {
  double before = HUGE_VAL;
  for (const double hardness : {10.0, 0.1, 0.05, 0.02}) {
    Problem problem = sphere(64, 0.25, hardness);
    problem.target = 0.5;
    const rc_result r = solved(problem, pair, settings).result;
    check(r.load < before, "the load falls with the hardness");
    check(r.contact_area * hardness >= r.load * (1 - 1e-12), "A >= F / H");
    check(r.proven_capped <= r.capped && r.proven_capped >= r.capped - 8, "nearly all points at the hardness are proven");
    check_equal(r.proven_contacts + r.proven_open + r.undecided, r.points, "counts");
    const double doubt = 1e-13 * r.load;  // of the sum
    check(r.load_lower <= r.load + doubt && r.load - doubt <= r.load_upper && r.load_upper - r.load_lower < 1e-6 * r.load,
          "an interval of " + text((r.load_upper - r.load_lower) / r.load) + " at hardness " + text(hardness) + ", tol " +
              text(r.tolerance));
    before = r.load;
  }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("hardness plasticity", RC_TESTS(first_yield_is_that_of_hertz, full_plasticity_is_rigid, softer_is_less), argc,
                   argv);
}
