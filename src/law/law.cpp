#include "law/law.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/error.h"
#include "core/limits.h"
#include "law/table.h"

namespace rc {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

// How far p may be from the chord between two nodes, see law_table_node.
struct LawBow {
  double above = 0, below = 0;
};

// docs/development/derivation.md, Laws with a hardness. Stiffnesses are per nominal area, of the patch itself.
LawBow bow_of(const rc_law_point& node, const rc_law_point& next, double bulk_yield) {
  if (node.bounds == RC_LAW_MONOTONE) return {};
  const auto stiffness = [&](double slope) { return slope / (1 + bulk_yield * slope); };
  const double low = stiffness(node.between_lower), high = stiffness(node.between_upper), h = next.x - node.x;
  const auto lost = [&](double first, double second) {  // of the slope, if at most the larger of both is lost of the stiffness
    const double least = std::max(0.0, high - std::max(first, second));
    return h * (node.between_upper - least / (1 - bulk_yield * least));
  };
  return {node.bounds == RC_LAW_CONVEX ? 0 : lost(stiffness(node.slope_upper) - low, high - stiffness(next.slope_lower)),
          lost(high - stiffness(node.slope_lower), stiffness(next.slope_upper) - low)};
}

// The bounds of p between two nodes: the parabolas of which roughcontact_law_envelope takes the largest and the smallest.
class LawEnvelope {
 public:
  LawEnvelope(const rc_law_point& node, const rc_law_point& next, LawBow bow) : p_(node.p), length_(next.x - node.x) {
    const double h = length_, low = std::max(0.0, node.between_lower), high = node.between_upper;
    lower_ = {{node.p_lower, low, 0}};
    upper_ = {{next.p_upper - low * h, low, 0}};
    if (high >= largest) return;
    const auto bowed = [h](double first, double last, double above) {
      return Parabola{first, (last - first + above) / h, -above / h / h};
    };
    lower_.insert(lower_.end(), {{next.p_lower - high * h, high, 0}, bowed(node.p_lower, next.p_lower, -bow.below)});
    upper_.insert(upper_.end(), {{node.p_upper, high, 0}, bowed(node.p_upper, next.p_upper, bow.above)});
  }

  // Whether the curve is inside everywhere, but for round-off: its distance from each parabola is a parabola on each part, and is
  // least at an end or at its vertex.
  bool hold(const LawInterval& curve) const {
    const double last = p_ + curve.before.rise() + curve.after.rise();
    const auto holds = [&](double sign, const Parabola& bound) {
      const double slack = 8 * epsilon * (last + std::abs(bound.slope) * length_);
      double at = 0, p = p_;
      for (const LawPart& part : {curve.before, curve.after}) {
        const Parabola between{sign * (p - bound.at(at)), sign * (part.first - bound.slope_at(at)),
                               sign * (part.half_bend() - bound.half_bend)};
        if (!(between.least(part.length) >= -slack)) return false;
        at += part.length;
        p += part.rise();
      }
      return true;
    };
    return std::all_of(lower_.begin(), lower_.end(), [&](const Parabola& bound) { return holds(1, bound); }) &&
           std::all_of(upper_.begin(), upper_.end(), [&](const Parabola& bound) { return holds(-1, bound); });
  }

 private:
  struct Parabola {
    double value, slope, half_bend;  // at 0

    double at(double t) const { return value + t * (slope + t * half_bend); }
    double slope_at(double t) const { return slope + 2 * t * half_bend; }
    double least(double length) const {  // from 0 to length
      const double vertex = half_bend > 0 ? -slope / (2 * half_bend) : -1;
      const double ends = std::min(value, at(length));
      return vertex > 0 && vertex < length ? std::min(ends, at(vertex)) : ends;
    }
  };

  double p_, length_;
  std::vector<Parabola> lower_, upper_;
};

law_table_node table_node(const rc_law_point& node, LawBow bow = {}) {
  return {.x = node.x,
          .p_lower = node.p_lower,
          .p_upper = node.p_upper,
          .between_lower = node.between_lower,
          .between_upper = std::min(node.between_upper, largest),
          .above = bow.above,
          .below = bow.below,
          .p = node.p,
          .area = node.area_fraction,
          .area_lower = node.area_lower,
          .area_upper = node.area_upper};
}

// The numbers of a table, as table.h describes them; head.conductance is given.
std::vector<double> table_of(law_table_head head, const std::vector<law_table_piece>& pieces,
                             const std::vector<law_table_node>& nodes) {
  const auto first = std::ranges::find_if(pieces, [](const law_table_piece& piece) { return piece.x > 0; });
  head.first_bucket = roughcontact_law_bucket(first->x);
  head.buckets = roughcontact_law_bucket(pieces.back().x) - head.first_bucket + 1;
  head.pieces = static_cast<double>(pieces.size());
  head.nodes = static_cast<double>(nodes.size());
  std::vector<double> numbers;
  const auto append = [&](const auto* records, std::size_t count) {
    const auto* begin = reinterpret_cast<const double*>(records);
    numbers.insert(numbers.end(), begin, begin + count * sizeof *records / sizeof *begin);
  };
  append(&head, 1);
  append(pieces.data(), pieces.size());
  append(nodes.data(), nodes.size());
  std::size_t piece = 0;
  for (int i = 0; i < static_cast<int>(head.buckets); ++i) {
    const auto lies_before = [&](double x) { return x <= 0 || roughcontact_law_bucket(x) < head.first_bucket + i; };
    while (piece + 1 < pieces.size() && lies_before(pieces[piece + 1].x)) ++piece;
    numbers.push_back(static_cast<double>(piece));
  }
  numbers.front() = static_cast<double>(numbers.size());
  return numbers;
}

double half_of(double lower, double upper) { return lower > 0 ? (upper / lower - 1) / 2 : HUGE_VAL; }

rc_status judged(const Law& law) {
  if (law.info.width > law.tolerance) return RC_STOP_STALLED;
  return law.info.bounds == RC_LAW_MONOTONE ? RC_UNCERTIFIED : RC_OK;
}

std::string remark_of(const Law& law) {
  switch (law.status) {
    case RC_STOP_MAX_ITER:
      return join("rc_law_spec.max_nodes did not allow the nodes that the tolerance needs: the law has ", law.info.nodes);
    case RC_STOP_STALLED:
      return join("double precision gives bounds of p within ", law.info.width, ", not ", law.tolerance);
    case RC_UNCERTIFIED:
      return "the tolerance is met by estimate: sets of points in contact or at the hardness give no proof between some nodes";
    default:
      return "";
  }
}

}  // namespace

// The upper bound is concave and the lower one convex, so their ratio has one maximum.
LawWidth widest(const rc_law_point& node, const rc_law_point& next, double bulk_yield) {
  const law_table_node first = table_node(node, bow_of(node, next, bulk_yield)), last = table_node(next);
  const auto half = [&](double share) {
    double lower = 0, upper = 0;
    const double x = std::min(next.x, node.x + share * (next.x - node.x));
    roughcontact_law_envelope(&first, &last, x, &lower, &upper);
    return half_of(lower, upper);
  };
  double low = 0, high = 1;
  while (high - low > 1e-9) {
    const double third = low + (high - low) / 3, other = high - (high - low) / 3;
    (half(third) < half(other) ? low : high) = half(third) < half(other) ? third : other;
  }
  return {(low + high) / 2, half((low + high) / 2)};
}

void admit_chord(rc_law_point& node, const rc_law_point& next) {
  if (node.bounds == RC_LAW_MONOTONE) return;
  const double h = next.x - node.x;
  node.between_lower = std::min({node.between_lower, (next.p - node.p_lower) / h, (next.p_upper - node.p) / h});
  node.between_upper = std::max({node.between_upper, (next.p_lower - node.p) / h, (next.p - node.p_upper) / h});
}

// The first of these curves that is inside the bounds: with the knot where the tangents meet, in the middle, ever nearer to a
// node; the chord.
LawInterval Law::curve_of(std::size_t i) const {
  const rc_law_point &node = nodes[i], &next = nodes[i + 1];
  const LawEnvelope bounds(node, next, bow_of(node, next, bulk_yield()));
  if (i == 0) {
    const LawInterval curve = up_to_first(next);
    return bounds.hold(curve) ? curve : chord_between(node, next);
  }
  if (const auto curve = with_tangents(node, next); curve && bounds.hold(*curve)) return *curve;
  for (int halvings = 1; halvings < 10; ++halvings)
    for (const double share = std::ldexp(1, -halvings); const double knot : {share, 1 - share})
      if (const auto curve = with_knot(node, next, knot); curve && bounds.hold(*curve)) return *curve;
  return chord_between(node, next);
}

void Law::finish() {
  std::vector<law_table_piece> pieces;
  std::vector<law_table_node> table_nodes;
  info.width = info.width_conductance = info.width_area = info.energy_error = 0;
  info.bounds = RC_LAW_CONVEX;
  double energy = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const rc_law_point& node = nodes[i];
    rc_law_point& next = nodes[i + 1];
    const LawInterval curve = curve_of(i);
    const LawPart &before = curve.before, &after = curve.after;
    pieces.push_back({node.x, node.p, before.first, before.half_bend(), energy});
    pieces.push_back({std::min(next.x, node.x + before.length), std::min(next.p, node.p + before.rise()), after.first,
                      after.half_bend(), energy + before.energy(node.p)});
    table_nodes.push_back(table_node(node, bow_of(node, next, bulk_yield())));
    energy += curve.energy(node.p);
    if (std::isnan(next.energy)) next.energy = energy;
    if (i == 0) continue;
    info.energy_error = std::max(info.energy_error, std::abs(energy / next.energy - 1));
    info.bounds = std::max(info.bounds, node.bounds);
    if (node.bounds != RC_LAW_MONOTONE) info.width = std::max(info.width, widest(node, next, bulk_yield()).half);
    info.width_conductance = std::max(info.width_conductance, half_of(node.between_lower, node.between_upper));
    info.width_area = std::max(info.width_area,
                               half_of(std::min(node.area_lower, next.area_lower), std::max(node.area_upper, next.area_upper)));
  }
  pieces.push_back({nodes.back().x, nodes.back().p, nodes.back().slope, 0, energy});
  table_nodes.push_back(table_node(nodes.back()));
  const bool convex =
      std::all_of(nodes.begin(), nodes.end() - 1, [](const rc_law_point& node) { return node.bounds == RC_LAW_CONVEX; });
  table = table_of(
      {.conductance = info.modulus > 0 ? 2 / info.modulus : nan, .hardness = info.hardness, .convex = convex ? 1.0 : 0.0}, pieces,
      table_nodes);
  info.nodes = static_cast<std::int64_t>(nodes.size());
  info.x_lower = nodes[1].x, info.p_lower = nodes[1].p;
  info.x_upper = nodes.back().x, info.p_upper = nodes.back().p;
  if (status == RC_OK) status = judged(*this);
  if (remark.empty()) remark = remark_of(*this);
}

}  // namespace rc
