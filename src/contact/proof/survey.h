// Passes over an answer's entries by all threads, for what is then told of few of them. Numbers and extents are of all ranks,
// entries of this one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/pressures.h"
#include "contact/step_surface.h"
#include "core/chunks.h"

namespace rc {

struct Survey {
  // Entries in ascending order: those with a pressure, and those whose gap is negative or not finite.
  std::vector<std::size_t> touching;
  double largest_product = 0;  // [length] of the sizes of H p
  double largest_gap = 0;      // [length] of the sizes of the deformed gap, at included points
};

Survey survey(const StepSurface& surface, double compression, const Deflected& answer);

// The extent of the points of the entries where something holds; marks: null, or where these entries are marked.
template <class Holds>
Extent extent_where(const StepSurface& surface, const Deflected& answer, Marks* marks, const Holds& holds) {
  const std::int64_t nx = surface.nx();
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    Extent extent;
    std::int64_t row = 0, row_end = 0;  // divides only where a row begins
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i) {
      if (!holds(i)) continue;
      const auto point = static_cast<std::int64_t>(answer.point(i));
      if (point >= row_end) {
        row = point / nx;
        row_end = (row + 1) * nx;
      }
      extent.add(point - row * nx, surface.first_row() + row);
      if (marks) marks->add(i);
    }
    return extent;
  };
  return surface.united(reduce<Extent>(static_cast<std::int64_t>(answer.size()), surface.team(), body));
}

}  // namespace rc
