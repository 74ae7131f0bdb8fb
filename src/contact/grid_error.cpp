#include "contact/grid_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rc {

namespace {

constexpr double safety = 1.5;
constexpr double slowest_decay =
    0.5;  // of the difference from grid to grid, for what the roughness does not show: ends of contacts

}  // namespace

Goal goal_of(const rc_options& options) { return {options.real(RC_OPT_ACCURACY), options.text(RC_OPT_ACCURACY_OF) == "area"}; }

Texture texture_below(double limit, double length, const SurfaceState& surface, const rc_system& system) {
  const std::span<const double> gap = surface.gap();
  Texture found;
  double squares = 0, gradient = 0;
  std::int64_t count = 0;
  const auto row = static_cast<std::size_t>(system.nx);
  for (std::int64_t iy = 0; iy < system.ny; ++iy)
    for (std::int64_t ix = 0; ix < system.nx; ++ix) {
      const auto i = static_cast<std::size_t>(iy * system.nx + ix);
      if (!surface.included(i) || !(gap[i] < limit)) continue;
      ++found.points;
      const auto add = [&](std::size_t before, std::size_t after, double pitch) {
        if (!surface.included(before) || !surface.included(after)) return;
        const double ahead = (gap[after] - gap[i]) / length, behind = (gap[before] - gap[i]) / length;
        squares += (ahead + behind) * (ahead + behind);
        gradient += (ahead * ahead + behind * behind) * (length / pitch) * (length / pitch);
        ++count;
      };
      if (ix > 0 && ix + 1 < system.nx) add(i - 1, i + 1, system.hx);
      if (iy > 0 && iy + 1 < system.ny) add(i - row, i + row, system.hy);
    }
  const auto mean = [&](double sum) { return sum / static_cast<double>(count); };
  found.roughness = count > 0 ? std::sqrt(mean(squares)) : std::numeric_limits<double>::infinity();
  found.slope = count > 0 ? std::sqrt(mean(gradient)) : 0;  // of two directions, each with two neighbours
  return found;
}

double area_excess(std::span<const GridLevel> levels, std::size_t k, double pressure) {
  const auto share = [&](std::size_t j) {
    const double slope = levels[j].texture.slope;
    return slope > 0 ? std::erf(std::numbers::sqrt2 * pressure / slope) : 1;
  };
  return std::max(0.0, share(k) / share(0) - 1);
}

// The load follows the heights that a finer grid adds, the area their slopes: differences of finer grids are taken to be to each
// other as these are.
GridErrors estimated_errors(std::span<const GridLevel> levels, std::size_t k, bool of_area) {
  const auto weight = [&](std::size_t j) {
    return of_area ? std::ldexp(levels[j].texture.roughness, -static_cast<int>(j)) : levels[j].texture.roughness;
  };
  const auto ratio = [&](std::size_t fine, std::size_t coarse) {
    const double least = std::pow(slowest_decay, static_cast<double>(coarse - fine));
    if (!std::isfinite(weight(coarse))) return std::numeric_limits<double>::infinity();
    if (weight(fine) == 0) return least;
    const double found = weight(fine) / weight(coarse);
    return std::isfinite(found) ? std::max(least, found) : std::numeric_limits<double>::infinity();
  };
  // Either difference may be small by chance.
  const double difference = std::max(levels[k].difference, levels[k + 1].difference * ratio(k, k + 1));
  double sum = 0;
  for (std::size_t j = 0; j < k; ++j) sum += ratio(j, k);
  return {safety * difference * sum, safety * difference * ratio(0, k)};
}

}  // namespace rc
