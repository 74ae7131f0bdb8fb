#include "request/quantities.h"

#include <cmath>
#include <string>

#include "formats/units.h"
#include "request/names.h"

namespace rc::request {

Quantity read_quantity(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  const auto found = leading_number(text);
  if (!found) throw Error(option, ": ", in_quotes(text), " is not a number");
  const double number = found->first;
  if (!std::isfinite(number)) throw Error(option, ": ", in_quotes(text), " is not finite");
  const std::string_view name = trimmed(found->second);
  if (name.empty()) return {number, unit, true};
  const auto named = find_unit(name);
  if (named && named->dimension == dimension) return {number, named->factor};
  const std::string expected = join(", expected ", name_of(dimension), ": ", units_of(dimension),
                                    dimension == Dimension::angle ? "" : ", or a number alone");
  if (!named) throw Error(option, ": the unit of ", in_quotes(text), " is not known (capitals count)", expected);
  throw Error(option, ": ", in_quotes(text), " is ", name_of(named->dimension), expected);
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
    if (quantities.back().number != 0) (quantities.back().bare ? without : with) = text;
  }
  if (!with.empty() && !without.empty())
    throw Error(option, ": ", in_quotes(with), " has a unit and ", in_quotes(without), " has none, give every number its unit");
  return quantities;
}

double length_unit(std::string_view option, const char* name) {
  if (!name) return 1;
  const auto metres = metres_in(name);
  if (!metres) throw Error(option, ": ", in_quotes(name), " is not a length unit, give ", formats::known_lengths);
  return *metres;
}

}  // namespace rc::request
