// Nominal shapes that are added to a roughness: sphere:R=1mm, cylinder:R=1mm,axis=x, wedge:angle=5deg,axis=x.
#pragma once

#include <string>
#include <string_view>

#include "formats/surface.h"

namespace cli {

inline constexpr std::string_view shape_names[] = {"sphere", "cylinder", "wedge"};

// A checked --shape: highest, 0, at the middle of the surface or along its axis.
struct Shape {
  std::string_view name;
  double radius = 0;    // sphere, cylinder [m]
  double angle = 0;     // of a wedge's flanks to the surface [rad]
  bool along_x = true;  // the axis of a cylinder, the ridge of a wedge
};

// Lengths without a unit count in `unit`. Throws an Error that says what was expected.
Shape parse_shape(std::string_view text, double unit);

// The width of the contact of a smooth body of this shape with a half-space: Hertz for a sphere and a cylinder, Johnson (1985),
// equation 5.5, for a wedge. length: of the cylinder or wedge along its axis.
double contact_width(const Shape& shape, double load, double modulus, double length);

// Adds the shape to all heights. Throws an Error if the surface reaches beyond the sphere or cylinder.
void add_shape(const Shape& shape, rc::formats::Surface& surface);

}  // namespace cli
