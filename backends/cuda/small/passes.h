// Passes over one small contact that haar-cg does not have: its surface, its start, its certificate.
#pragma once

#include <cmath>

#include "core/certificate_terms.h"
#include "core/start_terms.h"
#include "kernels/passes.h"

namespace rc_cuda {

// The range of the gap over the points that are not masked.
struct Heights {
  double lowest = 1e300, highest = -1e300;
  Index included = 0;
  bool finite = true;
  RC_ANYWHERE void add(const Heights& other) {
    lowest = other.lowest < lowest ? other.lowest : lowest;
    highest = other.highest > highest ? other.highest : highest;
    included += other.included;
    finite = finite && other.finite;
  }
};
// Copies the gap.
struct TakeGap {
  const double* from;
  const std::uint8_t* mask;  // null: every point
  double* gap;
  std::uint8_t* state;
  RC_ANYWHERE Heights operator()(Index i) const {
    state[i] = !mask || mask[i] != 0 ? is_unknown : 0;
    gap[i] = state[i] != 0 ? from[i] : 0;
    return state[i] != 0 ? Heights{gap[i], gap[i], 1, std::isfinite(gap[i])} : Heights{};
  }
};
// The plastic indentation of a step: the overlap where the pressure is the hardness.
struct Indent {
  double* gap;
  const double *p, *product;
  const std::uint8_t* state;
  double cap, length, compression, lowest;
  RC_ANYWHERE Heights operator()(Index i) const {
    if (!(state[i] & is_unknown)) return {};
    const double depth = rc::plastic_depth(product[i] * length, compression, gap[i] - lowest);
    if (p[i] >= cap && depth > 0) gap[i] += depth;
    return {gap[i], gap[i], 1, std::isfinite(gap[i])};
  }
};

// Points below a height above the lowest, and the sum of their heights.
struct Below {
  double points = 0, heights = 0;
  RC_ANYWHERE void add(const Below& other) {
    points += other.points;
    heights += other.heights;
  }
};
struct LookBelow {
  const double* gap;
  const std::uint8_t* state;
  double lowest, height;
  RC_ANYWHERE Below operator()(Index i) const {
    if (!(state[i] & is_unknown) || !(gap[i] - lowest < height)) return {};
    return {1, gap[i] - lowest};
  }
};

// Pressures that grow with the overlap at u + 1 > 0.
struct Grown {
  double sum = 0, most = 0, within = 0;
  RC_ANYWHERE void add(const Grown& other) {
    sum += other.sum;
    most = other.most > most ? other.most : most;
    within += other.within;
  }
};
struct Grow {
  const double* u;
  double* p;
  const std::uint8_t* state;
  RC_ANYWHERE Grown operator()(Index i) const {
    p[i] = state[i] != 0 ? rc::cold_pressure(u[i]) : 0;
    return {p[i], p[i], p[i] > 0 ? 1.0 : 0.0};
  }
};
struct Even {
  double *p, value;
  const std::uint8_t* state;
  RC_ANYWHERE void operator()(Index i) const { p[i] = state[i] != 0 ? value : 0; }
};
// Pressures to start from.
struct Given {
  bool positive = false, finite = true;
  RC_ANYWHERE void add(const Given& other) {
    positive = positive || other.positive;
    finite = finite && other.finite;
  }
};
struct TakeStart {
  const double* from;
  double* p;
  RC_ANYWHERE Given operator()(Index i) const {
    p[i] = from[i];
    return {p[i] > 0, std::isfinite(p[i])};
  }
};

// Sums and extremes of pressures in the caller's unit; contact/proof/certificate.cpp has the same sums.
struct Ends {
  double sum = 0, largest = 0, least = 0;
  Index contacts = 0;
  RC_ANYWHERE void add(const Ends& other) {
    sum += other.sum;
    largest = other.largest > largest ? other.largest : largest;
    least = other.least < least ? other.least : least;
    contacts += other.contacts;
  }
};
struct FindEnds {
  const double* p;
  const std::uint8_t* state;
  RC_ANYWHERE Ends operator()(Index i) const {
    if (!(state[i] & is_unknown)) return {};
    const double size = p[i] < 0 ? -p[i] : p[i];
    return {p[i], size, p[i] < 0 ? p[i] : 0, p[i] > 0 ? 1 : 0};
  }
};
struct Violations {
  double dual = 0, complementarity = 0;
  bool finite = true;
  RC_ANYWHERE void add(const Violations& other) {
    dual = other.dual > dual ? other.dual : dual;
    complementarity = other.complementarity > complementarity ? other.complementarity : complementarity;
    finite = finite && other.finite;
  }
};
struct Violate {
  const double *p, *product, *gap;
  const std::uint8_t* state;
  double length, compression, lowest, largest, hardness, scale;  // product in units of length
  RC_ANYWHERE Violations operator()(Index i) const {
    if (!(state[i] & is_unknown)) return {};
    const double g = rc::deformed_gap(product[i] * length, compression, gap[i] - lowest);
    return {rc::dual_violation(g, p[i], hardness, scale), rc::complementarity_violation(g, p[i], largest, hardness, scale),
            std::isfinite(p[i]) && std::isfinite(g)};
  }
};

}  // namespace rc_cuda
