// Laws of 20 patches against cold certified solves at random pressures: none is outside the bounds that the law claims.
#include <algorithm>
#include <cmath>
#include <random>

#include "patches.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::text;

struct Outside {
  int p = 0, conductance = 0, area = 0;
  double error_p = 0, error_slope = 0, error_energy = 0, error_area = 0;
};

void judge(const rc_law* law, const Truth& truth, Outside& outside) {
  const rc_law_point said = evaluate(law, truth.x);
  const double slack = 1e-9, conductance = 2 * truth.slope;
  outside.p += !(truth.p >= said.p_lower * (1 - slack) && truth.p <= said.p_upper * (1 + slack));
  outside.conductance +=
      !(conductance >= said.conductance_lower * (1 - slack) && conductance <= said.conductance_upper * (1 + slack));
  outside.area += !(truth.area >= said.area_lower * (1 - 1e-12) && truth.area <= said.area_upper * (1 + 1e-12));
  outside.error_p = std::max(outside.error_p, std::abs(said.p / truth.p - 1));
  outside.error_slope = std::max(outside.error_slope, std::abs(said.slope / truth.slope - 1));
  if (std::isfinite(truth.energy))
    outside.error_energy = std::max(outside.error_energy, std::abs(said.energy / truth.energy - 1));
  outside.error_area = std::max(outside.error_area, std::abs(said.area_fraction / truth.area - 1));
}

void stays_in_its_bounds(const Patch& patch, int checks) {
  const MadeLaw result = make(patch);
  check(result.status >= 0, result.message);
  const rc_law* const law = result.law.get();
  const rc_law_info info = describe(law);
  Referee referee(patch, info);
  Outside outside;
  std::mt19937 generator(29);
  for (int i = 0; i < checks; ++i) {
    const double share = static_cast<double>(generator()) / 4294967296.0;
    judge(law, referee.at(info.p_lower * std::pow(info.p_upper / info.p_lower, share)), outside);
  }
  pairs::report(std::to_string(info.nodes) + " nodes, bounds " + std::to_string(info.bounds) + ", widths " + text(info.width) +
                " " + text(info.width_conductance) + " " + text(info.width_area) + ", " + std::to_string(checks) +
                " checks, errors of p " + text(outside.error_p) + " slope " + text(outside.error_slope) + " energy " +
                text(outside.error_energy) + " area " + text(outside.error_area) + ", energy_error " + text(info.energy_error) +
                ", " + text(info.seconds) + " s");
  check(outside.p == 0, std::to_string(outside.p) + " pressures outside their bounds");
  check(outside.conductance == 0, std::to_string(outside.conductance) + " conductances outside their bounds");
  check(outside.area == 0, std::to_string(outside.area) + " areas outside their bounds");
  if (patch.spec.tolerance_conductance == 0) check(info.nodes <= 130, std::to_string(info.nodes) + " nodes");
  check(info.width <= patch.spec.tolerance, "the bounds are " + text(info.width) + " wide");
  check(result.status == (info.bounds == RC_LAW_MONOTONE ? RC_UNCERTIFIED : RC_OK), "status " + std::to_string(result.status));
  check(outside.error_p < 5 * patch.spec.tolerance, "p is off by " + text(outside.error_p));
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests;
  const int checks = pairs::quick() ? 15 : 500;
  for (const Patch& patch : patches(pairs::quick() ? 24 : 48))
    tests.push_back({patch.name, [patch, checks] { stays_in_its_bounds(patch, checks); }});
  return pairs::run_group("law bounds", tests, argc, argv);
}
