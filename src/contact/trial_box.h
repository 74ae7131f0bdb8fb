// The bounding box of a trial set.
#pragma once

#include <cstdint>

#include "operator/operator.h"

namespace rc {

// Points of the box on a grid nx wide and ny high.
std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny);
// Every point of the box; without an index if the box is the whole grid.
TrialSet box_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny);

}  // namespace rc
