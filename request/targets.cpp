#include "request/targets.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "request/names.h"

namespace rc::request {

namespace {

std::vector<Quantity> not_negative(std::string_view option, const std::vector<std::string_view>& texts, Dimension dimension,
                                   double unit) {
  const std::vector<Quantity> found = read_quantities(option, texts, dimension, unit);
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k].number < 0) throw Error(option, ": ", in_quotes(texts[k]), " is negative, give 0 or more");
  return found;
}

std::vector<Quantity> read_range(std::string_view option, std::string_view text, const std::vector<std::string_view>& parts,
                                 Dimension dimension, double unit) {
  constexpr std::string_view logarithmic = "log";
  const std::string here = join(option, ": range ", in_quotes(text));
  if (parts.size() != 3) throw Error(here, " has not the form a..b:n or a..b:nlog");

  const auto ends = not_negative(option, {parts[0], parts[1]}, dimension, unit);
  std::string_view number = trimmed(parts[2]);
  const bool ratios = number.ends_with(logarithmic);
  if (ratios) number.remove_suffix(logarithmic.size());
  const auto count = to_integer(number);
  if (!count || *count < 1 || *count > most_targets) {
    throw Error(here, " has n = ", in_quotes(parts[2]), ", give a whole number from 1 to ", most_targets,
                ", or with log behind it for equal ratios");
  }
  const double from = ends[0].si(), to = ends[1].si();
  const bool bare = ends[0].bare && ends[1].bare;
  if (ratios && !(from > 0 && to > 0)) throw Error(here, " has equal ratios, give two ends above 0");

  std::vector<Quantity> points{{from, 1, bare}};
  for (std::int64_t k = 1; k < *count; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(*count - 1);
    if (k == *count - 1) {
      points.push_back({to, 1, bare});
    } else {
      points.push_back({ratios ? from * std::pow(to / from, t) : (1 - t) * from + t * to, 1, bare});
    }
  }
  return points;
}

}  // namespace

std::vector<Quantity> read_targets(std::string_view option, std::string_view text, Dimension dimension, double unit) {
  if (const auto dots = text.find(".."); dots != std::string_view::npos) {
    const std::string_view rest = text.substr(dots + 2);
    const auto colon = rest.find(':');
    if (colon == std::string_view::npos) return not_negative(option, {text.substr(0, dots), rest}, dimension, unit);
    return read_range(option, text, {text.substr(0, dots), rest.substr(0, colon), rest.substr(colon + 1)}, dimension, unit);
  }
  if (text.find(':') != std::string_view::npos) return read_range(option, text, split(text, ':'), dimension, unit);
  return not_negative(option, split(text, ','), dimension, unit);
}

}  // namespace rc::request
