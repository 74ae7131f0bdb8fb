#include "contact/grids/goal/grid_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc {

namespace {

// Differences are not taken to fall faster than this from grid to grid: the roughness does not show the ends of contacts.
constexpr double slowest_decay = 0.5;

}  // namespace

Texture texture_below(double limit, double length, const StepSurface& surface, const rc_system& system) {
  const GapValues& gap = surface.gap();
  Texture found;
  double squares = 0;
  std::int64_t count = 0;
  const auto row = static_cast<std::size_t>(system.nx);
  for (std::int64_t iy = 0; iy < system.ny; ++iy)
    for (std::int64_t ix = 0; ix < system.nx; ++ix) {
      const auto i = static_cast<std::size_t>(iy * system.nx + ix);
      if (!surface.included(i) || !(gap[i] < limit)) continue;
      ++found.points;
      const auto add = [&](std::size_t before, std::size_t after) {
        if (!surface.included(before) || !surface.included(after)) return;
        const double ahead = (gap[after] - gap[i]) / length, behind = (gap[before] - gap[i]) / length;
        squares += (ahead + behind) * (ahead + behind);
        ++count;
      };
      if (ix > 0 && ix + 1 < system.nx) add(i - 1, i + 1);
      if (iy > 0 && iy + 1 < system.ny) add(i - row, i + row);
    }
  found.roughness = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : std::numeric_limits<double>::infinity();
  return found;
}

// Extrapolates the differences of load to finer grids: they are taken as proportional to the roughness that the grids show.
GridErrors guessed_errors(std::span<const GridLevel> levels, std::size_t k) {
  const auto weight = [&](std::size_t j) { return levels[j].texture.roughness; };
  const auto ratio = [&](std::size_t fine, std::size_t coarse) {
    const double least = std::pow(slowest_decay, static_cast<double>(coarse - fine));
    if (!std::isfinite(weight(coarse))) return std::numeric_limits<double>::infinity();
    if (weight(fine) == 0) return least;
    const double found = weight(fine) / weight(coarse);
    return std::isfinite(found) ? std::max(least, found) : std::numeric_limits<double>::infinity();
  };
  // Takes the larger of two, because either difference may be small by chance.
  const double difference = std::max(levels[k].difference, levels[k + 1].difference * ratio(k, k + 1));
  double sum = 0;
  for (std::size_t j = 0; j < k; ++j) sum += ratio(j, k);
  return {difference * sum, difference * ratio(0, k)};
}

}  // namespace rc
