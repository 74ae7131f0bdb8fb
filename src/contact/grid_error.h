// How far an answer on a coarser grid may be from the one on the grid given, guessed from two coarser grids and from what they do
// not show of the surface: enough to tell which grid is worth a look at the given one, which decides.
#pragma once

#include <cstdint>
#include <span>

#include "contact/surface_state.h"
#include "registry/options_handle.h"

namespace rc {

// What option accuracy asks for.
struct Goal {
  double error = 0;  // relative; 0: none
  bool of_area = false;

  // The tolerance that leaves the goal to the grid. Contact areas count points, some of which carry next to nothing.
  double tol() const { return error / (of_area ? 1000 : 100); }
};
Goal goal_of(const rc_options& options);

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
Texture texture_below(double limit, double length, const SurfaceState& surface, const rc_system& system);

// Relative errors of the load.
struct GridErrors {
  double here = 0;
  double finest = 0;  // what that of grid 1 will be
};

// From grid k >= 1: needs the differences of grids k and k+1 and the roughness of all up to k+1.
GridErrors guessed_errors(std::span<const GridLevel> levels, std::size_t k);

}  // namespace rc
