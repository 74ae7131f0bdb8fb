#include "pictures/law.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pictures/quarters.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace {

constexpr const char* curve_style = "with lines linewidth 3 linecolor rgb '#e6002e'";

// A curve of the law between its bounds on logarithmic axes, which reach as far as the curve.
class Curve {
 public:
  Curve(const char* name, double unit) : name_(name), unit_(unit) {}

  void add(double x, double y, double lower, double upper) {
    if (!(x > 0 && y > 0)) return;
    points_.push_back({x, y / unit_, lower / unit_, upper / unit_});
    least_ = std::min(least_, y / unit_);
    most_ = std::max(most_, y / unit_);
  }

  // Commands that precede the plot of its panel, and the plot.
  std::string data() const {
    std::string text = format("$%s << EOD\n", name_);
    // Bounds that are not known leave the panel.
    for (const auto& [x, y, lower, upper] : points_)
      text += format("%.9g %.9g %.9g %.9g\n", x, y, std::max(lower, least_ / 100), std::min(upper, most_ * 100));
    return text + "EOD\n" + (points_.empty() ? "" : format("set yrange [%.9g:%.9g]\n", least_ / 1.5, most_ * 1.5));
  }
  std::string plot(const char* title) const {
    if (points_.empty()) return "plot NaN notitle";
    return format("plot $%s using 1:3:4 with filledcurves linecolor rgb '#f6b0bc' title 'bounds', $%s using 1:2 %s title '%s'",
                  name_, name_, curve_style, title);
  }

 private:
  struct Point {
    double x, y, lower, upper;
  };

  const char* name_;
  double unit_, least_ = HUGE_VAL, most_ = 0;
  std::vector<Point> points_;
};

}  // namespace

Gnuplot draw_law(const PatchLaw& law, std::FILE* file) {
  constexpr int points = 400;
  const std::vector<LawRow> rows = law.rows(points);
  const rc_law_point& last = rows.back().at;
  const Prefix length = prefix_for(last.x), pressure = prefix_for(last.p);
  Curve pressures("pressures", pressure.factor), areas("areas", 0.01), conductances("conductances", 1);
  std::string widths = "$widths << EOD\n", nodes = "$nodes << EOD\n";
  for (const LawRow& row : rows) {
    const rc_law_point& at = row.at;
    const double x = at.x / length.factor, p = at.p / pressure.factor;
    pressures.add(x, at.p, at.p_lower, at.p_upper);
    areas.add(p, at.area_fraction, at.area_lower, at.area_upper);
    conductances.add(p, at.conductance, at.conductance_lower, at.conductance_upper);
    if (std::isfinite(row.half_width())) widths += format("%.9g %.9g\n", p, 100 * row.half_width());
  }
  for (const rc_law_point& node : law.nodes()) {
    if (node.p > 0) nodes += format("%.9g %.9g\n", node.x / length.factor, node.p / pressure.factor);
  }
  const std::string p_label = "pressure [" + pressure.symbol + "Pa]";
  return run_gnuplot(
      quarters(format("%lld nodes, p within %.2g %% from %s to %s", static_cast<long long>(law.info.nodes), 100 * law.info.width,
                      with_prefix(rows.front().at.p, "Pa").c_str(), with_prefix(last.p, "Pa").c_str())) +
          widths + "EOD\n" + nodes + "EOD\nset logscale xy\nset key top left\n" +
          quarter(0, "pressure against overclosure", "overclosure [" + length.symbol + "m]", p_label) + pressures.data() +
          pressures.plot("law") +
          ", $nodes using 1:2 with points pointtype 7 pointsize 0.6 linecolor rgb '#303030' title 'nodes'\n" +
          quarter(1, "contact area", p_label, "share of the nominal area [%]") + areas.data() + areas.plot("area") + "\n" +
          quarter(2, "conductance, times {/Symbol r}_1 + {/Symbol r}_2", p_label, "2 slope/E* [1/m]") + conductances.data() +
          conductances.plot("2 slope/E*") + "\n" + quarter(3, "half-width of the bounds of p", p_label, "share of p [%]") +
          "unset logscale y\nset yrange [0:*]\nset key off\nplot $widths using 1:2 with lines linecolor rgb '#e6002e'\n" +
          "unset multiplot\n",
      file);
}

}  // namespace cli
