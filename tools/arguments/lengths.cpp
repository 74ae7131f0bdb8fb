#include "arguments/lengths.h"

#include "error.h"
#include "formats/units.h"
#include "numbers.h"
#include "text.h"

namespace cli {

double length_unit(const std::optional<std::string>& name) {
  if (!name) return 1;
  if (const auto metres = metres_per(*name)) return *metres;
  throw Error("--unit: " + in_quotes(*name) + " is not a length unit, give " + units_of(Dimension::length));
}

std::optional<Pitch> pitch_argument(const std::optional<std::string>& text, double unit) {
  if (!text) return std::nullopt;
  const auto parts = split(*text, ',');
  if (parts.size() > 2)
    throw Error("--pitch: " + in_quotes(*text) + " has " + std::to_string(parts.size()) + " numbers, give H or HX,HY");
  const auto given = read_quantities("--pitch", parts, Dimension::length, unit);
  for (const Quantity& pitch : given) {
    if (!(pitch.number > 0)) throw Error("--pitch: " + in_quotes(*text) + " is not positive");
  }
  return Pitch{given.front(), given.back()};
}

std::string settle_pitch(const std::optional<Pitch>& given, const std::string& file, Surface& surface) {
  std::string note;
  const bool in_file = surface.hx && surface.hy;
  if (!given && !in_file) throw Error(file + ": the file does not say its pitch, give --pitch H or --pitch HX,HY");
  if (given && in_file) {
    note = format("--pitch is used instead of the pitch %g m, %g m of the file", *surface.hx, *surface.hy);
  }
  if (given) {
    surface.hx = given->x.si();
    surface.hy = given->y.si();
  }
  return note;
}

}  // namespace cli
