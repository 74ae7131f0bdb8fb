#include "targets.h"

#include <cstdint>
#include <string>

#include "error.h"
#include "numbers.h"
#include "text.h"

namespace cli {

namespace {

constexpr std::int64_t most_points = 100000;

double target(std::string_view option, std::string_view text) {
  const double value = finite_number(option, text);
  if (value < 0) throw Error(std::string(option) + ": " + in_quotes(text) + " is negative, give 0 or more");
  return value;
}

std::vector<double> range(std::string_view option, std::string_view text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3) throw Error(std::string(option) + ": range " + in_quotes(text) + " has not the form a:b:n");

  const double first = target(option, parts[0]);
  const double last = target(option, parts[1]);
  const auto count = to_integer(parts[2]);
  if (!count || *count < 1 || *count > most_points) {
    throw Error(std::string(option) + ": range " + in_quotes(text) + " has n = " + in_quotes(parts[2]) +
                ", give a whole number from 1 to " + std::to_string(most_points));
  }

  std::vector<double> points{first};
  for (std::int64_t k = 1; k < *count; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(*count - 1);
    points.push_back((1 - t) * first + t * last);
  }
  return points;
}

}  // namespace

std::vector<double> parse_targets(std::string_view option, std::string_view text) {
  if (text.find(':') != std::string_view::npos) return range(option, text);

  std::vector<double> points;
  for (const auto part : split(text, ',')) points.push_back(target(option, part));
  return points;
}

}  // namespace cli
