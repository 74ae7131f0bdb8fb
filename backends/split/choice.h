// Which coarse grid is the cheapest, from counts alone.
#pragma once

#include "tiles.h"

namespace rc_split {

struct Plan {
  int spacing = 0;                                  // of the coarse grid, in cells; 0: none, every product is summed directly
  double seconds = 0;                               // of a product, roughly
  bool parallel() const { return seconds > 1e-4; }  // else waking threads costs more than they save
};

// Where products are wanted: at the tiles of the domain, perhaps with a few more, or at all tiles of the frame.
enum class Targets { domain, frame };

// wanted: the spacing to take if there is a coarse grid; 0: any.
template <class T> Plan choose(const Tiles& tiles, const Frame& frame, Targets targets, double hx, double hy, int wanted);

// The distance [length] beyond which the smooth part is all of H.
template <class T> double cutoff(int spacing, double hx, double hy);

}  // namespace rc_split
