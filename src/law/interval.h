// A law between two neighbouring nodes: two parabolas.
#pragma once

#include <roughcontact/law.h>

#include <optional>

namespace rc {

struct LawPart {
  double length = 0;
  double first = 0, last = 0;  // slopes at its ends

  double half_bend() const { return length > 0 ? (last - first) / (2 * length) : 0; }
  double rise() const { return length * (first + last) / 2; }
  double energy(double p) const { return length * (p + length * (2 * first + last) / 6); }  // from the pressure p on
};

struct LawInterval {
  LawPart before, after;

  double energy(double p) const { return before.energy(p) + after.energy(p + before.rise()); }
};

// Where the tangents of both nodes meet: C1, and the slope at the knot is the chord's. If they meet at a node, the exact curve
// has a kink there: one parabola, whose slope jumps at that node. Nothing if they meet elsewhere or p would fall.
std::optional<LawInterval> with_tangents(const rc_law_point& node, const rc_law_point& next);
// C1, with the values and slopes of both nodes, and its knot at this share of the interval, > 0 and < 1. Nothing if p would fall.
std::optional<LawInterval> with_knot(const rc_law_point& node, const rc_law_point& next, double share);
LawInterval chord_between(const rc_law_point& node, const rc_law_point& next);
// From the origin, where nothing touches, to the first node: has that node's value and slope, is convex, and has its energy. Its
// slope jumps at the origin or at the knot where the energy asks for it.
LawInterval up_to_first(const rc_law_point& node);

}  // namespace rc
