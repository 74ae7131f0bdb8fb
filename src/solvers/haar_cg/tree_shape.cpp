#include "solvers/haar_cg/tree_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rc {

namespace {

constexpr double anisotropy = 1.5;  // ratio of a cell's sides above which cells are merged along the short side only

// Couplings between pairs of cells, from those between cells: averages with triangular weights along one direction.
std::vector<double> halved(const std::vector<double>& k, std::int64_t mx, std::int64_t my, bool along_x) {
  const std::int64_t n = along_x ? mx : my, half = n / 2, rest = along_x ? my : mx;
  std::vector<double> out(static_cast<std::size_t>(half * rest));
  for (std::int64_t r = 0; r < rest; ++r)
    for (std::int64_t i = 0; i < half; ++i) {
      const auto at = [&](std::int64_t offset) {
        const std::int64_t j = std::min(std::abs(offset), n - 1);
        return k[static_cast<std::size_t>(along_x ? r * mx + j : j * mx + r)];
      };
      out[static_cast<std::size_t>(along_x ? r * half + i : i * mx + r)] =
          0.25 * at(2 * i - 1) + 0.5 * at(2 * i) + 0.25 * at(2 * i + 1);
    }
  return out;
}

}  // namespace

std::vector<HaarTreeLevel> haar_tree_levels(std::int64_t mx, std::int64_t my, const CouplingTable& table, bool shifted) {
  std::vector<HaarTreeLevel> levels;
  std::vector<double> k = table.k;
  std::int64_t kx = table.mx, ky = table.my;
  double hx = table.hx, hy = table.hy, scale = 1;
  for (int depth = 0; mx * my > 1 || depth == 0; ++depth) {
    const auto at = [&](std::int64_t i, std::int64_t j) {
      return static_cast<float>(scale * k[static_cast<std::size_t>(std::min(j, ky - 1) * kx + std::min(i, kx - 1))]);
    };
    HaarTreeLevel level{.mx = mx, .my = my};
    level.coupling = {at(1, 0), at(0, 1), at(1, 1)};
    level.merge_x = mx > 1 && (hx <= anisotropy * hy || my == 1);
    level.merge_y = my > 1 && (hy <= anisotropy * hx || mx == 1);
    const bool shift = shifted && depth % 2 == 0;
    level.shift_x = shift && level.merge_x && mx > 2;
    level.shift_y = shift && level.merge_y && my > 2;
    if (level.merge_x) {
      mx = (mx + level.shift_x + 1) / 2;
      hx *= 2;
    }
    if (level.merge_y) {
      my = (my + level.shift_y + 1) / 2;
      hy *= 2;
    }
    // Where the table is too short for larger blocks, couplings are taken to halve when cells double their sides.
    const bool room_x = !level.merge_x || kx >= 8, room_y = !level.merge_y || ky >= 8;
    if (room_x && room_y) {
      if (level.merge_x) {
        k = halved(k, kx, ky, true);
        kx /= 2;
      }
      if (level.merge_y) {
        k = halved(k, kx, ky, false);
        ky /= 2;
      }
    } else {
      scale *= level.merge_x && level.merge_y ? 0.5 : std::sqrt(0.5);
    }
    level.columns = mx;
    level.rows = my;
    levels.push_back(level);
  }
  return levels;
}

}  // namespace rc
