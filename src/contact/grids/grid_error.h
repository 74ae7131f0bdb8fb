// How far an answer on a coarser grid may be from the one on the grid given, guessed from two coarser grids and from what they do
// not show of the surface: enough to tell which grid is worth a look at the given one, which decides.
#pragma once

#include <cstdint>
#include <span>

#include "contact/step_surface.h"

namespace rc {

// What a grid shows of the surface where the approach exceeds the gap.
struct Texture {
  double roughness = 0;  // rms of second differences of neighbouring gaps, over a length; infinite: not known
  std::int64_t points = 0;
};

// One grid of 2^k times the cell size, k from 0.
struct GridLevel {
  Texture texture;
  double difference = 0;  // of the load from the next coarser grid's, relative
};

// Of the points with a gap below the limit.
Texture texture_below(double limit, double length, const StepSurface& surface, const rc_system& system);

// Relative errors of the load.
struct GridErrors {
  double here = 0;
  double finest = 0;  // what that of grid 1 will be
};

// From grid k >= 1: needs the differences of grids k and k+1 and the roughness of all up to k+1.
GridErrors guessed_errors(std::span<const GridLevel> levels, std::size_t k);

}  // namespace rc
