#include "flows.h"

#include <cmath>

#include "support/cmocka.hpp"

namespace flow_tests {

Field uniform(std::int64_t nx, std::int64_t ny, double height) {
  return {nx, ny, std::vector<double>(static_cast<std::size_t>(nx * ny), height)};
}

rc_flow_spec spec_of(const Field& field, std::int32_t along, std::int32_t sides, double width) {
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = along;
  spec.sides = sides;
  spec.viscosity = 1.0 / 12;
  spec.pressure_drop = 1;
  spec.width = width;
  spec.nx = field.nx;
  spec.ny = field.ny;
  spec.hx = field.hx;
  spec.hy = field.hy;
  spec.gap.data = field.g.data();
  if (!field.error.empty()) spec.gap_error.data = field.error.data();
  return spec;
}

rc_flow_result flow(const Field& field, std::int32_t along, std::int32_t sides, double width) {
  const rc_flow_spec spec = spec_of(field, along, sides, width);
  rc_flow_result result = RC_FLOW_RESULT_INIT;
  if (RC_FAILED(rc_flow_solve(&spec, &result))) fail_msg("%s", rc_flow_last_error());
  if (!(result.lower <= result.flow && result.flow <= result.upper))
    fail_msg("%.17g is not in %.17g .. %.17g", result.flow, result.lower, result.upper);
  return result;
}

rc_flow_factors factors(const Field& field, double width) {
  const rc_flow_spec spec = spec_of(field, RC_FLOW_X, RC_FLOW_CLOSED, width);
  rc_flow_factors result = RC_FLOW_FACTORS_INIT;
  if (RC_FAILED(rc_flow_factors_find(&spec, &result))) fail_msg("%s", rc_flow_last_error());
  return result;
}

void require_near(double found, double expected, double relative, const char* what) {
  if (!(std::abs(found - expected) <= relative * std::abs(expected)))
    fail_msg("%s: %.15g, expected %.15g", what, found, expected);
}

}  // namespace flow_tests
