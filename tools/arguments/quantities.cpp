#include "arguments/quantities.h"

#include <cmath>
#include <string>

#include "error.h"
#include "numbers.h"
#include "text.h"

namespace cli {

namespace {

struct Reading {
  double number;
  std::string_view unit;  // "" where the text has none
};

Reading take_apart(std::string_view option, std::string_view text) {
  const auto found = leading_number(text);
  if (!found) throw Error(std::string(option) + ": " + in_quotes(text) + " is not a number");
  if (!std::isfinite(found->first)) throw Error(std::string(option) + ": " + in_quotes(text) + " is not finite");
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
    throw Error(std::string(option) + ": the unit of " + in_quotes(text) + " is not known (capitals count), " +
                expected(dimension));
  }
  if (named->dimension != dimension) {
    throw Error(std::string(option) + ": " + in_quotes(text) + " is " + name_of(named->dimension) + ", " + expected(dimension));
  }
  return {reading.number, named->factor};
}

Quantity read_positive(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  const Quantity quantity = read_quantity(option, text, dimension, unit);
  if (!(quantity.number > 0)) throw Error(std::string(option) + ": " + in_quotes(text) + " is not positive");
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
    throw Error(std::string(option) + ": " + in_quotes(with) + " has a unit and " + in_quotes(without) +
                " has none, give every number its unit");
  return quantities;
}

}  // namespace cli
