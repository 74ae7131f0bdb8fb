#include "trees/tree_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <utility>

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

// The blocks of a level along one direction: how many cells each has. Those at the ends may have fewer than the others.
using Sides = std::vector<double>;

Sides joined(const Sides& sides, bool merge, std::int64_t shift, bool around) {
  if (!merge) return sides;
  const auto n = static_cast<std::int64_t>(sides.size());
  Sides above(static_cast<std::size_t>(around ? n / 2 : (n + shift + 1) / 2));
  for (std::int64_t i = 0; i < n; ++i)
    above[static_cast<std::size_t>((around ? (i + shift) % n : i + shift) / 2)] += sides[static_cast<std::size_t>(i)];
  return above;
}

// For each wave number along one direction, up to the fourth lobe of a block's spectrum: how much of the wave a block shares with
// itself, and with the neighbour that it joins. Means over all blocks, weighted by their loads under the same pressure
// everywhere: such a pressure then deflects no more than it should where the blocks at the ends are smaller.
struct SharedWaves {
  std::vector<double> own, joined;
};

SharedWaves shared_waves(const Sides& sides, const Sides& above, double n) {
  // The square of a wave's sum over a block, added up over the blocks. Above it has the products with the neighbours as well.
  const auto squares = [n](const Sides& of, int wave) {
    const double phase = std::numbers::pi * wave / n;
    double sum = 0, last = 0, square = 0;
    for (const double side : of) {
      if (side != last) square = wave == 0 ? side * side : std::pow(std::sin(side * phase) / std::sin(phase), 2);
      last = side;
      sum += square;
    }
    return sum;
  };
  SharedWaves shared{{1}, {1}};
  const double mean_side = std::accumulate(sides.begin(), sides.end(), 0.0) / static_cast<double>(sides.size());
  const double own = squares(sides, 0), more = squares(above, 0) - own;
  for (int wave = 1; wave <= static_cast<int>(std::min(n / 2, 4 * n / mean_side)); ++wave) {
    const double square = squares(sides, wave);
    shared.own.push_back(2 * square / own);
    if (more > 0) shared.joined.push_back(2 * (squares(above, wave) - square) / more);
  }
  return shared;
}

// The mean influence of blocks of a periodic surface on each other: the sum of the waves that they can tell apart, each wave with
// the half-space's deflection, L / pi k for k waves along a length L. x and y: how much of each wave the blocks share.
double periodic_coupling(const CouplingTable& table, const std::vector<double>& x, const std::vector<double>& y) {
  const double unit = std::sqrt(table.hx * table.hy);
  const auto nx = static_cast<double>(table.nx), ny = static_cast<double>(table.ny);
  // Squares of the wave numbers, in waves along `unit`.
  const auto square = [](std::size_t k, double ratio) { return std::pow(static_cast<double>(k) * ratio, 2); };
  double sum = 0;
  for (std::size_t l = 0; l < y.size(); ++l)
    for (std::size_t k = l == 0 ? 1 : 0; k < x.size(); ++k)
      sum += x[k] * y[l] / std::sqrt(square(k, unit / (nx * table.hx)) + square(l, unit / (ny * table.hy)));
  return table.softness / (std::numbers::pi * nx * ny) * sum + table.mean;
}

}  // namespace

std::vector<HaarTreeLevel> haar_tree_levels(std::int64_t mx, std::int64_t my, const CouplingTable& table, bool shifted,
                                            bool around) {
  std::vector<HaarTreeLevel> levels;
  Sides x(static_cast<std::size_t>(mx), 1.0), y(static_cast<std::size_t>(my), 1.0);
  const bool period_x = around && mx == table.nx, period_y = around && my == table.ny;
  std::vector<double> k = table.k;
  std::int64_t kx = table.mx, ky = table.my;
  double hx = table.hx, hy = table.hy, scale = 1;
  for (int depth = 0; mx * my > 1 || depth == 0; ++depth) {
    HaarTreeLevel level{.mx = mx, .my = my};
    level.merge_x = mx > 1 && (hx <= anisotropy * hy || my == 1);
    level.merge_y = my > 1 && (hy <= anisotropy * hx || mx == 1);
    const bool shift = shifted && depth % 2 == 0;
    level.shift_x = shift && level.merge_x && mx > 2;
    level.shift_y = shift && level.merge_y && my > 2;
    level.around_x = level.shift_x && period_x && mx % 2 == 0;
    level.around_y = level.shift_y && period_y && my % 2 == 0;
    Sides above_x = joined(x, level.merge_x, level.shift_x, level.around_x);
    Sides above_y = joined(y, level.merge_y, level.shift_y, level.around_y);
    if (const double cells = std::round(hx / table.hx) * std::round(hy / table.hy);
        scale < 1 && table.nx > 0 && static_cast<double>(table.nx * table.ny) <= most_blocks * cells) {
      const SharedWaves along_x = shared_waves(x, above_x, static_cast<double>(table.nx)),
                        along_y = shared_waves(y, above_y, static_cast<double>(table.ny));
      const auto coupling = [&](const std::vector<double>& of_x, const std::vector<double>& of_y) {
        return static_cast<float>(periodic_coupling(table, of_x, of_y));
      };
      level.coupling = {coupling(along_x.joined, along_y.own), coupling(along_x.own, along_y.joined),
                        coupling(along_x.joined, along_y.joined)};
    } else {
      const auto coupling = [&](std::int64_t i, std::int64_t j) {
        return static_cast<float>(scale * k[static_cast<std::size_t>(std::min(j, ky - 1) * kx + std::min(i, kx - 1))]);
      };
      level.coupling = {coupling(1, 0), coupling(0, 1), coupling(1, 1)};
    }
    x = std::move(above_x);
    y = std::move(above_y);
    mx = level.columns = static_cast<std::int64_t>(x.size());
    my = level.rows = static_cast<std::int64_t>(y.size());
    if (level.merge_x) hx *= 2;
    if (level.merge_y) hy *= 2;
    // If the table is too short for larger blocks, couplings are assumed to halve when cells double their sides, which they do
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
    levels.push_back(level);
  }
  return levels;
}

}  // namespace rc
