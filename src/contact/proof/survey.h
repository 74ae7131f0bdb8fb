// Passes over an answer's entries by all threads, which select the few that are needed later. Numbers and extents are of all
// processes, entries of this one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "core/chunks.h"

namespace rc {

struct Survey {
  // Entries in ascending order: those with a pressure, and those whose gap is negative or not finite.
  std::vector<std::size_t> touching;
  double largest_product = 0;  // [length] of the sizes of H p
  double largest_gap = 0;      // [length] of the sizes of the deformed gap, at included points
  double sum_of_gaps = 0;      // [length] at included points; the same bits for any number of threads and processes
};

Survey survey(const StepSurface& surface, double compression, const Deflected& answer);

// Marks the points begin .. begin+count-1 of a list whose deformed gap is no larger than the limit [length], or not finite.
// product: H p [length] at those of the list. begin: where a chunk begins.
void mark_near(const StepSurface& surface, const TrialSet& on, std::span<const double> product, double compression, double limit,
               std::int64_t begin, std::int64_t count, Marks& marks);

}  // namespace rc
