// How the cells of a grid lie in the network, whose flow is along its x.
#pragma once

#include <roughcontact/flow.h>

#include "network_flow.h"

namespace rc::flow {

struct Layout {
  Grid grid;
  bool turned;  // the flow is along y of the caller's grid: rows are columns here

  // Where a cell of the network is in the caller's arrays.
  std::size_t of_caller(std::int64_t i) const {
    return static_cast<std::size_t>(turned ? i % grid.nx * grid.ny + i / grid.nx : i);
  }
  std::vector<double> arranged(std::vector<double> values) const {
    if (!turned) return values;
    std::vector<double> rows(values.size());
    for (std::int64_t i = 0; i < grid.size(); ++i) rows[static_cast<std::size_t>(i)] = values[of_caller(i)];
    return rows;
  }
  Gap arranged(Gap gap) const {
    return {arranged(std::move(gap.least)), arranged(std::move(gap.computed)), arranged(std::move(gap.most))};
  }
};

inline Layout layout_of(std::int64_t nx, std::int64_t ny, double hx, double hy, const rc_flow_spec& spec) {
  const bool turned = spec.along == RC_FLOW_Y;
  if (turned) {
    std::swap(nx, ny);
    std::swap(hx, hy);
  }
  return {{nx, ny, hy / hx, hx / hy, false, spec.sides == RC_FLOW_PERIODIC}, turned};
}

// On the grid of a system; sides 0: as its boundary repeats.
inline Layout layout_of(const rc_system& system, rc_flow_spec spec) {
  if (spec.sides == 0) {
    const bool across = system.op == RC_OPERATOR_HALFSPACE &&
                        (system.boundary == RC_BOUNDARY_PERIODIC ||
                         system.boundary == (spec.along == RC_FLOW_Y ? RC_BOUNDARY_PERIODIC_X : RC_BOUNDARY_PERIODIC_Y));
    spec.sides = across ? RC_FLOW_PERIODIC : RC_FLOW_CLOSED;
  }
  return layout_of(system.nx, system.ny, system.hx, system.hy, spec);
}

}  // namespace rc::flow
