#include "picture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "picture_raster.h"
#include "text.h"
#include "units.h"

namespace cli {

namespace {

// Lengths in pixels, x from the left and y from the top.
constexpr double canvas_width = 1400, canvas_height = 700;
constexpr double title_y = 30, panel_title_gap = 46, unit_gap = 22;
constexpr double panel_width = 480, panel_height = 490, panel_centre_y = 360;
constexpr double panel_lefts[] = {98, 798};
constexpr double bar_gap = 16, bar_width = 20;

constexpr const char* contact_colour = "#e6002e";
constexpr unsigned char contact_rgba[] = {0xe6, 0x00, 0x2e, 0xff}, transparent_rgba[] = {0, 0, 0, 0};
constexpr const char* grey_palette = "0 '#262626', 1 '#f5f5f5'";
// Samples of matplotlib's inferno (CC0), which is perceptually uniform, from where it leaves black.
constexpr const char* pressure_palette =
    "0 '#1b0c41', 1 '#4a0c6b', 2 '#781c6d', 3 '#a52c60', 4 '#cf4446', 5 '#ed6925', 6 '#fb9b06', 7 '#f7d13d', 8 '#fcffa4'";

constexpr float not_drawn = std::numeric_limits<float>::quiet_NaN();

double screen_x(double x) { return x / canvas_width; }
double screen_y(double y) { return 1 - y / canvas_height; }

// The largest of 1, 2, 5 times a power of ten that is not above the value.
double round_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

// One panel: its box on the canvas and the surface in the display unit of length.
struct Panel {
  double left, top, width, height;
  double x_length, y_length;
  Prefix length;
  bool to_scale;

  Size size() const { return {std::llround(width), std::llround(height)}; }
};

Panel make_panel(const Surface& surface, double left) {
  const double x = *surface.hx * static_cast<double>(surface.nx), y = *surface.hy * static_cast<double>(surface.ny);
  const double scale = std::min(panel_width / x, panel_height / y);
  // A profile of one row would be too thin to see; it is drawn as a band.
  const double width = std::max(std::round(scale * x), 120.0), height = std::max(std::round(scale * y), 150.0);
  const Prefix length = prefix_for(std::max(x, y));
  const bool to_scale = width < scale * x + 1 && height < scale * y + 1;
  return {left + std::round((panel_width - width) / 2),
          std::round(panel_centre_y - height / 2),
          width,
          height,
          x / length.factor,
          y / length.factor,
          length,
          to_scale};
}

std::string frame(const Panel& panel) {
  const double step_x = round_down(panel.x_length / std::max(panel.width / 90, 1.0));
  const double step_y = round_down(panel.y_length / std::max(panel.height / 60, 1.0));
  const double step = panel.to_scale ? std::max(step_x, step_y) : 0;
  std::string text;
  text += format("set lmargin at screen %.6f\nset rmargin at screen %.6f\n", screen_x(panel.left),
                 screen_x(panel.left + panel.width));
  text +=
      format("set tmargin at screen %.6f\nset bmargin at screen %.6f\n", screen_y(panel.top), screen_y(panel.top + panel.height));
  // Row 0 is at the top, as in Gwyddion.
  text += format("set xrange [0:%.9g]\nset yrange [%.9g:0]\n", panel.x_length, panel.y_length);
  text += format("set xtics out nomirror %.9g offset 0,0.2\nset ytics out nomirror %.9g offset 0.4,0\n", std::max(step, step_x),
                 std::max(step, step_y));
  text += format("set xlabel 'x [%sm]' offset 0,0.3\nset ylabel 'y [%sm]%s' offset 1.8,0\n", panel.length.symbol.c_str(),
                 panel.length.symbol.c_str(), panel.to_scale ? "" : ", stretched");
  return text;
}

std::string colour_bar(const Panel& panel, const char* palette, double low, double high, const std::string& unit) {
  const double left = panel.left + panel.width + bar_gap;
  std::string text = format("set palette defined (%s)\nset cbrange [%.9g:%.9g]\n", palette, low, high);
  text += format("set colorbox vertical user origin screen %.6f,%.6f size screen %.6f,%.6f front\n", screen_x(left),
                 screen_y(panel.top + panel.height), bar_width / canvas_width, panel.height / canvas_height);
  text += format("set cbtics out nomirror %.9g offset -0.5,0\n", round_down((high - low) / (panel.height / 100)));
  text += format("set label 3 '%s' at screen %.6f,%.6f left\n", unit.c_str(), screen_x(left), screen_y(panel.top - unit_gap));
  return text;
}

std::string panel_title(const Panel& panel, const std::string& title) {
  return format("set label 1 '%s' at screen %.6f,%.6f left\n", title.c_str(), screen_x(panel.left),
                screen_y(panel.top - panel_title_gap));
}

// Below the colour bar, where it hides nothing.
std::string scale_bar(const Panel& panel) {
  const double length = round_down(0.3 * panel.x_length);
  const double right = panel.left + panel.width + bar_gap + bar_width + 35, left = right - length / panel.x_length * panel.width;
  const double y = panel.top + panel.height + 73;
  const Prefix prefix = prefix_for(length * panel.length.factor);
  std::string text = format("set arrow 1 from screen %.6f,%.6f to screen %.6f,%.6f nohead linewidth 6 linecolor rgb 'black'\n",
                            screen_x(left), screen_y(y), screen_x(right), screen_y(y));
  text += format("set label 2 '%g %sm' at screen %.6f,%.6f center\n", length * panel.length.factor / prefix.factor,
                 prefix.symbol.c_str(), screen_x((left + right) / 2), screen_y(y - 17));
  return text;
}

// Where gnuplot is to put the cells of a raster, as options of `plot '-' binary`.
std::string placement(const Panel& panel, const Raster& raster) {
  const double dx = panel.x_length / static_cast<double>(raster.nx), dy = panel.y_length / static_cast<double>(raster.ny);
  return format("array=(%lld,%lld) dx=%.9g dy=%.9g origin=(%.9g,%.9g)", static_cast<long long>(raster.nx),
                static_cast<long long>(raster.ny), dx, dy, dx / 2, dy / 2);
}

std::string bytes(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

// Contact cells in the contact colour, all others transparent.
std::string contact_overlay(const Raster& pressure) {
  std::string rgba;
  for (const float p : pressure.values) {
    const bool contact = p > 0;
    rgba.append(reinterpret_cast<const char*>(contact ? contact_rgba : transparent_rgba), 4);
  }
  return rgba;
}

std::string title(const Picture& picture) {
  const rc_result& r = picture.step.result;
  const bool good = r.status == RC_OK || r.status == RC_WITHIN_GOAL;
  const char* const status = r.status == RC_OK ? "certified" : good ? "within accuracy" : rc_status_name(r.status);
  const std::string margin =
      r.status == RC_WITHIN_GOAL ? format(" +- %.2g %% of it", 100 * picture.step.accuracy.area_estimate) : "";
  const Prefix force = prefix_for(r.load), length = prefix_for(r.approach);
  return format(
      "set label 10 'step %d of %zu    approach %.3g %sm    load %.3g %sN    contact area %.3g %%%s    %s' "
      "at screen 0.5,%.6f center font ',20' noenhanced textcolor rgb '%s'\n",
      picture.step.number, picture.steps, r.approach / length.factor, length.symbol.c_str(), r.load / force.factor,
      force.symbol.c_str(), 100 * picture.step.area_fraction(), margin.c_str(), status, screen_y(title_y),
      good ? "black" : contact_colour);
}

// The value that this fraction of all values does not exceed.
float quantile(std::vector<float> values, double fraction) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Excluded points have no height.
template <class Number> std::vector<Number> without_nan(const std::vector<Number>& values) {
  std::vector<Number> present;
  std::ranges::copy_if(values, std::back_inserter(present), [](Number value) { return !std::isnan(value); });
  return present;
}

std::string height_panel(const Surface& surface, const Raster& pressure) {
  const Panel panel = make_panel(surface, panel_lefts[0]);
  const std::vector<double> present = without_nan(surface.heights);
  const double mean = std::accumulate(present.begin(), present.end(), 0.0) / static_cast<double>(present.size());
  const auto [lowest, highest] = std::ranges::minmax(present);
  const Prefix prefix = prefix_for(highest - lowest);
  std::vector<double> relative;
  relative.reserve(surface.heights.size());
  for (const double z : surface.heights) relative.push_back((z - mean) / prefix.factor);
  const Raster heights = block_mean(relative, surface.nx, surface.ny, panel.size());

  // A few outliers must not take all the contrast.
  const std::vector<float> shown = without_nan(heights.values);
  const float dark = quantile(shown, 0.002), bright = quantile(shown, 0.998);
  const float margin = bright > dark ? 0.0f : 1.0f;

  std::string text = frame(panel) + scale_bar(panel) + panel_title(panel, "height above mean, {/:Bold contact in red}");
  text += colour_bar(panel, grey_palette, dark - margin, bright + margin, prefix.symbol + "m");
  text += "plot '-' binary " + placement(panel, heights) + " format='%float32' with image notitle, '-' binary " +
          placement(panel, pressure) + " format='%uchar%uchar%uchar%uchar' using 1:2:3:4 with rgbalpha notitle\n";
  return text + bytes(heights.values) + contact_overlay(pressure);
}

// The colours end below the maximum, because a few cells on a sharp edge may be far above all others.
double bright_pressure(const Raster& pressure) {
  std::vector<float> contacts;
  std::ranges::copy_if(pressure.values, std::back_inserter(contacts), [](float p) { return p > 0; });
  return contacts.empty() ? 1 : static_cast<double>(quantile(contacts, 0.99));
}

std::string pressure_panel(const Surface& surface, Raster pressure, double largest) {
  const Panel panel = make_panel(surface, panel_lefts[1]);
  const double bright = bright_pressure(pressure);
  const Prefix prefix = prefix_for(bright), largest_prefix = prefix_for(largest);
  for (float& p : pressure.values) p = p > 0 ? static_cast<float>(static_cast<double>(p) / prefix.factor) : not_drawn;
  const std::string title =
      largest > 0 ? format("pressure, maximum %.3g %sPa", largest / largest_prefix.factor, largest_prefix.symbol.c_str())
                  : "pressure: no contact";

  std::string text = frame(panel) + scale_bar(panel) + panel_title(panel, title);
  text += colour_bar(panel, pressure_palette, 0, bright / prefix.factor, prefix.symbol + "Pa");
  text += "plot '-' binary " + placement(panel, pressure) + " format='%float32' with image notitle\n";
  return text + bytes(pressure.values);
}

}  // namespace

Gnuplot draw_picture(const Picture& picture, std::FILE* file) {
  const Surface& surface = picture.surface;
  const Size size = make_panel(surface, 0).size();
  Raster pressure = block_max(picture.pressure, surface.nx, surface.ny, size);
  grow_small_spots(pressure, size);
  const double largest = *std::ranges::max_element(picture.pressure);

  std::string script =
      format("set terminal pngcairo size %.0f,%.0f font 'Sans,16' background rgb 'white'\n", canvas_width, canvas_height);
  script += "set encoding utf8\nset border linewidth 1.2\nset multiplot\n" + title(picture);
  script +=
      height_panel(surface, pressure) + "unset label 10\n" + pressure_panel(surface, pressure, largest) + "unset multiplot\n";

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::tmpfile(), std::fclose};
  if (!stream) return {false, false, "no temporary file"};
  std::fwrite(script.data(), 1, script.size(), stream.get());
  return run_gnuplot(stream.get(), file);
}

}  // namespace cli
