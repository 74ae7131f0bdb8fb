// Physical quantities given on the command line: "39nm", "210 GPa", or a number alone; the unit and pitch of a
// surface.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/surface.h"
#include "units.h"

namespace cli {

struct Quantity {
  double number;
  double unit;  // SI units that the number counts

  double si() const { return unit * number; }
  // As a multiple of another unit of the same dimension; exact where it is the same unit.
  double in(double other) const { return unit == other ? number : unit * number / other; }
};

// `unit`: what a number alone counts. The Error for a text that is no number, not finite, or has a unit that is unknown or of
// another dimension names the option and says what was expected.
Quantity read_quantity(std::string_view option, std::string_view text, Dimension dimension, double unit = 1);
Quantity read_positive(std::string_view option, std::string_view text, Dimension dimension, double unit = 1);

// Several of them. Numbers with and without a unit in one list are refused, because either reading may be meant; 0 needs none.
std::vector<Quantity> read_quantities(std::string_view option, const std::vector<std::string_view>& texts, Dimension dimension,
                                      double unit = 1);

// Metres per --unit, 1 if it was not given.
double length_unit(const std::optional<std::string>& name);

struct Pitch {
  Quantity x, y;
  bool bare;  // without a unit
};

// --pitch, of which numbers alone are in `unit`.
std::optional<Pitch> pitch_argument(const std::optional<std::string>& text, double unit);

// Puts the given pitch into a surface that has none; refuses one that differs from the file's.
void settle_pitch(const std::optional<Pitch>& given, rc::formats::Surface& surface);

}  // namespace cli
