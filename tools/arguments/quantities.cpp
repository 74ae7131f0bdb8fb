#include "arguments/quantities.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/units.h"
#include "text.h"

namespace cli {

namespace {

struct Reading {
  double number;
  std::string_view unit;  // "" if the text has none
};

Reading take_apart(std::string_view option, std::string_view text) {
  const auto found = leading_number(text);
  if (!found) throw Error(option, ": ", in_quotes(text), " is not a number");
  if (!std::isfinite(found->first)) throw Error(option, ": ", in_quotes(text), " is not finite");
  return {found->first, trimmed(found->second)};
}

std::string expected(Dimension dimension) {
  const char* const alone = dimension == Dimension::length  ? ", or a number alone, in --unit"
                            : dimension == Dimension::angle ? ""
                                                            : ", or a number alone";
  return std::string("expected ") + name_of(dimension) + ": " + units_of(dimension) + alone;
}

}  // namespace

Quantity read_quantity(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  const Reading reading = take_apart(option, text);
  if (reading.unit.empty()) return {reading.number, unit};
  const auto named = find_unit(reading.unit);
  if (!named) {
    throw Error(option, ": the unit of ", in_quotes(text), " is not known (capitals count), ", expected(dimension));
  }
  if (named->dimension != dimension) {
    throw Error(option, ": ", in_quotes(text), " is ", name_of(named->dimension), ", ", expected(dimension));
  }
  return {reading.number, named->factor};
}

Quantity read_positive(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  const Quantity quantity = read_quantity(option, text, dimension, unit);
  if (!(quantity.number > 0)) throw Error(option, ": ", in_quotes(text), " is not positive");
  return quantity;
}

std::vector<Quantity> read_quantities(std::string_view option, const std::vector<std::string_view>& texts, Dimension dimension,
                                      double unit) {
  std::vector<Quantity> quantities;
  std::string_view with, without;
  for (const std::string_view text : texts) {
    quantities.push_back(read_quantity(option, text, dimension, unit));
    if (quantities.back().number != 0) (take_apart(option, text).unit.empty() ? without : with) = text;
  }
  if (!with.empty() && !without.empty())
    throw Error(option, ": ", in_quotes(with), " has a unit and ", in_quotes(without), " has none, give every number its unit");
  return quantities;
}

double length_unit(const std::optional<std::string>& name) { return bare_unit("--unit", name).metres; }

std::optional<Pitch> pitch_argument(const std::optional<std::string>& text, double unit) {
  if (!text) return std::nullopt;
  const auto parts = split(*text, ',');
  if (parts.size() > 2) throw Error("--pitch: ", in_quotes(*text), " has ", parts.size(), " numbers, give H or HX,HY");
  const auto given = read_quantities("--pitch", parts, Dimension::length, unit);
  for (const Quantity& pitch : given) {
    if (!(pitch.number > 0)) throw Error("--pitch: ", in_quotes(*text), " is not positive");
  }
  const auto bare = [](std::string_view part) { return take_apart("--pitch", part).unit.empty(); };
  return Pitch{given.front(), given.back(), std::ranges::any_of(parts, bare)};
}

void settle_pitch(const std::optional<Pitch>& given, Surface& surface) {
  const bool in_file = surface.hx && surface.hy;
  if (!given && !in_file) throw Error(surface.file, ": the file does not say its pitch, give --pitch H or --pitch HX,HY");
  if (!given) return;
  refuse_another_pitch("--pitch", given->x.si(), given->y.si(), surface);
  surface.hx = given->x.si();
  surface.hy = given->y.si();
}

}  // namespace cli
