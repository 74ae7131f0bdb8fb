#include "formats/numbers.h"

#include <charconv>
#include <cmath>

#include "formats/error.h"
#include "formats/wording.h"

namespace rc::formats {

std::optional<double> to_number(std::string_view text) { return parse_real(trimmed(text)); }

std::optional<std::pair<double, std::string_view>> leading_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return std::pair{value, text.substr(static_cast<std::size_t>(end - text.data()))};
}

std::optional<std::int64_t> to_integer(std::string_view text) { return parse_int(trimmed(text)); }

std::int64_t whole_number(std::string_view what, std::string_view text) {
  const auto value = to_integer(text);
  if (!value || *value < 1) throw Error(what, " ", in_quotes(text), " is not a whole number from 1 on");
  return *value;
}

double finite_number(std::string_view what, std::string_view text) {
  const auto value = to_number(text);
  if (!value) throw Error(what, ": ", in_quotes(text), " is not a number");
  if (!std::isfinite(*value)) throw Error(what, ": ", in_quotes(text), " is not finite");
  return *value;
}

double positive_number(std::string_view option, std::string_view text) {
  const double value = finite_number(option, text);
  if (!(value > 0)) throw Error(option, ": ", in_quotes(text), " is not positive");
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace rc::formats
