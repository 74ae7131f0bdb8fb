// Nominal shapes that are added to a roughness: sphere:R=1mm, cylinder:R=1mm,axis=x, wedge:angle=5deg,axis=x.
#pragma once

#include <roughcontact/request.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rc::request {

inline constexpr std::string_view shape_names[] = {"sphere", "cylinder", "wedge"};

// A checked shape: highest, 0, at the middle of the surface or along its axis.
struct Shape {
  std::string_view name;
  double radius = 0;    // sphere, cylinder [m]
  double angle = 0;     // of a wedge's flanks to the surface [rad]
  bool along_x = true;  // the axis of a cylinder, the ridge of a wedge
};

// Lengths without a unit count in `unit`. Throws an Error that begins with `option` and says what was expected. bare: set to
// whether its size has no unit.
Shape parse_shape(const std::string& option, std::string_view text, double unit, bool& bare);

// A grid of heights, of which `first` rows are left out before those at hand.
struct ShapedGrid {
  std::int64_t nx, ny;
  double hx, hy;
  std::int64_t first = 0;
};

// Adds the shape to the heights of whole rows. Throws an Error if the surface reaches beyond the sphere or cylinder. si: whether
// lengths are in metres.
void add_shape(const std::string& option, const Shape& shape, const ShapedGrid& grid, bool si, std::span<double> heights);

// The contact of the smooth body with a half-space of this system, and whether it fits on the map.
void smooth_contact(const Shape& shape, const rc_system& system, double load, bool si, rc_smooth& out);

}  // namespace rc::request
