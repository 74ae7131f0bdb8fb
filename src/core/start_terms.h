// The terms of a start under a prescribed load: the estimate of its approach, and pressures that carry it. Code for a device,
// which starts many contacts at once, takes them from here as well; so they are constexpr.
#pragma once

#include <cmath>

#include "core/by_value.h"

namespace rc {

// The approach is estimated by a bed of springs, each as stiff as the bearing area's share of a flat punch of that area: near the
// truth for one asperity, and larger for many. Heights are above the lowest gap; the load is divided by the modulus and the root
// of a cell's area. These are templates because not every compiler has a constexpr root.
constexpr double bed_margin = 1.05;      // by which the estimate is multiplied
constexpr double bed_resolution = 0.02;  // error of the height found, over that height

// Whether the bed, pressed to this height, carries the load. points: how many lie below; heights: the sum of theirs.
template <class Real> constexpr bool bed_carries(Real load, Real height, Real points, Real heights) {
  return points > 0 && (height * points - heights) / std::sqrt(points) >= load;
}

// To what height all points carry the load.
template <class Real> constexpr Real full_bed_height(Real load, Real points, Real mean_height) {
  return (load * std::sqrt(points) + points * mean_height) / points;
}

// Pressures of a start grow with the penetration u at the estimated approach, in units of the compression there.
constexpr double cold_pressure(double u) { return larger_of(0.0, 1 + u); }

// Whether they are the same everywhere instead: many points overlap, or the largest one would reach the cap.
constexpr bool starts_everywhere(double overlapping, double points, double largest, double sum, double load, double cap) {
  constexpr double many = 0.25;
  return overlapping > many * points || largest * load >= cap * sum;
}

}  // namespace rc
