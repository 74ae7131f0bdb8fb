#include "arguments/targets.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "arguments/quantities.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "text.h"

namespace cli {

namespace {

constexpr std::int64_t most_points = 100000;
constexpr std::string_view logarithmic = "log";

std::vector<double> values(std::string_view option, const std::vector<std::string_view>& texts, Dimension dimension,
                           double unit) {
  std::vector<double> found;
  for (const Quantity& quantity : read_quantities(option, texts, dimension, unit)) {
    if (quantity.number < 0) throw Error(option, ": ", in_quotes(texts[found.size()]), " is negative, give 0 or more");
    found.push_back(quantity.si());
  }
  return found;
}

std::vector<double> range(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  const auto parts = split(text, ':');
  const std::string here = std::string(option) + ": range " + in_quotes(text);
  if (parts.size() != 3) throw Error(here, " has not the form a:b:n or a:b:nlog");

  const auto ends = values(option, {parts[0], parts[1]}, dimension, unit);
  std::string_view number = trimmed(parts[2]);
  const bool ratios = number.ends_with(logarithmic);
  if (ratios) number.remove_suffix(logarithmic.size());
  const auto count = to_integer(number);
  if (!count || *count < 1 || *count > most_points) {
    throw Error(here, " has n = ", in_quotes(parts[2]), ", give a whole number from 1 to ", most_points,
                ", or with log behind it for equal ratios");
  }
  if (ratios && !(ends[0] > 0 && ends[1] > 0)) throw Error(here, " has equal ratios, give two ends above 0");

  std::vector<double> points{ends[0]};
  for (std::int64_t k = 1; k < *count; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(*count - 1);
    if (k == *count - 1) {
      points.push_back(ends[1]);
    } else {
      points.push_back(ratios ? ends[0] * std::pow(ends[1] / ends[0], t) : (1 - t) * ends[0] + t * ends[1]);
    }
  }
  return points;
}

}  // namespace

std::vector<double> parse_targets(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  if (text.find(':') != std::string_view::npos) return range(option, text, dimension, unit);
  return values(option, split(text, ','), dimension, unit);
}

}  // namespace cli
