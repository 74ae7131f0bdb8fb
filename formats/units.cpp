#include "formats/units.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "formats/error.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::pair<std::string_view, double> prefixes[] = {
    {"", 1},      {"T", 1e12},  {"k", 1e3},   {"M", 1e6},         {"G", 1e9},         {"h", 1e2},
    {"da", 1e1},  {"d", 1e-1},  {"c", 1e-2},  {"m", 1e-3},        {"u", 1e-6},        {"n", 1e-9},
    {"p", 1e-12}, {"f", 1e-15}, {"a", 1e-18}, {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6}, {"\xb5", 1e-6}};

// In lower case and without a plural's s.
constexpr std::pair<std::string_view, double> spelt[] = {
    {"meter", 1},         {"metre", 1},         {"kilometer", 1e3},   {"kilometre", 1e3},   {"centimeter", 1e-2},
    {"centimetre", 1e-2}, {"millimeter", 1e-3}, {"millimetre", 1e-3}, {"micrometer", 1e-6}, {"micrometre", 1e-6},
    {"mikrometer", 1e-6}, {"micron", 1e-6},     {"nanometer", 1e-9},  {"nanometre", 1e-9},  {"angstrom", 1e-10},
    {"picometer", 1e-12}, {"picometre", 1e-12}};

// Letters of angstrom beyond ASCII, in UTF-8 (the sign, the letter, a letter with a combining ring) before Latin-1.
constexpr std::pair<std::string_view, char> letters[] = {{"\xe2\x84\xab", 'A'}, {"\xc3\x85", 'A'}, {"\xc3\xa5", 'A'},
                                                         {"A\xcc\x8a", 'A'},    {"\xc3\xb6", 'o'}, {"\xc5", 'A'},
                                                         {"\xe5", 'A'},         {"\xf6", 'o'}};

std::string in_ascii(std::string_view name) {
  std::string plain;
  while (!name.empty()) {
    const auto found = std::ranges::find_if(letters, [&](const auto& letter) { return name.starts_with(letter.first); });
    plain += found == std::end(letters) ? name.front() : found->second;
    name.remove_prefix(found == std::end(letters) ? 1 : found->first.size());
  }
  return plain;
}

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * b; }

std::vector<const Surface::Length*> bare(const Surface& surface) {
  std::vector<const Surface::Length*> found;
  for (const auto& length : surface.lengths)
    if (length.unit.empty()) found.push_back(&length);
  return found;
}

}  // namespace

std::optional<double> prefix_factor(std::string_view prefix) {
  for (const auto& [symbol, factor] : prefixes) {
    if (prefix == symbol) return factor;
  }
  return std::nullopt;
}

std::optional<double> metres_per(std::string_view unit) {
  if (unit.size() > 40) return std::nullopt;
  const std::string plain = in_ascii(unit);
  if (plain == "A") return 1e-10;
  if (plain.ends_with('m')) {
    if (const auto factor = prefix_factor(std::string_view(plain).substr(0, plain.size() - 1))) return factor;
  }
  std::string word = lower_case(plain);
  if (word.ends_with('s')) word.pop_back();
  for (const auto& [name, metres] : spelt) {
    if (word == name) return metres;
  }
  return std::nullopt;
}

BareUnit bare_unit(std::string_view key, const std::optional<std::string>& name) {
  if (!name) return {};
  const auto metres = metres_per(*name);
  if (!metres) throw Error(key, ": ", in_quotes(*name), " is not a length unit, give ", known_lengths);
  return {*name, *metres, true};
}

void check_units(const BareUnit& unit, std::initializer_list<const Surface*> surfaces) {
  const bool complete = std::ranges::all_of(surfaces, [](const Surface* each) { return bare(*each).empty(); });
  for (const Surface* const surface : surfaces) {
    if (!unit.given && !surface->unclear_unit.empty() && !bare(*surface).empty())
      throw Error(surface->file, ": the file says ", in_quotes(surface->unclear_unit), ", but not whether that is the unit of ",
                  bare_lengths(*surface), "; give their unit");
    if (!unit.given || !complete) continue;
    for (const auto& length : surface->lengths) {
      if (same(length.metres, unit.metres)) continue;
      throw Error(surface->file, ": the unit of the ", length.what, " is ", length.unit, " in the file, but the unit given is ",
                  unit.name, ", which is that of lengths without a unit; leave it out, or correct the file");
    }
  }
}

std::string bare_lengths(const Surface& surface) {
  std::string text;
  for (const auto* const length : bare(surface)) {
    if (text.find(length->what) == std::string::npos) text += join(text.empty() ? "" : " and ", length->what);
  }
  return text;
}

void refuse_another_pitch(std::string_view option, double hx, double hy, const Surface& surface) {
  if (same_pitch(hx, surface.hx.value_or(hx)) && same_pitch(hy, surface.hy.value_or(hy))) return;
  throw Error(option, ": the pitch given is ", hx, " m, ", hy, " m, but ", surface.file, " has its own, ",
              surface.hx.value_or(hx), " m, ", surface.hy.value_or(hy), " m; leave the pitch out, or correct the file");
}

bool same_pitch(double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); }

}  // namespace rc::formats
