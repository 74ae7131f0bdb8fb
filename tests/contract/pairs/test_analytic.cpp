// Closed forms with free boundaries: Hertz, flat punch, one cell by hand. The periodic ones are in analytic_periodic.cpp.
#include <cmath>
#include <numbers>

#include "analytic_tests.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// Sphere of radius 10, E* = 1, approach 0.1: contact radius 1, load (4/3) E* a^3 / R.
constexpr double sphere = 10, hertz_load = 4.0 / 3 / sphere;

Problem hertz(std::int64_t cells_per_radius, const std::string& kernel) {
  Problem problem;
  problem.kernel = kernel;
  rc_system& s = problem.system;
  s.nx = s.ny = 3 * cells_per_radius;
  s.hx = s.hy = 1 / static_cast<double>(cells_per_radius);
  const double centre = 0.5 * static_cast<double>(s.nx - 1);
  problem.gap = paraboloid(s.nx, s.ny, s.hx, centre, centre, sphere);
  problem.target = 1 / sphere;
  return problem;
}

double slope(const Field& x, const Field& y) {
  const double n = static_cast<double>(x.size()), mean_x = sum(x) / n, mean_y = sum(y) / n;
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    xx += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return xy / xx;
}

struct HertzErrors {
  const char* kernel;
  Field errors;  // relative, of the load at a/h = 8, 16, 32, 64
};

void load_converges(const HertzErrors& expected) {
  Field x, y;
  for (std::size_t k = 0; k < expected.errors.size(); ++k) {
    const auto cells = std::int64_t{8} << k;
    const double error = solved(hertz(cells, expected.kernel), automatic, {{RC_OPT_TOL, "1e-9"}}).result.load / hertz_load - 1;
    const std::string at = std::string(expected.kernel) + ", a/h = " + std::to_string(cells) + ": relative load error ";
    check(error > 0.5 * expected.errors[k] && error < 2 * expected.errors[k],
          at + text(error) + ", expected " + text(expected.errors[k]));
    report(at + text(error));
    x.push_back(-std::log(static_cast<double>(cells)));
    y.push_back(std::log(error));
  }
  const double order = slope(x, y);
  report(std::string(expected.kernel) + ": order " + text(order));
  check(order > 1.7 && order < 2.4, std::string(expected.kernel) + ": order " + text(order) + " instead of 2");
}

void area_stiffness_and_energy_are_hertz() {
  const Problem problem = hertz(32, "love");
  const Answer answer = solved(problem, automatic, {{RC_OPT_STIFFNESS, "1"}});
  check_near(answer.result.contact_area, pi, 0.03 * pi, "contact area");
  check_near(answer.result.stiffness, 2, 0.01 * 2, "stiffness 2 a E*");
  check_near(answer.result.energy, -0.4 * hertz_load * problem.target, 1e-3 * hertz_load * problem.target, "energy -(2/5) W d");
  check_near(largest(answer.p), 2 / (pi * sphere), 1e-3, "largest pressure 2 a E* / (pi R)");
}

void approach_is_hertz(const Pair& pair) {
  const Problem problem = at_load(hertz(16, "love"), hertz_load);
  check_near(solved(problem, pair).result.approach, 1 / sphere, 1e-3 / sphere, "approach a^2 / R");
}

// A square flat punch of side 1 under unit approach.
Problem flat_square(std::int64_t cells, const std::string& kernel) {
  Problem problem;
  problem.kernel = kernel;
  problem.system.nx = problem.system.ny = cells;
  problem.system.hx = problem.system.hy = 1 / static_cast<double>(cells);
  problem.gap.assign(problem.points(), 0.0);
  problem.target = 1;
  return problem;
}

double punch_load(std::int64_t cells, const std::string& kernel) {
  return solved(flat_square(cells, kernel), automatic, {{RC_OPT_TOL, "1e-9"}}).result.load;
}

struct PunchLoads {
  const char* kernel;
  Field loads;  // N = 16, 32, 64, 128
};

void punch_converges(const PunchLoads& expected) {
  Field loads;
  for (std::size_t k = 0; k < expected.loads.size(); ++k) {
    loads.push_back(punch_load(std::int64_t{16} << k, expected.kernel));
    check_near(loads[k], expected.loads[k], 1e-4, expected.kernel);
  }
  report(std::string(expected.kernel) + ": " + text(loads[0]) + " " + text(loads[1]) + " " + text(loads[2]) + " " +
         text(loads[3]) + ", extrapolated " + text(2 * loads[3] - loads[2]));
  check_near(2 * loads[3] - loads[2], 1.1523, 5e-4, "extrapolated to h = 0");
}

// The contact of flat punches does not change with the approach: dW/dd = W/d, 2 a E* for a round one of radius a.
void punches_are_springs() {
  const Settings settings = {{RC_OPT_TOL, "1e-9"}, {RC_OPT_STIFFNESS, "1"}};
  const Problem square = flat_square(64, "love");
  const rc_result of_square = solved(square, automatic, settings).result;
  check_near(of_square.stiffness, of_square.load / square.target, 1e-8 * of_square.load, "stiffness of a square");
  check_near(of_square.stiffness, 1.1523, 0.01 * 1.1523, "stiffness of a square of side 1");

  Problem disc = flat_square(64, "love");
  disc.system.modulus = 3;
  for (std::int64_t iy = 0; iy < 64; ++iy)
    for (std::int64_t ix = 0; ix < 64; ++ix)
      disc.mask.push_back(std::hypot(static_cast<double>(ix) - 31.5, static_cast<double>(iy) - 31.5) < 32);
  const rc_result of_disc = solved(disc, automatic, settings).result;
  check_near(of_disc.stiffness, of_disc.load / disc.target, 1e-8 * of_disc.load, "stiffness of a disc");
  check_near(of_disc.stiffness, 3, 0.015 * 3, "stiffness 2 a E* of a disc");
}

void single_cell(const Pair& pair) {
  Problem problem;
  problem.system.hx = 0.2;
  problem.system.hy = 0.3;
  problem.system.modulus = 4;
  problem.gap = {0.7};
  problem.target = 0.9;
  const double self = coefficient("love", 0, 0, 0.2, 0.3) / 4;
  const Settings to_round_off = {{RC_OPT_TOL, "1e-14"}};
  const Answer answer = solved(problem, pair, to_round_off);
  check_near(answer.p[0], 0.2 / self, 1e-14 / self, "p = u / H");
  check_near(solved(at_load(problem, answer.result.load), pair, to_round_off).result.approach, 0.9, 1e-14, "approach");
}

std::vector<Test> free_tests() {
  std::vector<Test> tests;
  for (const HertzErrors& expected :
       {HertzErrors{"love", {1.6e-3, 3.4e-4, 7.3e-5, 1.9e-5}}, HertzErrors{"galerkin", {2.4e-3, 6.0e-4, 1.3e-4, 3.5e-5}}})
    tests.push_back(
        {std::string("load_of_a_sphere_converges_with_order_2/") + expected.kernel, [=] { load_converges(expected); }});
  for (const PunchLoads& expected :
       {PunchLoads{"love", {1.12863, 1.14021, 1.14617, 1.14921}}, PunchLoads{"galerkin", {1.13720, 1.14450, 1.14832, 1.15028}}})
    tests.push_back(
        {std::string("load_of_a_flat_square_tends_to_1.1523/") + expected.kernel, [=] { punch_converges(expected); }});
  tests.push_back({"area_stiffness_and_energy_of_a_sphere_are_hertz", area_stiffness_and_energy_are_hertz});
  tests.push_back({"stiffness_of_flat_punches_is_load_over_approach", punches_are_springs});
  add_for_pairs(tests, "approach_of_a_loaded_sphere_is_hertz", RC_BOUNDARY_FREE, approach_is_hertz);
  add_for_pairs(tests, "single_cell_is_a_spring", RC_BOUNDARY_FREE, single_cell);
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = free_tests();
  for (Test& test : periodic_analytic_tests()) tests.push_back(std::move(test));
  return run_group("pairs.analytic", tests, argc, argv);
}
