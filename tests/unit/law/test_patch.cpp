// The bounds of pressure and slope that a solved node of a law proves.
#include <cmath>
#include <cstdint>

#include "law/patch.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc;

constexpr std::int64_t n = 12;

LawSample node_of(double bulk_stiffness) {
  std::vector<double> gap(n * n);
  for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = 0.05 * static_cast<double>((i * i) % 29);
  rc_system system = RC_SYSTEM_INIT;
  system.nx = system.ny = n;
  system.hx = system.hy = system.modulus = 1;
  system.boundary = RC_BOUNDARY_FREE;
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  spec.undeformed_gap = RC_IN(gap.data());
  spec.bulk = bulk_stiffness > 0 ? RC_LAW_BULK_GIVEN : RC_LAW_BULK_NONE;
  spec.bulk_stiffness = bulk_stiffness;
  LawPatch patch(system, nullptr, spec);
  return patch.at_approach(0.7);
}

// The bulk's yield is as uncertain as the load: both widen the pressure at a given overclosure, by the slope of that.
void a_bulk_widens_the_bounds_of_the_pressure(void**) {
  const double k = 60;
  const rc_law_point alone = node_of(0).node, with = node_of(k).node;
  const double area = static_cast<double>(n * n), width = alone.p_upper - alone.p_lower;
  assert_true(width > 1e-13 * alone.p && alone.p == with.p);
  const double more = with.slope_upper * width * area / k;
  assert_true(more > 0.05 * width);
  assert_true(std::abs(with.p_upper - alone.p_upper - more) <= 1e-3 * width);
  assert_true(std::abs(alone.p_lower - with.p_lower - more) <= 1e-3 * width);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(a_bulk_widens_the_bounds_of_the_pressure)};
  return cmocka_run_group_tests_name("unit.patch", tests, nullptr, nullptr);
}
