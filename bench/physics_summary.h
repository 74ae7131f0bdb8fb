// What the solves of rough surfaces amount to: means over surfaces, fits, convergence with the grid.
#pragma once

#include "child.h"
#include "physics.h"

namespace bench {

struct PhysicsSummary {
  Json curve;   // a row for each pressure, means over the surfaces
  Json fits;    // slope of the area at light loads, decay length of the pressure; mean, lowest and highest of the surfaces
  Json meshes;  // a row for each pressure and grid, means over the surfaces
};

// rows: those of one kind of surface, as run_physics keeps them.
PhysicsSummary summary_of(const Json& rows, const PhysicsRequest& request);

}  // namespace bench
