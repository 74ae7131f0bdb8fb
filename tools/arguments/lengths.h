// Units and pitches given on the command line.
#pragma once

#include <optional>
#include <string>

#include "arguments/quantities.h"
#include "surface/surface.h"

namespace cli {

// Metres per --unit, 1 where it was not given.
double length_unit(const std::optional<std::string>& name);

struct Pitch {
  Quantity x, y;
};

// --pitch, of which numbers alone are in `unit`.
std::optional<Pitch> pitch_argument(const std::optional<std::string>& text, double unit);

// Puts the given pitch into the surface, or checks that the file has one. Returns a note for the user, or "".
std::string settle_pitch(const std::optional<Pitch>& given, const std::string& file, Surface& surface);

}  // namespace cli
