// Cascade multi-resolution, Algorithm 6 of Bemporad & Paggi (2015), as the solver cmr is told to read it.
#pragma once

#include <cstdint>
#include <string>

#include "library.h"

namespace bench {

struct Cascade {
  std::string filter = "subsample";  // what a coarse point takes from its four heights
  double radius = 2;                 // h: of the area of influence
  std::string area = "side";         // h counts sides (Algorithm 6) or diagonals (the text) of coarse cells
  std::int32_t levels = 0;           // grids, the given one included; 0: down to 16 points a side
  std::string backend = "fft", inner = "polonsky-keer";
};

// certified = false: as published, without a look at the points that were left out.
Settings settings_of(const Cascade& cascade, bool certified);

// What a certified cascade says of itself.
struct CascadeNote {
  long long kept = 0, all = 0;  // points of the last trial set, and candidates
  long long rounds = 0, added = 0;
  double share() const { return all > 0 ? static_cast<double>(kept) / static_cast<double>(all) : 1; }
  // n_p / n of the paper: before anything was added.
  double share_at_first() const { return all > 0 ? static_cast<double>(kept - added) / static_cast<double>(all) : 1; }
};
CascadeNote cascade_note(const std::string& note);

}  // namespace bench
