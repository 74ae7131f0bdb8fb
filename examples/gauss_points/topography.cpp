#include "topography.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

[[noreturn]] void refuse(const std::string& path, std::int64_t line, const std::string& what) {
  throw std::runtime_error(path + ", line " + std::to_string(line) + ": " + what);
}

}  // namespace

Topography read_topography(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  Topography map;
  std::string line;
  std::int64_t rows = 0;
  while (std::getline(file, line)) {
    std::string_view rest = trimmed(line);
    if (rest.empty()) continue;
    if (rest.back() == ';') rest.remove_suffix(1);  // a semicolon may end the line
    ++rows;
    std::int64_t columns = 0;
    for (bool more = true; more; ++columns) {
      const auto end = rest.find(';');
      more = end != rest.npos;
      std::string_view word = trimmed(rest.substr(0, end));
      if (more) rest.remove_prefix(end + 1);
      if (!word.empty() && word.front() == '+') word.remove_prefix(1);
      double value = 0;
      const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || last != word.data() + word.size() || !std::isfinite(value))
        refuse(path, rows, "value " + std::to_string(columns + 1) + ", \"" + std::string(word) + "\", is not a finite number");
      map.heights.push_back(value);
    }
    if (rows == 1) map.side = columns;
    if (columns != map.side)
      refuse(path, rows, std::to_string(columns) + " values; the first line has " + std::to_string(map.side));
  }
  if (rows == 0) throw std::runtime_error(path + ": no values");
  if (rows != map.side)
    throw std::runtime_error(path + ": " + std::to_string(rows) + " lines of " + std::to_string(map.side) +
                             " values; give a square map");
  return map;
}
