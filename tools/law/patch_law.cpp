#include "law/patch_law.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace cli {

namespace {

void to_si(rc_law_point& at, const LawUnits& units) {
  at.x *= units.length;
  for (double* const p : {&at.p, &at.p_lower, &at.p_upper}) *p *= units.pressure();
  for (double* const slope : {&at.slope, &at.slope_lower, &at.slope_upper, &at.between_lower, &at.between_upper})
    *slope *= units.pressure() / units.length;
  at.energy *= units.pressure() * units.length;
  for (double* const conductance : {&at.conductance, &at.conductance_lower, &at.conductance_upper}) *conductance /= units.length;
}

}  // namespace

double LawRow::half_width() const {
  if (!(at.p > 0)) return 0;
  return std::isfinite(at.p_upper) ? (at.p_upper - at.p_lower) / (2 * at.p) : std::numeric_limits<double>::infinity();
}

LawRow PatchLaw::row(double x) const {
  LawRow found{RC_LAW_POINT_INIT, false};
  rc_law_point& at = found.at;
  const rc_status given = rc_law_evaluate(handle.get(), x / units.length, &at);
  check(given, "--at");
  found.beyond = given == RC_OUTSIDE;
  to_si(at, units);
  return found;
}

LawRow PatchLaw::row_at_pressure(double p) const {
  double x = 0;
  check(rc_law_overclosure(handle.get(), p / units.pressure(), &x), "--at");
  return row(x * units.length);
}

std::vector<rc_law_point> PatchLaw::nodes() const {
  std::vector<rc_law_point> found(static_cast<std::size_t>(info.nodes), RC_LAW_POINT_INIT);
  for (std::size_t i = 0; i < found.size(); ++i) {
    rc_law_point& node = found[i];
    check(rc_law_describe_node(handle.get(), static_cast<std::int64_t>(i), &node), "");
    to_si(node, units);
  }
  return found;
}

std::vector<LawRow> PatchLaw::rows(int count) const {
  std::vector<LawRow> found;
  const double lower = info.p_lower * units.pressure(), ratio = std::log(info.p_upper / info.p_lower) / (count - 1);
  for (int k = 0; k + 1 < count; ++k) found.push_back(row_at_pressure(lower * std::exp(ratio * k)));
  found.push_back(row(info.x_upper * units.length));
  return found;
}

}  // namespace cli
