#include "pictures/panel.h"

#include <algorithm>
#include <cmath>

#include "text.h"

namespace cli {

namespace {

// Lengths in pixels.
constexpr double usual_side = 520, longest_side = 1000, shortest_side = 80;
constexpr double left_margin = 115, right_margin = 150, top_margin = 56, bottom_margin = 78;
constexpr double head = 84, line_height = 32, title_height = 24;
constexpr double room_for_title = 740, room_for_half = 450;  // of a panel
constexpr double bar_gap = 16, bar_width = 20;

// The largest of 1, 2, 5 times a power of ten that is not above the value.
double round_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

// A whole number of pixels a point, or of points a pixel where there are too many points.
double whole_cells(double pixels, std::int64_t points) {
  const double count = static_cast<double>(points);
  return pixels >= count ? count * std::max(1.0, std::round(pixels / count)) : count / std::max(1.0, std::round(count / pixels));
}

}  // namespace

std::string Colour::text() const {
  return format("#%02x%02x%02x", static_cast<unsigned>(red), static_cast<unsigned>(green), static_cast<unsigned>(blue));
}

Colour Palette::at(double place) const {
  const double last = static_cast<double>(colours.size() - 1), at = std::clamp(place, 0.0, 1.0) * last;
  const auto below = static_cast<std::size_t>(std::min(std::floor(at), last - 1));
  return colours[below].mixed(colours[below + 1], at - static_cast<double>(below));
}

std::string Palette::text() const {
  std::string text;
  for (std::size_t k = 0; k < colours.size(); ++k) text += format("%s%zu '%s'", k == 0 ? "" : ", ", k, colours[k].text().c_str());
  return text;
}

Layout::Layout(const Pressed& surface) {
  const double x = surface.hx * static_cast<double>(surface.nx), y = surface.hy * static_cast<double>(surface.ny);
  double scale = std::min(usual_side / std::sqrt(x * y), longest_side / std::max(x, y));
  const double fitted = whole_cells(scale * x, surface.nx) / x;
  if (fitted * std::max(x, y) <= longest_side) scale = fitted;
  // A profile of one row would be too thin to see; it is drawn as a band.
  const double width = std::max(std::round(scale * x), shortest_side), height = std::max(std::round(scale * y), shortest_side);
  to_scale_ = width < scale * x + 1 && height < scale * y + 1;
  panel_ = {std::llround(width), std::llround(height)};
  stacked_ = width > 1.5 * height;
  const double across = left_margin + width + right_margin;
  narrow_ = across < room_for_title;
  head_ = head + (narrow_ ? line_height + title_height : 0);
  room_ = {std::max(across, room_for_half), top_margin + height + bottom_margin};
  canvas_ = {std::llround(stacked_ ? room_.x : 2 * room_.x), std::llround(head_ + (stacked_ ? 2 * room_.y : room_.y))};
  length_ = prefix_for(std::max(x, y));
  x_length_ = x / length_.factor;
  y_length_ = y / length_.factor;
}

Layout::Place Layout::corner(int panel) const {
  return {left_margin + (stacked_ ? 0 : panel * room_.x), head_ + top_margin + (stacked_ ? panel * room_.y : 0)};
}

std::string Layout::screen(double x, double y) const {
  return format("%.7f,%.7f", x / static_cast<double>(canvas_.width), 1 - y / static_cast<double>(canvas_.height));
}

std::string Layout::frame(int panel, const std::string& title, const std::string& more) const {
  const Place at = corner(panel);
  const double width = static_cast<double>(panel_.width), height = static_cast<double>(panel_.height);
  const auto margin = [](const char* side, double place) { return format("set %smargin at screen %.7f\n", side, place); };
  // Lines are drawn about the middle of a pixel: the border goes through those around the image, which is drawn pixel by pixel.
  const double border = 0.5;
  std::string text = margin("l", (at.x - border) / static_cast<double>(canvas_.width)) +
                     margin("r", (at.x + width + border) / static_cast<double>(canvas_.width)) +
                     margin("t", 1 - (at.y - border) / static_cast<double>(canvas_.height)) +
                     margin("b", 1 - (at.y + height + border) / static_cast<double>(canvas_.height));
  double step_x = round_down(x_length_ / std::max(width / 110, 1.0)), step_y = round_down(y_length_ / std::max(height / 75, 1.0));
  if (to_scale_ && std::max(step_x, step_y) <= std::min(x_length_, y_length_)) step_x = step_y = std::max(step_x, step_y);
  // The axes reach as far as the border, so that a pixel of the image is one of the picture.
  const double dx = border * x_length_ / width, dy = border * y_length_ / height;
  text += format("set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", -dx, x_length_ + dx, y_length_ + dy, -dy);
  text += format("set xtics out nomirror %.9g offset 0,0.2\nset ytics out nomirror %.9g offset 0.4,0\n", step_x, step_y);
  text += format("set xlabel 'x [%sm]' offset 0,0.3\nset ylabel 'y [%sm]%s' offset 1.4,0\n", length_.symbol.c_str(),
                 length_.symbol.c_str(), to_scale_ ? "" : ", stretched");
  return text + format("set label 1 \"%s,%s%s\" at screen %s left\n", title.c_str(), narrow_ ? "\\n" : " ", more.c_str(),
                       screen(at.x, at.y - 28 - (narrow_ ? title_height : 0)).c_str());
}

std::string Layout::colour_bar(int panel, const Palette& palette, double low, double high) const {
  const Place at = corner(panel);
  const double left = at.x + static_cast<double>(panel_.width) + bar_gap, height = static_cast<double>(panel_.height);
  std::string text = "set palette defined (" + palette.text() + format(")\nset cbrange [%.9g:%.9g]\n", low, high);
  text += format("set colorbox vertical user origin screen %s size screen %.7f,%.7f front\n", screen(left, at.y + height).c_str(),
                 bar_width / static_cast<double>(canvas_.width), height / static_cast<double>(canvas_.height));
  text += format("set cbtics out nomirror %.9g offset -0.5,0\n", round_down((high - low) / std::max(height / 100, 1.0)));
  return text;
}

std::string Layout::image() const {
  const double dx = x_length_ / static_cast<double>(panel_.width), dy = y_length_ / static_cast<double>(panel_.height);
  // The second plot, of nothing, has the colour bar drawn.
  return format(
      "plot '-' binary array=(%lld,%lld) dx=%.12g dy=%.12g origin=(%.12g,%.12g) format='%%uchar%%uchar%%uchar' "
      "using 1:2:3 with rgbimage notitle, NaN with points palette notitle\n",
      static_cast<long long>(panel_.width), static_cast<long long>(panel_.height), dx, dy, dx / 2, dy / 2);
}

}  // namespace cli
