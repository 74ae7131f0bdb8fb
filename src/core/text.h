// Text helpers that do not depend on the locale.
#pragma once

#include <locale>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rc {

template <class... Parts> std::string join(const Parts&... parts) {
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // else a text, or a path, would end silently where memory ran out
  out.imbue(std::locale::classic());
  out.precision(12);
  (out << ... << parts);
  return out.str();
}

std::vector<std::string> split(std::string_view text, char separator);

// The whole text as a number, a point as the decimal mark; nothing if it is not one.
std::optional<double> parse_real(std::string_view text);
std::optional<long long> parse_int(std::string_view text);

// `; did you mean "x"?` for the nearest of the candidates, empty if none is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace rc
