// A guess of how far a coarser grid's answer is from the given grid's, from the answers on two coarser grids and from the
// surface's roughness on all. It only decides when a look at the given grid is worth while.
#pragma once

#include <cstdint>
#include <span>

#include "contact/surface/step_surface.h"

namespace rc {

// The surface as one grid shows it, where the approach exceeds the gap.
struct Texture {
  double roughness = 0;  // rms of the second differences of the gap, over a length; infinite: not known
  std::int64_t points = 0;
};

// One grid of 2^k times the cell size, k from 0.
struct GridLevel {
  Texture texture;
  double difference = 0;  // relative, of the load from the next coarser grid's
};

// The texture of the points with a gap below the limit.
Texture texture_below(double limit, double length, const StepSurface& surface, const rc_system& system);

// Relative errors of the load, guessed from grid k.
struct GridErrors {
  double here = 0;
  double finest = 0;  // of grid 1, once it is solved
};

// Needs the differences of grids k >= 1 and k+1, and the roughness of all grids up to k+1.
GridErrors guessed_errors(std::span<const GridLevel> levels, std::size_t k);

}  // namespace rc
