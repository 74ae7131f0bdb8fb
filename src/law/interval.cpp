#include "law/interval.h"

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

LawInterval knotted(double length, double theta, double first, double middle, double last) {
  const double before = theta * length;
  return {{before, first, middle}, {length - before, middle, last}};
}

}  // namespace

LawInterval between(const rc_law_node& node, const rc_law_node& next) {
  const double length = next.x - node.x, chord = (next.p - node.p) / length, first = node.slope, last = next.slope;
  const double meet = std::abs(last - first) > 1e-14 * std::abs(last) ? (last - chord) / (last - first) : 0.5;
  // Within 1e-6 of an end the curve is a straight line up to a kink, at which a point is about to touch.
  if (meet > -1e-6 && meet < 1 + 1e-6) return knotted(length, std::clamp(meet, 0.0, 1.0), first, chord, last);
  const auto middle = [&](double theta) { return 2 * chord - theta * first - (1 - theta) * last; };
  if (middle(0.5) >= 0) return knotted(length, 0.5, first, middle(0.5), last);
  // A smaller share of the larger slope, so that p rises.
  const double theta = first > last ? std::min(0.5, chord / first) : 1 - std::min(0.5, chord / last);
  return middle(theta) >= 0 ? knotted(length, theta, first, middle(theta), last) : chord_between(node, next);
}

LawInterval chord_between(const rc_law_node& node, const rc_law_node& next) {
  const double length = next.x - node.x, chord = (next.p - node.p) / length;
  return knotted(length, 0.5, chord, chord, chord);
}

LawInterval up_to_first(const rc_law_node& node) {
  const double chord = node.p / node.x, last = std::max(node.slope, chord), part = chord / last;
  if (!(last > chord * (1 + 1e-9))) return knotted(node.x, 0.5, chord, chord, last);
  const double least =
      std::max(0.0, 2 * chord - last);  // the first slope of one parabola, or 0 if it cannot reach back to the origin
  // The energy rises with the choice. -1 .. 0: no pressure before the knot, then a parabola whose first slope falls from `last`.
  // 0 .. 1: C1, up to the knot where the tangents meet; nothing to choose if one parabola reaches the origin. 1 .. 2: ever
  // steeper from the origin on.
  const auto curve_of = [&](double choice) -> LawInterval {
    if (choice < 0) {
      const double jump = least - choice * (last - least), after = std::min(node.x, 2 * node.p / (jump + last));
      return {{node.x - after, 0, 0}, {after, jump, last}};
    }
    if (choice < 1 && least == 0) {
      const double theta = 1 - part - (1 - choice) * std::min(part, 1 - part);
      return knotted(node.x, theta, 0, std::max(0.0, 2 * chord - (1 - theta) * last), last);
    }
    const double first = least + (chord - least) * std::clamp(choice - 1, 0.0, 1 - 1e-9);
    return knotted(node.x, std::clamp((last - chord) / (last - first), 0.0, 1.0), first, chord, last);
  };
  double low = -1, high = 2;
  for (int i = 0; i < 60; ++i) {
    const double choice = (low + high) / 2;
    (curve_of(choice).energy(0) < node.energy ? low : high) = choice;
  }
  return curve_of((low + high) / 2);
}

}  // namespace rc
