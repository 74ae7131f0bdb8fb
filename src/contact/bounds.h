// Proofs about the exact solution at the given approach, from one product with H: docs/certificate.md has the derivation.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "contact/spectrum.h"
#include "contact/surface_state.h"
#include "contact/system.h"

namespace rc {

struct Bounds {
  double duality_gap = std::numeric_limits<double>::quiet_NaN();  // [force length]
  double load_lower = duality_gap, load_upper = duality_gap;      // [force]
  double area_lower = duality_gap, area_upper = duality_gap;      // [length^2]
  std::int64_t proven_contacts = -1, proven_open = -1, undecided = -1;

  void write(rc_result& result) const;
};

// p and product = H p over all points [pressure, length]; p is 0 on excluded points.
Bounds prove_bounds(const System&, const Spectrum&, const SurfaceState&, double approach, std::span<const double> p,
                    std::span<const double> product);

}  // namespace rc
