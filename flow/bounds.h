// Both bounds of a network's conductance from any potentials; docs/development/flow.md derives them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "paths.h"

namespace rc::flow {

// The potential of every cell for a drop along x, along y: one of them with inlet and outlet, two in a cell that repeats.
using Potentials = std::vector<std::vector<double>>;

// A symmetric matrix: the conductances for drops along x and y; with inlet and outlet xx only.
struct Tensor {
  double xx = 0, xy = 0, yy = 0;
};

// The energy of the potentials: K is at most this, as a form of the drop. gap: of the cells on paths, 0: closed.
Tensor dirichlet(const Grid& grid, const std::vector<double>& gap, const Paths& paths, const Potentials& potentials);

// From the flows of the potentials, made free of sources along the tree of the paths through this gap: K is at least this.
Tensor thomson(const Grid& grid, const std::vector<double>& gap, const Paths& paths, const Potentials& potentials);

}  // namespace rc::flow
