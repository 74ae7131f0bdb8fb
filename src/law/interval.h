// A law between two neighbouring nodes: two parabolas.
#pragma once

#include <roughcontact/law.h>

#include <algorithm>

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
  double rise(double t) const {  // from its beginning to t
    const double first = std::min(t, before.length), second = t - first;
    return first * (before.first + first * before.half_bend()) + second * (after.first + second * after.half_bend());
  }
};

// C1, with the values and slopes of both nodes; the chord if no such curve rises. If the chord's slope is between theirs, the
// knot is where the tangents meet.
LawInterval between(const rc_law_node& node, const rc_law_node& next);
LawInterval chord_between(const rc_law_node& node, const rc_law_node& next);
// From the origin, where nothing touches, to the first node: has that node's value and slope, is convex, and has its energy. Its
// slope jumps at the origin or at the knot where the energy asks for it.
LawInterval up_to_first(const rc_law_node& node);

}  // namespace rc
