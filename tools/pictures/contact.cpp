#include "pictures/contact.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>

#include "pictures/panel.h"
#include "pictures/raster.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace {

constexpr Colour contact_colour{0xe6, 0x00, 0x2e}, excluded_colour{0xcc, 0xe0, 0xf5}, ring_colour{0x4d, 0xd2, 0xff};
constexpr Colour open_colour{0x14, 0x14, 0x1c};  // on which the hottest spots stand out

Palette greys() { return {{{0x26, 0x26, 0x26}, {0xf5, 0xf5, 0xf5}}}; }

// Samples of matplotlib's inferno (CC0), which is perceptually uniform, from where it is lighter than what is open.
Palette inferno() {
  return {{{0x78, 0x1c, 0x6d},
           {0xa5, 0x2c, 0x60},
           {0xcf, 0x44, 0x46},
           {0xed, 0x69, 0x25},
           {0xfb, 0x9b, 0x06},
           {0xf7, 0xd1, 0x3d},
           {0xfc, 0xff, 0xa4}}};
}

void append(const Colour& colour, std::string& bytes) {
  for (const double part : {colour.red, colour.green, colour.blue})
    bytes += static_cast<char>(static_cast<unsigned char>(std::lround(part)));
}

std::string title(const Picture& picture, const Layout& layout) {
  const rc_result& r = picture.step.result;
  const char* const status = r.status == RC_OK ? "certified" : picture.step.good() ? "within accuracy" : rc_status_name(r.status);
  const std::string margin =
      r.status == RC_WITHIN_GOAL ? format(" +- %.2g %% of it", 100 * picture.step.result.area_estimate) : "";
  const double middle = static_cast<double>(layout.canvas().width) / 2;
  const auto line = [&](int number, const std::string& text, double y, const std::string& colour) {
    return format("set label %d '%s' at screen %s center font ',20' noenhanced textcolor rgb '%s'\n", number, text.c_str(),
                  layout.screen(middle, y).c_str(), colour.c_str());
  };
  const std::string forces = "load " + with_prefix(r.load, "N") + "    mean pressure " + with_prefix(r.mean_pressure, "Pa");
  const std::string lengths = "approach " + with_prefix(r.approach, "m") +
                              format("    contact area %.3g %%", 100 * picture.step.result.area_fraction) + margin;
  const std::string head = line(10, format("step %d of %zu, %s", picture.step.number, picture.steps, status), 28,
                                picture.step.good() ? "black" : contact_colour.text());
  if (!layout.narrow()) return head + line(11, forces + "    " + lengths, 60, "black");
  return head + line(11, forces, 60, "black") + line(12, lengths, 92, "black");
}

// The value that this fraction of all values does not exceed.
double quantile(std::vector<double> values, double fraction) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Heights in grey, and over them each pixel's share of contact in red.
std::string height_panel(const Pressed& surface, const Layout& layout, const std::vector<double>& contact) {
  const auto means = [&](auto value) { return pixel_means(surface.nx, surface.ny, layout.panel(), value); };
  const std::vector<double> present = means([&](std::size_t i) { return std::isnan(surface.heights[i]) ? 0 : 1; });
  const std::vector<double> sums = means([&](std::size_t i) { return std::isnan(surface.heights[i]) ? 0 : surface.heights[i]; });
  std::vector<double> shown;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (present[i] > 0) shown.push_back(sums[i] / present[i]);
  }
  const double mean = std::accumulate(shown.begin(), shown.end(), 0.0) / static_cast<double>(shown.size());
  // A few outliers must not take all the contrast.
  double dark = quantile(shown, 0.002) - mean, bright = quantile(shown, 0.998) - mean;
  const Prefix prefix = prefix_for(bright - dark);
  if (!(bright > dark)) {
    dark -= prefix.factor;
    bright += prefix.factor;
  }

  const Palette palette = greys();
  std::string bytes;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double height = present[i] > 0 ? sums[i] / present[i] - mean : 0;
    const Colour ground = excluded_colour.mixed(palette.at((height - dark) / (bright - dark)), present[i]);
    append(ground.mixed(contact_colour, contact[i]), bytes);
  }
  return layout.frame(0, "height above mean [" + prefix.symbol + "m]",
                      std::string("{/:Bold contact in red}") + (present.size() == shown.size() ? "" : ", excluded in blue")) +
         layout.colour_bar(0, palette, dark / prefix.factor, bright / prefix.factor) + layout.image() + bytes;
}

// The colours end below the maximum, because a few cells on a sharp edge may be far above all others.
double bright_pressure(const std::vector<double>& pressure) {
  std::vector<double> contacts;
  std::ranges::copy_if(pressure, std::back_inserter(contacts), [](double p) { return p > 0; });
  return contacts.empty() ? 1 : quantile(std::move(contacts), 0.99);
}

// A ring around the largest pressure; of several points that carry it, around the first.
std::string ring(const Pressed& surface, const Layout& layout, std::size_t point) {
  const std::int64_t x = static_cast<std::int64_t>(point) % surface.nx, y = static_cast<std::int64_t>(point) / surface.nx;
  const auto place = [](std::int64_t i, std::int64_t count, std::int64_t pixels) {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(count) * static_cast<double>(pixels);
  };
  const Layout::Place corner = layout.corner(1);
  return format(
      "set object 1 circle at screen %s size screen %.6f fillstyle empty border rgb '%s' linewidth 2 front\n",
      layout.screen(corner.x + place(x, surface.nx, layout.panel().width), corner.y + place(y, surface.ny, layout.panel().height))
          .c_str(),
      12.0 / static_cast<double>(layout.canvas().width), ring_colour.text().c_str());
}

// Each pixel's mean pressure of its points in contact, faded by their share of the pixel.
std::string pressure_panel(const Picture& picture, const Layout& layout, const std::vector<double>& contact) {
  const Pressed& surface = picture.surface;
  const std::vector<double> sums =
      pixel_means(surface.nx, surface.ny, layout.panel(), [&](std::size_t i) { return picture.pressure[i]; });
  const double bright = bright_pressure(picture.pressure);
  const Palette palette = inferno();
  std::string bytes;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double pressure = contact[i] > 0 ? sums[i] / contact[i] : 0;
    append(open_colour.mixed(palette.at(pressure / bright), contact[i]), bytes);
  }
  const auto largest = std::ranges::max_element(picture.pressure);
  const Prefix prefix = prefix_for(bright);
  const auto points = std::ranges::count(picture.pressure, *largest);
  const std::string where =
      points == 1 ? " in the ring" : format(" at %lld points, one in the ring", static_cast<long long>(points));
  std::string text = layout.frame(1, "pressure [" + prefix.symbol + "Pa]",
                                  *largest > 0 ? "largest " + with_prefix(*largest, "Pa") + where : "no contact");
  if (*largest > 0) text += ring(surface, layout, static_cast<std::size_t>(largest - picture.pressure.begin()));
  return text + layout.colour_bar(1, palette, 0, bright / prefix.factor) + layout.image() + bytes;
}

}  // namespace

Gnuplot draw_picture(const Picture& picture, std::FILE* file) {
  const Layout layout{picture.surface};
  const std::vector<double> contact = pixel_means(picture.surface.nx, picture.surface.ny, layout.panel(),
                                                  [&](std::size_t i) { return picture.pressure[i] > 0 ? 1 : 0; });
  const std::string script =
      format("set terminal pngcairo size %lld,%lld font 'Sans,16' background rgb 'white'\n",
             static_cast<long long>(layout.canvas().width), static_cast<long long>(layout.canvas().height)) +
      "set encoding utf8\nset border back\nset multiplot\n" + title(picture, layout) +
      height_panel(picture.surface, layout, contact) + "unset label 10\nunset label 11\nunset label 12\n" +
      pressure_panel(picture, layout, contact) + "unset multiplot\n";
  return run_gnuplot(script, file);
}

}  // namespace cli
