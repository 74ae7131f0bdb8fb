#include "solvers/haar_cg/tree_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace rc {

namespace {

constexpr double most_blocks = 1024;  // of a period: where there are more, they are small against it
constexpr double anisotropy = 1.5;    // ratio of a cell's sides above which cells are merged along the short side only

// Couplings between pairs of cells, from those between cells: averages with triangular weights along one direction.
std::vector<double> halved(const std::vector<double>& k, std::int64_t mx, std::int64_t my, bool along_x) {
  const std::int64_t nx = along_x ? mx / 2 : mx, ny = along_x ? my : my / 2;
  std::vector<double> out(static_cast<std::size_t>(nx * ny));
  const auto averaged = [](double before, double here, double after) { return 0.25 * before + 0.5 * here + 0.25 * after; };
  for (std::int64_t y = 0; y < ny; ++y) {
    double* const to = out.data() + y * nx;
    if (along_x) {
      const double* const row = k.data() + y * mx;
      for (std::int64_t x = 0; x < nx; ++x) to[x] = averaged(row[std::abs(2 * x - 1)], row[2 * x], row[2 * x + 1]);
    } else {
      const double *const row = k.data() + 2 * y * mx, *const after = row + mx, *const before = y == 0 ? after : row - mx;
      for (std::int64_t x = 0; x < nx; ++x) to[x] = averaged(before[x], row[x], after[x]);
    }
  }
  return out;
}

// The mean influence of a block of wide x high cells of a periodic surface on the block i blocks to the right and j above: the
// sum of the waves that such blocks can tell apart, each wave with the half-space's deflection, L / pi k for k waves along a
// length L.
double periodic_coupling(const CouplingTable& table, double wide, double high, int i, int j) {
  const double unit = std::sqrt(table.hx * table.hy);
  // Of each wave number along one direction, up to the fourth lobe of a block's spectrum: its part of the sum.
  const auto along = [](double n, double side, int offset) {
    std::vector<double> part{1};
    for (int k = 1; k <= static_cast<int>(std::min(n / 2, 4 * n / side)); ++k) {
      const double phase = std::numbers::pi * k / n, lobe = std::sin(side * phase) / (side * std::sin(phase));
      part.push_back(2 * lobe * lobe * std::cos(2 * side * phase * offset));
    }
    return part;
  };
  const auto nx = static_cast<double>(table.nx), ny = static_cast<double>(table.ny);
  const std::vector<double> x = along(nx, wide, i), y = along(ny, high, j);
  double sum = 0;
  for (std::size_t l = 0; l < y.size(); ++l)
    for (std::size_t k = l == 0 ? 1 : 0; k < x.size(); ++k)
      sum += x[k] * y[l] / std::hypot(static_cast<double>(k) / (nx * table.hx), static_cast<double>(l) / (ny * table.hy));
  return table.softness / (std::numbers::pi * unit * nx * ny) * sum + table.mean;
}

}  // namespace

std::vector<HaarTreeLevel> haar_tree_levels(std::int64_t mx, std::int64_t my, const CouplingTable& table, bool shifted,
                                            bool around) {
  std::vector<HaarTreeLevel> levels;
  const bool period_x = around && mx == table.nx, period_y = around && my == table.ny;
  std::vector<double> k = table.k;
  std::int64_t kx = table.mx, ky = table.my;
  double hx = table.hx, hy = table.hy, scale = 1;
  for (int depth = 0; mx * my > 1 || depth == 0; ++depth) {
    // Blocks that overlap in a period count as that wide.
    const auto side = [](double length, std::int64_t n) {
      return 2 * length > static_cast<double>(n) ? static_cast<double>(n) : length;
    };
    const double wide = side(std::round(hx / table.hx), table.nx), high = side(std::round(hy / table.hy), table.ny);
    const bool waves = scale < 1 && table.nx > 0 && static_cast<double>(table.nx * table.ny) <= most_blocks * wide * high;
    const auto at = [&](int i, int j) {
      if (waves) return static_cast<float>(periodic_coupling(table, wide, high, i, j));
      return static_cast<float>(
          scale * k[static_cast<std::size_t>(std::min<std::int64_t>(j, ky - 1) * kx + std::min<std::int64_t>(i, kx - 1))]);
    };
    HaarTreeLevel level{.mx = mx, .my = my};
    level.coupling = {at(1, 0), at(0, 1), at(1, 1)};
    level.merge_x = mx > 1 && (hx <= anisotropy * hy || my == 1);
    level.merge_y = my > 1 && (hy <= anisotropy * hx || mx == 1);
    const bool shift = shifted && depth % 2 == 0;
    level.shift_x = shift && level.merge_x && mx > 2;
    level.shift_y = shift && level.merge_y && my > 2;
    level.around_x = level.shift_x && period_x && mx % 2 == 0;
    level.around_y = level.shift_y && period_y && my % 2 == 0;
    if (level.merge_x) {
      mx = level.around_x ? mx / 2 : (mx + level.shift_x + 1) / 2;
      hx *= 2;
    }
    if (level.merge_y) {
      my = level.around_y ? my / 2 : (my + level.shift_y + 1) / 2;
      hy *= 2;
    }
    // Where the table is too short for larger blocks, couplings are taken to halve when cells double their sides, which they do
    // where blocks are small against a period.
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
