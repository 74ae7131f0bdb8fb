// Short forms of the flow library's calls for tests: each fails the test if the call does.
#pragma once

#include <roughcontact/flow.h>

#include <cstdint>
#include <vector>

namespace flow_tests {

struct Field {
  std::int64_t nx = 1, ny = 1;
  std::vector<double> g, error = {};  // error empty: none
  double hx = 1, hy = 1;

  double& at(std::int64_t x, std::int64_t y) { return g[static_cast<std::size_t>(y * nx + x)]; }
};

Field uniform(std::int64_t nx, std::int64_t ny, double height);
// Viscosity 1/12 and drop 1, so that the flow is the conductance.
rc_flow_spec spec_of(const Field& field, std::int32_t along = RC_FLOW_X, std::int32_t sides = RC_FLOW_CLOSED,
                     double width = 1e-9);
// Any usable status.
rc_flow_result flow(const Field& field, std::int32_t along = RC_FLOW_X, std::int32_t sides = RC_FLOW_CLOSED, double width = 1e-9);
rc_flow_factors factors(const Field& field, double width = 1e-9);
void require_near(double found, double expected, double relative, const char* what);

}  // namespace flow_tests
