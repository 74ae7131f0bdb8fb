#include "physics_summary.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bench {

namespace {

constexpr double light = 0.04;                         // area and load are proportional up to this pressure
constexpr double fitted_from = 0.01, fitted_to = 0.2;  // pressure falls exponentially with the mean gap

using Values = std::vector<double>;

double mean(const Values& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Json spread(const Values& values) {
  return {{"mean", mean(values)},
          {"lowest", *std::min_element(values.begin(), values.end())},
          {"highest", *std::max_element(values.begin(), values.end())}};
}

const Json* find(const Json& rows, std::int64_t n, std::uint64_t seed, double pressure) {
  for (const Json& row : rows)
    if (row.at("n") == n && row.at("seed") == seed && row.at("pressure") == pressure && row.value("status", "") == "RC_OK")
      return &row;
  return nullptr;
}

// Certified rows of the curve of one surface, by growing pressure.
std::vector<const Json*> curve_of(const Json& rows, const PhysicsRequest& request, std::uint64_t seed) {
  std::vector<const Json*> found;
  for (const double pressure : request.pressures)
    if (const Json* const row = find(rows, request.points, seed, pressure)) found.push_back(row);
  return found;
}

double number(const Json& row, const char* key) { return row.at(key).get<double>(); }

Json curve(const Json& rows, const PhysicsRequest& request) {
  Json result = Json::array();
  for (const double pressure : request.pressures) {
    std::vector<const Json*> found;
    for (const std::uint64_t seed : request.seeds)
      if (const Json* const row = find(rows, request.points, seed, pressure)) found.push_back(row);
    if (found.empty()) continue;
    Json entry = {{"pressure", pressure}, {"surfaces", found.size()}, {"persson", std::erf(std::sqrt(2.0) * pressure)}};
    for (const char* const key : {"area", "corrected_area", "perimeter", "mean_gap", "stiffness", "patches", "largest_patch"}) {
      Values values;
      for (const Json* const row : found)
        if (row->contains(key)) values.push_back(number(*row, key));
      if (values.size() == found.size()) entry[key] = mean(values);
    }
    Values ratios;
    for (const Json* const row : found) ratios.push_back(number(*row, "corrected_area") / pressure);
    entry["corrected_ratio"] = spread(ratios);
    if (entry.contains("stiffness")) entry["decay"] = pressure / number(entry, "stiffness");
    result.push_back(entry);
  }
  return result;
}

// Least squares through the origin.
std::optional<double> kappa(const std::vector<const Json*>& surface, const char* key) {
  double xy = 0, xx = 0;
  for (const Json* const row : surface) {
    const double pressure = number(*row, "pressure");
    if (pressure > light) continue;
    xy += pressure * number(*row, key);
    xx += pressure * pressure;
  }
  if (xx == 0) return {};
  return xy / xx;
}

bool fitted(const Json& row) { return number(row, "pressure") >= fitted_from && number(row, "pressure") <= fitted_to; }

// Length, over the rms height, in which the pressure falls by e: least squares of its logarithm over the mean gap.
std::optional<double> decay(const std::vector<const Json*>& surface) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Json* const row : surface) {
    if (!fitted(*row)) continue;
    const double u = number(*row, "mean_gap"), log_p = std::log(number(*row, "pressure"));
    n += 1;
    x += u;
    y += log_p;
    xx += u * u;
    xy += u * log_p;
  }
  if (n < 2) return {};
  return -(n * xx - x * x) / (n * xy - x * y);
}

// The same from the stiffness of every solve: K = p / u0.
std::optional<double> stiffness_decay(const std::vector<const Json*>& surface) {
  Values values;
  for (const Json* const row : surface)
    if (fitted(*row) && row->contains("stiffness")) values.push_back(number(*row, "pressure") / number(*row, "stiffness"));
  if (values.empty()) return {};
  return mean(values);
}

Json fits(const Json& rows, const PhysicsRequest& request) {
  Values raw, corrected, by_gap, by_stiffness;
  const auto add = [](Values& to, const std::optional<double>& value) {
    if (value) to.push_back(*value);
  };
  for (const std::uint64_t seed : request.seeds) {
    const std::vector<const Json*> surface = curve_of(rows, request, seed);
    add(raw, kappa(surface, "area"));
    add(corrected, kappa(surface, "corrected_area"));
    add(by_gap, decay(surface));
    add(by_stiffness, stiffness_decay(surface));
  }
  if (raw.empty() || by_gap.empty() || by_stiffness.empty()) return Json::object();
  return {{"light", light},
          {"from", fitted_from},
          {"to", fitted_to},
          {"kappa", spread(raw)},
          {"corrected_kappa", spread(corrected)},
          {"decay", spread(by_gap)},
          {"stiffness_decay", spread(by_stiffness)}};
}

Json meshes(const Json& rows, const PhysicsRequest& request) {
  Json result = Json::array();
  std::vector<std::int64_t> sizes = request.sizes;
  std::sort(sizes.begin(), sizes.end());
  if (sizes.size() < 2) return result;
  for (const double pressure : request.mesh_pressures)
    for (const std::int64_t n : sizes) {
      Values raw, corrected, raw_errors, corrected_errors;
      for (const std::uint64_t seed : request.seeds) {
        const std::int64_t finest = sizes.back(), coarser = sizes[sizes.size() - 2];
        const Json *const row = find(rows, n, seed, pressure), *const last = find(rows, finest, seed, pressure),
                          *const before = find(rows, coarser, seed, pressure);
        if (!row || !last || !before) continue;
        // The raw area is off in proportion to the cell size: to cells of no size by the two finest grids.
        const double a = 1 / static_cast<double>(finest), b = 1 / static_cast<double>(coarser);
        const double limit = (b * number(*last, "area") - a * number(*before, "area")) / (b - a);
        raw.push_back(number(*row, "area"));
        corrected.push_back(number(*row, "corrected_area"));
        raw_errors.push_back(raw.back() / limit - 1);
        corrected_errors.push_back(corrected.back() / limit - 1);
      }
      if (raw.empty()) continue;
      result.push_back({{"pressure", pressure},
                        {"n", n},
                        {"cells_a_wave", static_cast<double>(n) / request.cut_off},
                        {"surfaces", raw.size()},
                        {"area", mean(raw)},
                        {"corrected_area", mean(corrected)},
                        {"raw_error", mean(raw_errors)},
                        {"corrected_error", mean(corrected_errors)}});
    }
  return result;
}

}  // namespace

PhysicsSummary summary_of(const Json& rows, const PhysicsRequest& request) {
  return {curve(rows, request), fits(rows, request), meshes(rows, request)};
}

}  // namespace bench
