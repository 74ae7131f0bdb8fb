// Intervals that option stiffness = 2 proves are narrow, and none where nothing is asked; the conductance that follows from them.
#include <roughcontact/analysis.h>

#include <algorithm>
#include <cmath>

#include "calls.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// At a small tolerance the interval is narrow, and around the stiffness of the answer.
void narrow_on_a_rough_surface() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Problem problem = rough_problem(96, 80, boundary, 1, 0.8);
    for (const bool by_load : {false, true}) {
      const Problem asked = by_load ? at_load(problem, solved(problem, automatic).result.load) : problem;
      const rc_result r = solved(asked, {"haar-cg", "fft"}, {{RC_OPT_TOL, "1e-8"}, {RC_OPT_STIFFNESS, "2"}}).result;
      check(r.stiffness_lower <= r.stiffness * (1 + 1e-9) && r.stiffness * (1 - 1e-9) <= r.stiffness_upper,
            "the stiffness is outside its interval");
      check(r.stiffness_upper - r.stiffness_lower <= 0.01 * r.stiffness,
            "wide: " + text(r.stiffness_lower) + " .. " + text(r.stiffness_upper));
    }
  }
}

void nothing_is_proven_where_nothing_is_asked() {
  const Problem problem = rough_problem(20, 16);
  for (const Settings& settings :
       {Settings{}, Settings{{RC_OPT_STIFFNESS, "1"}}, Settings{{RC_OPT_STIFFNESS, "2"}, {RC_OPT_BOUNDS, "0"}}}) {
    const rc_result r = solved(problem, automatic, settings).result;
    check(std::isnan(r.stiffness_lower) && std::isnan(r.stiffness_upper), "an interval");
    check(std::isnan(r.stiffness) == settings.empty(), "a stiffness");
  }
  Problem apart = problem;
  apart.target = apart.lowest_gap() - 1;
  const rc_result r = solved(apart, automatic, {{RC_OPT_STIFFNESS, "2"}}).result;
  check(r.stiffness == 0 && r.stiffness_lower == 0 && r.stiffness_upper == 0, "stiffness without contact");
}

// Full periodic contact has no finite stiffness.
void full_periodic_contact() {
  Problem problem = rough_problem(16, 16, RC_BOUNDARY_PERIODIC);
  problem = at_load(problem, 1e4);
  const rc_result r = solved(problem, automatic, {{RC_OPT_STIFFNESS, "2"}}).result;
  check(std::isinf(r.stiffness) && r.stiffness_lower == 0 && std::isinf(r.stiffness_upper), "interval in full contact");
}

// Holm: 4 radius / (rho1 + rho2) for a circular spot.
void a_circular_spot_conducts_like_holms() {
  constexpr std::int64_t side = 160;
  constexpr double radius = 60, modulus = 7;
  Problem problem;
  problem.system.nx = problem.system.ny = side;
  problem.system.modulus = modulus;
  for (const double distance : paraboloid(side, side, 1, 0.5 * (side - 1), 0.5 * (side - 1), 0.5))  // squared
    problem.gap.push_back(distance < radius * radius ? 0 : 1e6);
  problem.target = 1;
  const Answer answer = solved(problem, {"haar-cg", "fft"}, {{RC_OPT_TOL, "1e-8"}, {RC_OPT_STIFFNESS, "2"}});
  double conductance = 0, lower = 0, upper = 0;
  check_equal(rc_conductance(&problem.system, &answer.result, 0.5, 2.5, &conductance, &lower, &upper), RC_OK, rc_last_error());
  const double holm = 4 * radius / 3;
  check_near(conductance, holm, 0.01 * holm, "conductance");
  check(lower <= conductance && conductance <= upper && upper - lower <= 1e-6 * conductance, "interval");
  double alone = 0;
  check_equal(rc_conductance(&problem.system, &answer.result, 3, 0, &alone, nullptr, nullptr), RC_OK, rc_last_error());
  check_near(alone, conductance, 0, "the sum of the resistivities counts");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("derivatives.interval",
                   RC_TESTS(narrow_on_a_rough_surface, nothing_is_proven_where_nothing_is_asked, full_periodic_contact,
                            a_circular_spot_conducts_like_holms),
                   argc, argv);
}
