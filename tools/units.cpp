#include "units.h"

#include <cmath>
#include <utility>

namespace cli {

namespace {

constexpr std::pair<const char*, double> label_prefixes[] = {{"T", 1e12},  {"G", 1e9},   {"M", 1e6},         {"k", 1e3},
                                                             {"", 1},      {"m", 1e-3},  {"\xc2\xb5", 1e-6}, {"n", 1e-9},
                                                             {"p", 1e-12}, {"f", 1e-15}, {"a", 1e-18}};

}  // namespace

Prefix prefix_for(double magnitude) {
  if (!(std::abs(magnitude) > 0) || !std::isfinite(magnitude)) return {1, ""};
  for (const auto& [symbol, factor] : label_prefixes) {
    // The limit is slightly below 1, so that a value rounded to three digits never reads "1000".
    if (std::abs(magnitude) >= 0.9995 * factor) return {factor, symbol};
  }
  return {1e-18, "a"};
}

}  // namespace cli
