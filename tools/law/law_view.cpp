#include "law/law_view.h"

#include <cmath>
#include <cstdio>

#include "files/json_text.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace {

std::string percent(double share) {
  constexpr double least = 1e-5;
  if (!std::isfinite(share)) return "unknown";
  return share > 0 && share < least ? "< 0.001 %" : format("%.2g %%", 100 * share);
}

std::string width_of(double share) { return std::isfinite(share) ? "within " + percent(share) : "without bounds"; }

std::string bounds_name(int32_t bounds) {
  if (bounds == RC_LAW_CONVEX) return "convex";
  return bounds == RC_LAW_SLOPES ? "slopes" : "monotone";
}

// The width of the bounds, and why they hold.
std::string proof_of(const rc_law_info& info) {
  const std::string width = "p within " + percent(info.width);
  const std::string nested = " between nodes, whose contact sets are assumed to be nested";
  if (info.bounds == RC_LAW_CONVEX) return width + ", convex" + nested;
  if (info.bounds == RC_LAW_SLOPES) return width + ", by slopes" + nested;
  return width + " where it is proven; p only rises between some nodes";
}

std::string bulk_of(const PatchLaw& law) {
  if (law.info.bulk == RC_LAW_BULK_NONE) return "approach from first touch";
  if (law.info.bulk == RC_LAW_BULK_MEAN) return "change of the mean gap from first touch";
  return "approach from first touch, less load / (" +
         with_prefix(law.info.bulk_stiffness * law.units.force / law.units.length, "N/m") + ")";
}

void fact(const char* name, const std::string& value) { std::printf("  %-13s %s\n", name, value.c_str()); }

std::string law_line(const std::string (&cells)[7]) {
  constexpr std::size_t widths[] = {11, 11, 10, 13, 11, 11, 13};
  std::string line;
  for (std::size_t k = 0; k < std::size(cells); ++k) line += " " + right_aligned(cells[k], widths[k]);
  return line + "\n";
}

std::string law_line(const LawRow& row) {
  const rc_law_point& at = row.at;
  return law_line({with_prefix(at.x, "m", 4), with_prefix(at.p, "Pa", 4), percent(row.half_width()),
                   with_prefix(at.slope, "Pa/m", 4), with_prefix(at.energy, "N/m", 4), format("%.4g %%", 100 * at.area_fraction),
                   std::isnan(at.conductance) ? "none" : format("%.4g /m", at.conductance)});
}

void add_point(JsonText& document, const rc_law_point& at) {
  document.add({{"x", at.x},
                {"p", at.p},
                {"p_lower", at.p_lower},
                {"p_upper", at.p_upper},
                {"slope", at.slope},
                {"slope_lower", at.slope_lower},
                {"slope_upper", at.slope_upper},
                {"energy", at.energy},
                {"area_fraction", at.area_fraction},
                {"area_lower", at.area_lower},
                {"area_upper", at.area_upper},
                {"conductance", at.conductance},
                {"conductance_lower", at.conductance_lower},
                {"conductance_upper", at.conductance_upper},
                {"bounds", bounds_name(at.bounds)}});
}

}  // namespace

void print_law(const PatchLaw& law, const std::vector<LawRow>& rows) {
  const rc_law_info& info = law.info;
  const double length = law.units.length, pressure = law.units.pressure();
  std::printf("law of %s\n", law.source.c_str());
  fact("pressures", with_prefix(info.p_lower * pressure, "Pa", 4) + " to " + with_prefix(info.p_upper * pressure, "Pa", 4) +
                        ", overclosures " + with_prefix(info.x_lower * length, "m", 4) + " to " +
                        with_prefix(info.x_upper * length, "m", 4));
  fact("overclosure", bulk_of(law));
  const std::string conductance = info.modulus > 0 ? "conductance " + width_of(info.width_conductance) + ", " : "";
  fact("bounds", proof_of(info) + "; " + conductance + "area " + width_of(info.width_area));
  if (info.modulus > 0)
    fact("body", "E* " + with_prefix(info.modulus * pressure, "Pa", 4) +
                     (info.hardness > 0 ? ", hardness " + with_prefix(info.hardness * pressure, "Pa", 4) : ""));
  fact("patch", "nominal area " + with_prefix(info.area * length * length, "m^2", 4) + ", mean gap at first touch " +
                    with_prefix(info.mean_gap * length, "m", 4));
  fact("nodes", format("%lld, %lld contact problems", static_cast<long long>(info.nodes), static_cast<long long>(info.solves)) +
                    (info.seconds > 0 ? " in " + with_prefix(info.seconds, "s") : ""));
  std::fputs(law_line({"overclosure", "pressure", "+-", "slope", "energy", "area", "2 slope/E*"}).c_str(), stdout);
  for (const LawRow& row : rows) std::fputs(law_line(row).c_str(), stdout);
}

std::string law_document(const PatchLaw& law, const std::vector<LawRow>& rows) {
  const rc_law_info& info = law.info;
  const LawUnits& units = law.units;
  JsonText document;
  document.begin("units");
  document.add({{"length", "m"}, {"force", "N"}, {"pressure", "Pa"}});
  document.end();
  document.begin("law");
  document.add({{"source", law.source},
                {"assumed", law.assumed},
                {"status", rc_status_name(law.status)},
                {"message", law.remark},
                {"bounds", bounds_name(info.bounds)},
                {"nodes", info.nodes},
                {"solves", info.solves},
                {"seconds", info.seconds},
                {"width", info.width},
                {"width_conductance", info.width_conductance},
                {"width_area", info.width_area},
                {"energy_error", info.energy_error},
                {"modulus", info.modulus * units.pressure()},
                {"hardness", info.hardness * units.pressure()},
                {"area", info.area * units.length * units.length},
                {"bulk", info.bulk == RC_LAW_BULK_NONE   ? "none"
                         : info.bulk == RC_LAW_BULK_MEAN ? "mean"
                                                         : "given"},
                {"bulk_stiffness", info.bulk_stiffness * units.force / units.length},
                {"mean_gap", info.mean_gap * units.length},
                {"x_lower", info.x_lower * units.length},
                {"x_upper", info.x_upper * units.length},
                {"p_lower", info.p_lower * units.pressure()},
                {"p_upper", info.p_upper * units.pressure()}});
  document.end();
  document.begin("nodes", '[');
  for (const rc_law_point& node : law.nodes()) {
    document.begin(nullptr);
    add_point(document, node);
    document.end();
  }
  document.end();
  document.begin("rows", '[');
  for (const LawRow& row : rows) {
    document.begin(nullptr);
    add_point(document, row.at);
    document.add({{"beyond", row.beyond}});
    document.end();
  }
  document.end();
  return document.text();
}

}  // namespace cli
