// Physical quantities as users write them: "39nm", "210 GPa", or a number alone.
#pragma once

#include <string_view>
#include <vector>

#include "request/units.h"

namespace rc::request {

struct Quantity {
  double number;
  double unit;        // SI units that the number counts
  bool bare = false;  // without a unit

  double si() const { return unit * number; }
  // As a multiple of another unit of the same dimension; exact where it is the same unit.
  double in(double other) const { return unit == other ? number : unit * number / other; }
};

// `unit`: what a number alone counts. The Error for a text that is no number, not finite, or has a unit that is unknown or of
// another dimension begins with `option` and says what was expected.
Quantity read_quantity(std::string_view option, std::string_view text, Dimension dimension, double unit = 1);
Quantity read_positive(std::string_view option, std::string_view text, Dimension dimension, double unit = 1);

// Several of them. Numbers with and without a unit in one list are refused, because either reading may be meant; 0 needs none.
std::vector<Quantity> read_quantities(std::string_view option, const std::vector<std::string_view>& texts, Dimension dimension,
                                      double unit = 1);

// Metres in the unit that `name` names, 1 without a name. The Error for one that is no length begins with `option`.
double length_unit(std::string_view option, const char* name);

}  // namespace rc::request
