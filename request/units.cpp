#include "request/units.h"

#include <roughcontact/formats.h>

#include <cmath>
#include <utility>

#include "formats/units.h"
#include "request/names.h"

namespace rc::request {

namespace {

struct Symbol {
  std::string_view text;
  Dimension dimension;
  double factor = 1;
};
constexpr Symbol symbols[] = {{"Pa", Dimension::pressure}, {"bar", Dimension::pressure, 1e5}, {"N", Dimension::force},
                              {"rad", Dimension::angle},   {"Pas", Dimension::viscosity},     {"Pa s", Dimension::viscosity},
                              {"s", Dimension::time}};

constexpr std::pair<const char*, double> label_prefixes[] = {{"T", 1e12},  {"G", 1e9},   {"M", 1e6},         {"k", 1e3},
                                                             {"", 1},      {"m", 1e-3},  {"\xc2\xb5", 1e-6}, {"n", 1e-9},
                                                             {"p", 1e-12}, {"f", 1e-15}, {"a", 1e-18}};

}  // namespace

std::optional<double> metres_in(std::string_view name) {
  double metres = 0;
  if (rc_surface_unit(std::string(name).c_str(), &metres) != RC_OK) return std::nullopt;
  return metres;
}

std::optional<Unit> find_unit(std::string_view name) {
  if (const auto metres = metres_in(name)) return Unit{Dimension::length, *metres};
  if (name == "%") return Unit{Dimension::share, 0.01};
  if (name == "min") return Unit{Dimension::time, 60};
  if (name == "h") return Unit{Dimension::time, 3600};
  if (name == "deg") return Unit{Dimension::angle, 3.14159265358979323846 / 180};
  for (const auto& [symbol, dimension, scale] : symbols) {
    if (!name.ends_with(symbol)) continue;
    const auto prefix = name.substr(0, name.size() - symbol.size());
    if (const auto factor = metres_in(join(prefix, "m"))) return Unit{dimension, *factor * scale};
  }
  return std::nullopt;
}

const char* name_of(Dimension dimension) {
  if (dimension == Dimension::length) return "a length";
  if (dimension == Dimension::pressure) return "a pressure";
  if (dimension == Dimension::share) return "a share";
  if (dimension == Dimension::viscosity) return "a viscosity";
  if (dimension == Dimension::time) return "a time";
  return dimension == Dimension::force ? "a force" : "an angle";
}

const char* units_of(Dimension dimension) {
  if (dimension == Dimension::length) return formats::known_lengths.data();
  if (dimension == Dimension::pressure) return "Pa with an SI prefix (kPa, MPa, GPa), or bar";
  if (dimension == Dimension::share) return "%, at most 100 %";
  if (dimension == Dimension::viscosity) return "Pas with an SI prefix (mPas)";
  if (dimension == Dimension::time) return "s with an SI prefix (ms), min or h";
  return dimension == Dimension::force ? "N with an SI prefix (uN, mN, kN)" : "deg or rad";
}

Prefix prefix_for(double magnitude, int power) {
  if (!(std::abs(magnitude) > 0) || !std::isfinite(magnitude)) return {1, ""};
  for (const auto& [symbol, factor] : label_prefixes) {
    const double whole = std::pow(factor, power);
    // The limit is slightly below 1, so that a value rounded to three digits never reads "1000".
    if (std::abs(magnitude) >= 0.9995 * whole) return {whole, symbol};
  }
  return {std::pow(1e-18, power), "a"};
}

std::string with_prefix(double value, const char* unit, int digits) {
  const std::string_view name = unit;
  const int power = name.ends_with("^2") ? 2 : name.ends_with("^3") ? 3 : 1;
  const Prefix prefix = prefix_for(value, power);
  const double number = value / prefix.factor + 0.0;  // never -0
  const bool large = power > 1 && std::abs(number) >= 1000;
  std::string text = large ? format("%.0f", number) : format("%.*g", digits, number);
  if (text.find("e+") != std::string::npos)
    text = format("%.0f", std::stod(text));  // more digits before the point than asked for
  return text + " " + prefix.symbol + unit;
}

}  // namespace rc::request
