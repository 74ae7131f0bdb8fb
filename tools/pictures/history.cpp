#include "pictures/history.h"

#ifdef RC_COMMAND_SURFACE
#include <roughcontact/surface.h>
#endif

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "pictures/quarters.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace {

#ifdef RC_COMMAND_SURFACE

// The rms slope of a surface that Persson's theory is of: elastic, periodic, flat but for a roughness that is nearly Gaussian.
// Else 0.
double slope_for_persson(const Problem& problem) {
  constexpr double most_skewness = 1, least_kurtosis = 2.3, most_kurtosis = 5;  // 0 and 3 for a Gaussian, 1.5 for a wave
  if (problem.system.boundary != RC_BOUNDARY_PERIODIC || problem.system.hardness > 0 || problem.system.creep_terms > 0) return 0;
  if (problem.input.mask || !problem.input.shape.empty()) return 0;
  const Pressed& surface = problem.input.surface;
  auto map = on_grid(surface.nx, surface.ny, surface.hx, surface.hy, rc_surface_map RC_SURFACE_MAP_INIT);
  map.heights = surface.heights.data();
  map.periodic = surface.periodic.value_or(false) ? 1 : 0;
  rc_surface_statistics statistics = RC_SURFACE_STATISTICS_INIT;
  if (rc_surface_analyze(&map, &statistics) != RC_OK) return 0;
  const bool gaussian = std::abs(statistics.skewness) < most_skewness && statistics.kurtosis > least_kurtosis &&
                        statistics.kurtosis < most_kurtosis;
  return gaussian ? statistics.rms_slope : 0;
}

#else

double slope_for_persson(const Problem&) { return 0; }

#endif

using Value = double HistoryPoint::*;
using Steps = std::vector<HistoryPoint>;

double largest(const Steps& steps, Value value) {
  double most = 0;
  for (const HistoryPoint& step : steps) most = std::max(most, std::isfinite(step.*value) ? std::abs(step.*value) : 0);
  return most;
}

// Whether the values spread so far that steps would lie on top of each other on a plain axis.
bool spread(const Steps& steps, Value value) {
  constexpr double far = 30;
  const auto [least, most] = std::ranges::minmax(steps, {}, value);
  return least.*value > 0 && most.*value > far * least.*value;
}

// The same of times, of which those that are not positive have no place on a logarithmic axis.
bool times_spread(const Steps& steps) {
  Steps later;
  std::ranges::copy_if(steps, std::back_inserter(later), [](const HistoryPoint& step) { return step.time > 0; });
  return later.size() > 2 && spread(later, &HistoryPoint::time);
}

struct Axis {
  Value value;
  const char* name;
  Prefix unit;       // the factor that the value is divided by
  const char* base;  // "N"
  bool logarithmic;
};

std::string label(const Axis& axis) { return std::string(axis.name) + " [" + axis.unit.symbol + axis.base + "]"; }

bool of_time(const Axis& axis) { return axis.value == &HistoryPoint::time; }

// The lines between steps of growing, or of falling, load, in time all; steps without a value are left out.
std::string lines(const Steps& steps, const Axis& x, const Axis& y, bool falling) {
  std::string text;
  const auto point = [&](const HistoryPoint& step) {
    text += format("%.9g %.9g\n", step.*x.value / x.unit.factor, step.*y.value / y.unit.factor);
  };
  bool open = false;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const bool falls = !of_time(x) && k > 0 && steps[k].load < steps[k - 1].load;
    const bool known = std::isfinite(steps[k].*y.value), known_before = k > 0 && std::isfinite(steps[k - 1].*y.value);
    if (falls != falling || !known) {
      text += open ? "\n" : "";
      open = false;
      continue;
    }
    if (!open && known_before && falling) point(steps[k - 1]);
    if (!open && known_before && !falling && k > 1) point(steps[k - 1]);
    point(steps[k]);
    open = true;
  }
  return text;
}

// One panel of two by two, and the lines of the steps over the others.
std::string panel(int place, const char* title, const Axis& x, const Axis& y, const Steps& steps,
                  const std::string& others = "") {
  std::string text = quarter(place, title, label(x), label(y));
  for (const auto& [axis, letter] : {std::pair{&x, 'x'}, std::pair{&y, 'y'}}) {
    const double most = largest(steps, axis->value) / axis->unit.factor;
    text += axis->logarithmic ? format("set logscale %c\nset %crange [*:*]\n", letter, letter)
                              : format("unset logscale %c\nset %crange [0:%.9g]\n", letter, letter, most > 0 ? 1.06 * most : 1);
  }
  std::string plots = others;
  const auto curve = [&](bool falling, const char* name, const char* style) {
    const std::string points = lines(steps, x, y, falling);
    if (points.empty()) return;
    text += format("$%s%d << EOD\n", name, place) + points + "EOD\n";
    plots += (plots.empty() ? "" : ", ") +
             format("$%s%d using 1:2 with linespoints linewidth 2 %s title '%s'", name, place, style, name);
  };
  curve(false, of_time(x) ? "steps" : "loading", "pointtype 7 linecolor rgb '#e6002e'");
  curve(true, "unloading", "pointtype 9 dashtype 2 linecolor rgb '#0060c0'");
  return text + "plot " + (plots.empty() ? "NaN notitle" : plots) + "\n";
}

// The area less what cells that touch in part add, and Persson's up to half of the area. x: of the load, or of time.
std::string area_others(const Problem& problem, const Steps& steps, double area, const Axis& x, std::string& blocks) {
  const Prefix& force = x.unit;
  blocks = "$corrected << EOD\n";
  for (const HistoryPoint& step : steps) {
    if (std::isfinite(step.corrected_area))
      blocks += format("%.9g %.9g\n", step.*x.value / force.factor, 100 * step.corrected_area / area);
  }
  blocks += "EOD\n";
  std::string others;
  if (const double slope = slope_for_persson(problem); slope > 0) {
    // J. Chem. Phys. 115 (2001) 3840: A/A0 = erf(sqrt(2) p/(E* h')), h' the rms slope.
    const double scale = std::sqrt(2) * force.factor / (area * problem.system.modulus * slope);
    others =
        format("(erf(%.9g*x) < 0.5 ? 100*erf(%.9g*x) : NaN) with lines dashtype 3 linewidth 2 linecolor rgb '#303030' title ",
               scale, scale) +
        format("'Persson, slope %.3g', ", slope);
  }
  return others +
         "$corrected using 1:2 with points pointtype 6 pointsize 1.5 linecolor rgb '#3a8a3a' title 'corrected for cells'";
}

}  // namespace

Gnuplot draw_history(const Problem& problem, const std::vector<HistoryPoint>& steps, std::FILE* file) {
  const rc_system& system = problem.system;
  const double area = static_cast<double>(system.nx) * static_cast<double>(system.ny) * system.hx * system.hy;
  const bool wide = spread(steps, &HistoryPoint::load);
  const auto axis = [&](Value value, const char* name, const char* base, bool logarithmic) {
    return Axis{value, name, prefix_for(largest(steps, value)), base, logarithmic};
  };
  const Axis force = axis(&HistoryPoint::load, "load", "N", wide),
             depth = axis(&HistoryPoint::approach, "approach", "m", wide && spread(steps, &HistoryPoint::approach));
  const Axis share{
      &HistoryPoint::area_fraction, "contact area", {0.01, ""}, "%", wide && spread(steps, &HistoryPoint::area_fraction)};
  const Axis opening = axis(&HistoryPoint::mean_gap, "mean gap", "m", false),
             rate = axis(&HistoryPoint::stiffness, "stiffness", "N/m", wide && spread(steps, &HistoryPoint::stiffness));

  const bool timed = !problem.times.empty();
  const Axis time{&HistoryPoint::time, "time", {1, ""}, "s", times_spread(steps)}, &along = timed ? time : force;

  std::string blocks;
  const std::string others = area_others(problem, steps, area, along, blocks);
  return run_gnuplot(
      quarters(format("%zu steps, E* %s, nominal area %s, %s boundary", steps.size(), with_prefix(system.modulus, "Pa").c_str(),
                      with_prefix(area, "m^2").c_str(), name_of_boundary(system.boundary).data())) +
          blocks + "set key bottom right\n" + panel(0, "contact area", along, share, steps, others) + "set key top left\n" +
          panel(1, timed ? "load" : "load against approach", timed ? time : depth, force, steps) + "set key top right\n" +
          panel(2, "mean gap", along, opening, steps) + "set key bottom right\n" +
          panel(3, "stiffness dW/dd", along, rate, steps) + "unset multiplot\n",
      file);
}

}  // namespace cli
