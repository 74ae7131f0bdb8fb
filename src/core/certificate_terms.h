// The terms of a certificate, each of one point or of a few sums: contact/proof has what they make up. Code for a device, which
// checks many contacts at once, takes them from here as well; so they are constexpr.
#pragma once

#include "core/by_value.h"
#include "core/limits.h"

namespace rc {

// 0/0 is no violation; anything else over 0 is an infinite one.
constexpr double relative_violation(double violation, double scale) {
  if (violation == 0) return 0;
  return scale > 0 ? violation / scale : infinite;
}

// max(0, -min p) / max|p|, and max(0, max p - c) / c
constexpr double primal_violation(double least_p, double largest_p, double hardness) {
  const double negative = relative_violation(-least_p, largest_p), beyond = largest_p / hardness - 1;
  return larger_of(0.0, larger_of(negative, beyond));
}

// If the gap is negative, the pressure may still grow by this share of the hardness.
constexpr double room_below(double hardness, double p, double gap) {
  return gap < 0 && hardness < infinite ? larger_of(0.0, 1 - p / hardness) : infinite;
}

// For g < 0: min(1 - p / c, |g| / s)
constexpr double dual_violation(double gap, double p, double hardness, double scale) {
  return gap < 0 ? smaller_of(room_below(hardness, p, gap), relative_violation(-gap, scale)) : 0.0;
}

// For p > 0: min(p / max p, |g| / s), and at most 1 - p / c if g < 0
constexpr double complementarity_violation(double gap, double p, double largest_p, double hardness, double scale) {
  if (!(p > 0)) return 0;
  return smaller_of(smaller_of(p / largest_p, room_below(hardness, p, gap)), relative_violation(gap < 0 ? -gap : gap, scale));
}

// |load - wanted| / wanted; 0 if both are 0.
constexpr double load_imbalance(double load, double wanted) {
  return relative_violation(load > wanted ? load - wanted : wanted - load, wanted);
}

// The gap at a point: its height above the lowest gap, less the compression, and what the pressures deflect it by.
constexpr double deformed_gap(double deflection, double compression, double height) {
  return deflection - (compression - height);
}

// How deep a point is indented where the pressure is the hardness.
constexpr double plastic_depth(double deflection, double compression, double height) { return compression - height - deflection; }

// The scale s [length] of gaps; residual_scale in contact/proof/certificate.cpp says why.
struct ScaleTerms {
  bool periodic, by_load;
  bool whole;          // every point may carry pressure
  double deflected;    // what a cell is deflected by at least under the mean pressure that is prescribed
  double mean_height;  // of the undeformed gap above its lowest point
  double tol;
};
constexpr double residual_scale(const ScaleTerms& terms, double compression) {
  if (!terms.periodic) return compression;
  if (terms.by_load) return larger_of(compression, terms.deflected);
  const double mean_gap = terms.mean_height > compression ? terms.mean_height - compression : compression - terms.mean_height;
  return !terms.whole || mean_gap == 0 ? compression : smaller_of(compression, mean_gap / (2 * terms.tol));
}

// The least scale of gaps, periodic boundaries under a load: in full contact the compression may vanish.
constexpr double least_scale_under(double load, double points) { return 0.25 * load / points; }

// Periodic, elastic, every point may carry pressure: the load is not determined by an approach beyond the mean plane.
constexpr bool beyond_mean_plane(double compression, double mean_height) { return compression > 0 && compression >= mean_height; }

}  // namespace rc
