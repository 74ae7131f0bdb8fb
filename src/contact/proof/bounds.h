// Proofs about the exact solution at the given compression, from one product with H; docs/development/derivation.md derives them.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "contact/proof/survey.h"
#include "contact/spectrum.h"
#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "contact/system.h"

namespace rc {

struct Bounds {
  double duality_gap = std::numeric_limits<double>::quiet_NaN();  // [force length]
  double gap_error = duality_gap;                                 // [length]
  double load_lower = duality_gap, load_upper = duality_gap;      // [force]
  double area_lower = duality_gap, area_upper = duality_gap;      // [length^2]
  std::int64_t proven_contacts = -1, proven_open = -1, undecided = -1, proven_capped = -1;
};

// The points that these statements are about, in ascending order.
struct ProvenSets {
  std::vector<std::int64_t> contacts;  // proven to be in contact, below the hardness
  std::vector<std::int64_t> possible;  // proven neither to be open nor to carry the hardness
  bool listed = true;                  // false: all points are possible, too many to list
};

// compression: the approach less the lowest gap. p must be 0 on excluded points. found: of the answer. If H has
// negative entries and the answer does not list all points, the others have a deformed gap of at least answer.beyond.
Bounds prove_bounds(const System&, const Spectrum&, const StepSurface&, double compression, const Deflected& answer,
                    const Survey& found, ProvenSets* sets = nullptr);

}  // namespace rc
