#include "surface/shapes.h"

#include <cmath>
#include <vector>

#include "arguments/choices.h"
#include "arguments/quantities.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "text.h"

namespace cli {

namespace {

constexpr const char* forms = "give sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x";

constexpr std::string_view round_keys[] = {"R", "axis"}, wedge_keys[] = {"angle", "axis"}, axes[] = {"x", "y"};

double flank_angle(std::string_view text) {
  if (to_number(text)) throw Error("--shape: angle ", in_quotes(text), " has no unit, give deg or rad");
  const double angle = read_positive("--shape: angle", text, Dimension::angle).si();
  if (!(angle < 3.14159265358979323846 / 2)) throw Error("--shape: angle ", in_quotes(text), " is not below 90deg");
  return angle;
}

// Depth of a circle of this radius below its highest point, at a distance from it; exact where the distance is small.
double depth(double radius, double square) {
  const double below = radius * radius - square;
  if (below < 0)
    throw Error("--shape: the surface reaches ", with_prefix(std::sqrt(square), "m"),
                " from its middle, beyond R = ", with_prefix(radius, "m"));
  return square / (radius + std::sqrt(below));
}

}  // namespace

Shape parse_shape(std::string_view text, double unit) {
  const auto colon = text.find(':');
  Shape shape;
  shape.name = shape_names[choice("--shape", text.substr(0, colon), shape_names)];
  const bool wedge = shape.name == "wedge";
  if (colon == std::string_view::npos) throw Error("--shape: ", in_quotes(text), " has no size, ", forms);
  for (const std::string_view setting : split(text.substr(colon + 1), ',')) {
    const auto equals = setting.find('=');
    if (equals == std::string_view::npos) throw Error("--shape: ", in_quotes(setting), " has not the form key=value, ", forms);
    const std::string_view key = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (wedge) {
      choice("--shape", key, wedge_keys);
    } else {
      choice("--shape", key, round_keys);
    }
    if (key == "R") shape.radius = read_positive("--shape: R", value, Dimension::length, unit).si();
    if (key == "angle") shape.angle = flank_angle(value);
    if (key == "axis" && shape.name == "sphere") throw Error("--shape: a sphere has no axis");
    if (key == "axis") shape.along_x = choice("--shape: axis", value, axes) == 0;
  }
  if (!((wedge ? shape.angle : shape.radius) > 0)) throw Error("--shape: ", in_quotes(text), " has no size, ", forms);
  return shape;
}

double contact_width(const Shape& shape, double load, double modulus, double length) {
  if (shape.name == "sphere") return 2 * std::cbrt(3 * load * shape.radius / (4 * modulus));
  if (shape.name == "wedge") return 2 * load / (length * modulus * std::tan(shape.angle));
  return 2 * std::sqrt(4 * load * shape.radius / (3.14159265358979323846 * length * modulus));
}

void add_shape(const Shape& shape, Surface& surface) {
  for (std::int64_t iy = 0; iy < surface.ny; ++iy) {
    for (std::int64_t ix = 0; ix < surface.nx; ++ix) {
      const double x = (static_cast<double>(ix) - static_cast<double>(surface.nx - 1) / 2) * *surface.hx;
      const double y = (static_cast<double>(iy) - static_cast<double>(surface.ny - 1) / 2) * *surface.hy;
      const double across = shape.along_x ? y : x;
      double& z = surface.heights[static_cast<std::size_t>(iy * surface.nx + ix)];
      if (shape.name == "wedge") {
        z -= std::abs(across) * std::tan(shape.angle);
      } else {
        z -= depth(shape.radius, shape.name == "sphere" ? x * x + y * y : across * across);
      }
    }
  }
}

}  // namespace cli
