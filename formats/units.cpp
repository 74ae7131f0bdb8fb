#include "formats/units.h"

#include <utility>

namespace rc::formats {

namespace {

constexpr std::pair<std::string_view, double> prefixes[] = {
    {"", 1},      {"T", 1e12},  {"k", 1e3},   {"M", 1e6},         {"G", 1e9},         {"h", 1e2},
    {"da", 1e1},  {"d", 1e-1},  {"c", 1e-2},  {"m", 1e-3},        {"u", 1e-6},        {"n", 1e-9},
    {"p", 1e-12}, {"f", 1e-15}, {"a", 1e-18}, {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6}, {"\xb5", 1e-6}};

}  // namespace

std::optional<double> prefix_factor(std::string_view prefix) {
  for (const auto& [symbol, factor] : prefixes) {
    if (prefix == symbol) return factor;
  }
  return std::nullopt;
}

std::optional<double> metres_per(std::string_view unit) {
  for (const std::string_view angstrom : {"\xc3\x85", "\xe2\x84\xab", "\xc5"}) {
    if (unit == angstrom) return 1e-10;
  }
  if (!unit.ends_with('m')) return std::nullopt;
  unit.remove_suffix(1);
  return prefix_factor(unit);
}

}  // namespace rc::formats
