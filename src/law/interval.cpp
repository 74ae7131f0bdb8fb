#include "law/interval.h"

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

constexpr double at_node = 1e-9;     // of a node's overclosure: a knot this near to it is at it
constexpr double short_part = 1e-7;  // of the overclosure: there a knot's round-off would change slopes
constexpr double noise = 1e-6;       // of an interval: by so little tangents that touch at a node may miss it

double chord_of(const rc_law_point& node, const rc_law_point& next) { return (next.p - node.p) / (next.x - node.x); }

LawInterval knotted(double length, double theta, double first, double middle, double last) {
  const double before = theta * length;
  return {{before, first, middle}, {length - before, middle, last}};
}

// The middle slope is the one with which p rises from node to node. A knot near a node is a double, so that the parabolas that
// are evaluated from it meet exactly. Nothing if p would fall.
std::optional<LawInterval> rising(const rc_law_point& node, const rc_law_point& next, double before) {
  const double length = next.x - node.x;
  if (std::min(before, length - before) < short_part * next.x) before = (node.x + before) - node.x;
  const double after = length - before;
  const double middle = 2 * chord_of(node, next) - (before / length) * node.slope - (after / length) * next.slope;
  if (!(middle >= 0)) return {};
  return LawInterval{{before, node.slope, middle}, {after, middle, next.slope}};
}

}  // namespace

std::optional<LawInterval> with_tangents(const rc_law_point& node, const rc_law_point& next) {
  const double length = next.x - node.x, chord = chord_of(node, next);
  const double theta = (next.slope - chord) / (next.slope - node.slope), before = theta * length, after = length - before;
  if (!(theta > -noise && theta < 1 + noise)) return {};
  if (before < after ? before < at_node * node.x : after < at_node * next.x)
    return rising(node, next, before < after ? 0 : length);
  if (std::min(before, after) < short_part * next.x) return rising(node, next, before);
  return knotted(length, theta, node.slope, chord, next.slope);
}

std::optional<LawInterval> with_knot(const rc_law_point& node, const rc_law_point& next, double share) {
  return rising(node, next, share * (next.x - node.x));
}

LawInterval chord_between(const rc_law_point& node, const rc_law_point& next) {
  const double chord = chord_of(node, next);
  return knotted(next.x - node.x, 0.5, chord, chord, chord);
}

LawInterval up_to_first(const rc_law_point& node) {
  const double chord = node.p / node.x, last = std::max(node.slope, chord), part = chord / last;
  if (!(last > chord * (1 + 1e-9))) return knotted(node.x, 0.5, chord, (3 * chord - last) / 2, last);
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
      const double theta = 1 - part - (1 - choice) * part;
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
