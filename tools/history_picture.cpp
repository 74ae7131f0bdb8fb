#include "history_picture.h"

#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "text.h"
#include "units.h"

namespace cli {

namespace {

// The rms slope of the heights; 0 where points are missing or a shape is added.
double rms_slope(const Problem& problem) {
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = problem.system.nx;
  map.ny = problem.system.ny;
  map.hx = problem.system.hx;
  map.hy = problem.system.hy;
  map.heights = problem.input.surface.heights.data();
  map.periodic = problem.system.boundary == RC_BOUNDARY_PERIODIC ? 1 : 0;
  rc_surface_statistics statistics = RC_SURFACE_STATISTICS_INIT;
  if (!problem.input.mask.empty() || !problem.input.shape.empty() || rc_surface_analyze(&map, &statistics) != RC_OK) return 0;
  return statistics.rms_slope;
}

using Value = double (*)(const HistoryPoint&);

// One panel of three: its axes, and the values of the steps that have one, joined in the order of the steps.
std::string panel(int place, const char* title, const std::string& unit, double unit_factor, const Prefix& force,
                  const std::vector<HistoryPoint>& steps, const std::string& others, Value value) {
  std::string text = format("$steps%d << EOD\n", place);
  for (const HistoryPoint& step : steps) {
    if (std::isfinite(value(step))) text += format("%.9g %.9g\n", step.load / force.factor, value(step) / unit_factor);
  }
  text += "EOD\n";
  text += format("set lmargin at screen %.4f\nset rmargin at screen %.4f\n", 0.065 + place / 3.0, 0.315 + place / 3.0);
  text += format("set title '%s'\nset ylabel '%s' offset 0.8,0\nset xlabel 'load [%sN]'\n", title, unit.c_str(),
                 force.symbol.c_str());
  return text + "plot " + others +
         format("$steps%d using 1:2 with linespoints pointtype 7 linewidth 2 linecolor rgb '#e6002e' title 'steps'\n", place);
}

// Whether the loads spread so far that steps would lie on top of each other on a plain axis.
bool spread(const std::vector<HistoryPoint>& steps) {
  constexpr double far = 30;
  const auto [least, most] = std::ranges::minmax(steps, {}, &HistoryPoint::load);
  return least.load > 0 && most.load > far * least.load;
}

double largest(const std::vector<HistoryPoint>& steps, Value value) {
  double most = 0;
  for (const HistoryPoint& step : steps) most = std::max(most, std::isfinite(value(step)) ? std::abs(value(step)) : 0);
  return most;
}

}  // namespace

Gnuplot draw_history(const Problem& problem, const std::vector<HistoryPoint>& steps, std::FILE* file) {
  const rc_system& system = problem.system;
  const double area = static_cast<double>(system.nx) * static_cast<double>(system.ny) * system.hx * system.hy;
  const auto load = [](const HistoryPoint& step) { return step.load; };
  const auto gap = [](const HistoryPoint& step) { return step.mean_gap; };
  const auto stiffness = [](const HistoryPoint& step) { return step.stiffness; };
  const Prefix force = prefix_for(largest(steps, load)), length = prefix_for(largest(steps, gap));
  const Prefix stiff = prefix_for(largest(steps, stiffness));

  std::string script = "set terminal pngcairo size 1650,620 font 'Sans,15' background rgb 'white'\nset encoding utf8\n";
  script += format("set label 10 '%zu steps, E* %s, nominal area %.3g mm^2' at screen 0.5,0.955 center font ',19' noenhanced\n",
                   steps.size(), with_prefix(system.modulus, "Pa").c_str(), area * 1e6);
  script += "set multiplot\nset tmargin at screen 0.83\nset bmargin at screen 0.14\nset border linewidth 1.2\n";
  const bool logarithmic = spread(steps);
  script += "set grid linecolor rgb '#e0e0e0'\nset key bottom right\n";
  if (logarithmic) {
    const double least = std::ranges::min(steps, {}, &HistoryPoint::load).load;
    script += format("set logscale\nset xrange [%.9g:%.9g]\nset format x '%%g'\n", least / force.factor / 1.2,
                     1.2 * largest(steps, load) / force.factor);
  } else {
    script += format("set xrange [0:%.9g]\nset yrange [0:*]\n",
                     largest(steps, load) > 0 ? 1.03 * largest(steps, load) / force.factor : 1);
  }

  std::string others;
  std::string corrected = "$corrected << EOD\n";
  for (const HistoryPoint& step : steps) {
    if (std::isfinite(step.corrected_area))
      corrected += format("%.9g %.9g\n", step.load / force.factor, 100 * step.corrected_area / area);
  }
  script += corrected + "EOD\n";
  if (const double slope = rms_slope(problem); slope > 0) {
    // J. Chem. Phys. 115 (2001) 3840: A/A0 = erf(sqrt(2) p/(E* h')), h' the rms slope.
    const double scale = std::sqrt(2) * force.factor / (area * system.modulus * slope);
    others += format("100*erf(%.9g*x) with lines dashtype 2 linewidth 2 linecolor rgb '#303030' title 'Persson, slope %.3g', ",
                     scale, slope);
  }
  others += "$corrected using 1:2 with points pointtype 6 pointsize 1.5 linecolor rgb '#3070c0' title 'corrected for cells', ";
  script += panel(0, "contact area", "area [%]", 0.01, force, steps, others,
                  [](const HistoryPoint& step) { return step.area_fraction; });
  script += "unset label 10\nset key top right\nunset logscale y\nset yrange [0:*]\n";
  script += panel(1, "mean gap", "gap [" + length.symbol + "m]", length.factor, force, steps, "", gap);
  script +=
      std::string("set key bottom right\n") + (logarithmic ? "set logscale y\nset yrange [*:*]\nset format y '10^{%L}'\n" : "");
  script += panel(2, "stiffness", "dW/dd [" + stiff.symbol + "N/m]", stiff.factor, force, steps, "", stiffness);
  return run_gnuplot(script + "unset multiplot\n", file);
}

}  // namespace cli
