#include "request/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "request/choices.h"
#include "request/names.h"
#include "request/quantities.h"

namespace rc::request {

namespace {

constexpr const char* forms = "give sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x";

constexpr std::string_view round_keys[] = {"R", "axis"}, wedge_keys[] = {"angle", "axis"}, axes[] = {"x", "y"};

double flank_angle(const std::string& option, std::string_view text) {
  if (to_number(text)) throw Error(option, ": angle ", in_quotes(text), " has no unit, give deg or rad");
  const double angle = read_positive(option + ": angle", text, Dimension::angle).si();
  if (!(angle < 3.14159265358979323846 / 2)) throw Error(option, ": angle ", in_quotes(text), " is not below 90deg");
  return angle;
}

}  // namespace

Shape parse_shape(const std::string& option, std::string_view text, double unit, bool& bare) {
  const auto colon = text.find(':');
  Shape shape;
  bare = false;
  shape.name = shape_names[choice(option, text.substr(0, colon), shape_names)];
  const bool wedge = shape.name == "wedge";
  if (colon == std::string_view::npos) throw Error(option, ": ", in_quotes(text), " has no size, ", forms);
  for (const std::string_view setting : split(text.substr(colon + 1), ',')) {
    const auto equals = setting.find('=');
    if (equals == std::string_view::npos) throw Error(option, ": ", in_quotes(setting), " has not the form key=value, ", forms);
    const std::string_view key = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (wedge) {
      choice(option, key, wedge_keys);
    } else {
      choice(option, key, round_keys);
    }
    if (key == "R") {
      const Quantity radius = read_positive(option + ": R", value, Dimension::length, unit);
      shape.radius = radius.si();
      bare = radius.bare;
    }
    if (key == "angle") shape.angle = flank_angle(option, value);
    if (key == "axis" && shape.name == "sphere") throw Error(option, ": a sphere has no axis");
    if (key == "axis") shape.along_x = choice(option + ": axis", value, axes) == 0;
  }
  if (!((wedge ? shape.angle : shape.radius) > 0)) throw Error(option, ": ", in_quotes(text), " has no size, ", forms);
  return shape;
}

void add_shape(const std::string& option, const Shape& shape, const ShapedGrid& grid, bool si, std::span<double> heights) {
  const auto in_words = [si](double length) { return si ? with_prefix(length, "m") : in_digits(length, 6); };
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto ix = static_cast<std::int64_t>(i) % grid.nx, iy = static_cast<std::int64_t>(i) / grid.nx + grid.first;
    const double x = (static_cast<double>(ix) - static_cast<double>(grid.nx - 1) / 2) * grid.hx;
    const double y = (static_cast<double>(iy) - static_cast<double>(grid.ny - 1) / 2) * grid.hy;
    const double across = shape.along_x ? y : x;
    if (shape.name == "wedge") {
      heights[i] -= std::abs(across) * std::tan(shape.angle);
      continue;
    }
    const double square = shape.name == "sphere" ? x * x + y * y : across * across;
    const double below = shape.radius * shape.radius - square;
    if (below < 0)
      throw Error(option, ": the surface reaches ", in_words(std::sqrt(square)),
                  " from its middle, beyond R = ", in_words(shape.radius));
    heights[i] -= square / (shape.radius + std::sqrt(below));  // exact where the distance is small
  }
}

void smooth_contact(const Shape& shape, const rc_system& system, double load, bool si, rc_smooth& out) {
  constexpr double pi = 3.14159265358979323846, unknown = std::numeric_limits<double>::quiet_NaN();
  const double x = static_cast<double>(system.nx) * system.hx, y = static_cast<double>(system.ny) * system.hy;
  const double length = shape.along_x ? x : y, across = shape.along_x ? y : x;
  out.side = shape.name == "sphere" ? std::min(x, y) : across;
  out.approach = out.max_pressure = unknown;
  if (shape.name == "wedge") {
    out.width = 2 * load / (length * system.modulus * std::tan(shape.angle));
  } else if (shape.name == "sphere") {
    const double a = std::cbrt(3 * load * shape.radius / (4 * system.modulus));
    out.width = 2 * a;
    out.approach = a * a / shape.radius;
    out.max_pressure = a > 0 ? 3 * load / (2 * pi * a * a) : 0;
  } else {
    const double a = std::sqrt(4 * load * shape.radius / (pi * length * system.modulus));
    out.width = 2 * a;
    out.max_pressure = a > 0 ? 2 * load / (pi * a * length) : 0;
  }
  if (!(out.width > out.side)) return;
  const auto in_words = [si](double each) { return si ? with_prefix(each, "m", 2) : in_digits(each, 2); };
  std::snprintf(out.remark, sizeof out.remark, "Hertz' contact of this shape and load is %s wide, the map %s: press a larger map",
                in_words(out.width).c_str(), in_words(out.side).c_str());
}

}  // namespace rc::request
