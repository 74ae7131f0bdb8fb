// Units named by text, and SI prefixes for labels.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rc::request {

enum class Dimension { length, pressure, force, angle, share, viscosity, time };

struct Unit {
  Dimension dimension;
  double factor;  // SI units (m, Pa, N, rad) in one of these
};

// Metres in a length as files name it.
std::optional<double> metres_in(std::string_view name);

// A length as files name it; Pa, N, rad or s with any SI prefix, min, h, deg or %. Capitals count: mN and MN, mPa and MPa differ.
// Micro is u, U+00B5, U+03BC or Latin-1. Nothing if the text is no such unit.
std::optional<Unit> find_unit(std::string_view name);

// "a pressure", "Pa with an SI prefix (kPa, MPa, GPa), or bar".
const char* name_of(Dimension dimension);
const char* units_of(Dimension dimension);

// The prefix under which a value of this magnitude has one to three digits before the point, or up to three times as many if the
// unit is squared or cubed; the factor is that of the whole unit.
struct Prefix {
  double factor;
  std::string symbol;
};
Prefix prefix_for(double magnitude, int power = 1);

// "39 nm", "2.56 GPa": to this number of digits, under the prefix that suits it; "65 um^2" for a unit that ends with ^2 or ^3.
std::string with_prefix(double value, const char* unit, int digits = 3);

}  // namespace rc::request
