// One multilevel tree over every cell of a grid, in double precision. Read it before tree.h, which computes the same with vector
// instructions. Tests alone use it.
//
// On each level the cells are joined to blocks of 2 x 2, or 2 x 1 if cells are elongated. A holds the couplings of a block's
// children: the deflection of one under a unit load spread over another. With s = 1'A^-1 1, the shares w = A^-1 1 / s divide a
// unit load on the block among its children with the least energy, 1/2s. So 1/s is the block's coupling with itself as a child
// of the next level. The rest of the inverse, A^-1 - s w w', acts on differences between the children. Half of it is kept,
// because two trees are averaged.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "trees/tree_inputs.h"

namespace rc {

class PlainTree {
 public:
  using Values = std::vector<double>;

  // shifted: the blocks of every second level begin one cell earlier. Where cells fill a period the first begins with the last
  // cell.
  PlainTree(std::int64_t nx, std::int64_t ny, const CouplingTable& table, bool shifted) : least_top_(table.nx > 0 ? 0.03 : 0.1) {
    double hx = table.hx, hy = table.hy, scale = 1;
    std::int64_t wide = 1, high = 1;  // cells of the grid along the sides of a block
    const bool period_x = nx == table.nx, period_y = ny == table.ny;
    Line columns = cells(nx), rows = cells(ny);
    for (int depth = 0; nx * ny > 1 || depth == 0; ++depth) {
      Level level{nx, ny};
      level.merge_x = nx > 1 && (hx <= anisotropy * hy || ny == 1);
      level.merge_y = ny > 1 && (hy <= anisotropy * hx || nx == 1);
      const bool shift = shifted && depth % 2 == 0;
      level.shift_x = shift && level.merge_x && nx > 2;
      level.shift_y = shift && level.merge_y && ny > 2;
      const bool around_x = level.shift_x && period_x && nx % 2 == 0, around_y = level.shift_y && period_y && ny % 2 == 0;
      const Line above_columns = level.merge_x ? joined(columns, level.shift_x, around_x) : columns,
                 above_rows = level.merge_y ? joined(rows, level.shift_y, around_y) : rows;
      const bool large = scale < 1 && table.nx > 0;  // against the period of a periodic surface
      const auto between = [&](std::int64_t dx, std::int64_t dy) {
        return large ? periodic_coupling(table, shared_waves(columns, above_columns, table.nx, dx == 1),
                                         shared_waves(rows, above_rows, table.ny, dy == 1))
                     : scale * coupling(table, wide, high, dx, dy);
      };
      level.x = between(1, 0);
      level.y = between(0, 1);
      level.xy = between(1, 1);
      columns = above_columns;
      rows = above_rows;
      if (level.merge_x) {
        nx = around_x ? nx / 2 : (nx + level.shift_x + 1) / 2;
        hx *= 2;
      }
      if (level.merge_y) {
        ny = around_y ? ny / 2 : (ny + level.shift_y + 1) / 2;
        hy *= 2;
      }
      // If the table is too short for larger blocks, couplings are assumed to halve when cells double their sides.
      const bool room =
          (!level.merge_x || table.mx >= least_blocks * wide) && (!level.merge_y || table.my >= least_blocks * high);
      if (room) {
        wide *= level.merge_x ? 2 : 1;
        high *= level.merge_y ? 2 : 1;
      } else {
        scale *= level.merge_x && level.merge_y ? 0.5 : std::sqrt(0.5);
      }
      level.blocks.resize(static_cast<std::size_t>(nx * ny));
      for (std::int64_t y = 0; y < level.ny; ++y)
        for (std::int64_t x = 0; x < level.nx; ++x) {
          std::int64_t i = level.merge_x ? x + level.shift_x : 2 * x, j = level.merge_y ? y + level.shift_y : 2 * y;
          if (around_x) i %= level.nx;
          if (around_y) j %= level.ny;
          level.blocks[static_cast<std::size_t>(j / 2 * nx + i / 2)].child[static_cast<std::size_t>(j % 2 * 2 + i % 2)] =
              static_cast<int>(y * level.nx + x);
        }
      levels_.push_back(level);
    }
    self_ = table.k[0];
  }

  // Solves the blocks for the contact set. surplus: by how much every entry of the table exceeds that of the operator. It is
  // taken off the coupling of the whole contact set with itself: it does not act on differences.
  void set_up(const std::vector<std::uint8_t>& active, double surplus) {
    Values self(active.size());  // 0: no contact
    for (std::size_t i = 0; i < self.size(); ++i) self[i] = active[i] ? self_ : 0;
    for (Level& level : levels_) {
      Values above(level.blocks.size());
      for (std::size_t b = 0; b < above.size(); ++b) above[b] = solve(level, self, level.blocks[b]);
      self = above;
    }
    top_ = std::max(self.front() - surplus, least_top_ * surplus);
  }

  // z += part * M g
  void add(const Values& g, double part, Values& z) const {
    std::vector<Values> load{g};  // on each level: a block's load is the sum of its children's by their shares
    for (const Level& level : levels_) {
      Values above;
      for (const Block& block : level.blocks) {
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
          if (block.child[i] >= 0) sum += block.share[i] * load.back()[static_cast<std::size_t>(block.child[i])];
        above.push_back(sum);
      }
      load.push_back(above);
    }
    Values pressure{top_ > 0 ? load.back().front() / top_ : 0};
    for (std::size_t l = levels_.size(); l-- > 0;) {
      Values below(load[l].size());
      for (std::size_t b = 0; b < levels_[l].blocks.size(); ++b) {
        const Block& block = levels_[l].blocks[b];
        for (std::size_t i = 0; i < 4; ++i) {
          if (block.child[i] < 0) continue;
          double value = block.share[i] * pressure[b];
          for (std::size_t j = 0; j < 4; ++j)
            if (block.child[j] >= 0) value += block.detail[i][j] * load[l][static_cast<std::size_t>(block.child[j])];
          below[static_cast<std::size_t>(block.child[i])] = value;
        }
      }
      pressure = below;
    }
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += part * pressure[i];
  }

 private:
  static constexpr double anisotropy = 1.5;  // ratio of a cell's sides above which cells are joined along the short side only
  static constexpr std::int64_t least_blocks = 8;
  static constexpr double kept_detail = 0.5;

  struct Block {
    std::array<int, 4> child{-1, -1, -1, -1};  // upper left, upper right, lower left, lower right; -1: none
    std::array<double, 4> share{};
    std::array<std::array<double, 4>, 4> detail{};
  };
  struct Level {
    std::int64_t nx, ny;          // cells
    double x = 0, y = 0, xy = 0;  // couplings of neighbours along x, along y, and across
    bool merge_x = false, merge_y = false;
    std::int64_t shift_x = 0, shift_y = 0;
    std::vector<Block> blocks{};
  };

  // The mean of the coefficients between all cells of two blocks, wide x high, that are dx and dy blocks apart.
  static double coupling(const CouplingTable& table, std::int64_t wide, std::int64_t high, std::int64_t dx, std::int64_t dy) {
    double sum = 0;
    for (std::int64_t j = 1 - high; j < high; ++j)
      for (std::int64_t i = 1 - wide; i < wide; ++i) {
        const std::int64_t x = std::min(std::abs(dx * wide + i), table.mx - 1),
                           y = std::min(std::abs(dy * high + j), table.my - 1);
        sum += static_cast<double>((wide - std::abs(i)) * (high - std::abs(j))) *
               table.k[static_cast<std::size_t>(y * table.mx + x)];
      }
    return sum / static_cast<double>(wide * wide * high * high);
  }

  // Blocks along one direction, and the cells of each.
  using Line = std::vector<std::vector<std::int64_t>>;

  static Line cells(std::int64_t n) {
    Line line;
    for (std::int64_t i = 0; i < n; ++i) line.push_back({i});
    return line;
  }

  static Line joined(const Line& line, std::int64_t shift, bool around) {
    const auto n = static_cast<std::int64_t>(line.size());
    Line above(static_cast<std::size_t>(around ? n / 2 : (n + shift + 1) / 2));
    for (std::int64_t i = 0; i < n; ++i) {
      const std::vector<std::int64_t>& from = line[static_cast<std::size_t>(i)];
      std::vector<std::int64_t>& to = above[static_cast<std::size_t>((around ? (i + shift) % n : i + shift) / 2)];
      to.insert(to.end(), from.begin(), from.end());
    }
    return above;
  }

  // For each wave along a period of n cells, up to the fourth lobe of a block's spectrum: the mean over a block times the mean
  // over the same block or, with `neighbours`, the adjacent one. Averaged over all blocks, weighted by the cells of both.
  static Values shared_waves(const Line& line, const Line& above, std::int64_t n, bool neighbours) {
    const auto sums = [&](std::int64_t k, const std::vector<std::int64_t>& block) {
      std::complex<double> sum = 0;
      for (const std::int64_t cell : block)
        sum += std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(k * cell) / static_cast<double>(n));
      return sum;
    };
    std::size_t all = 0;
    for (const auto& block : line) all += block.size();
    Values shared;
    for (std::int64_t k = 0; k <= n / 2 && k * static_cast<std::int64_t>(all) <= 4 * n * static_cast<std::int64_t>(line.size());
         ++k) {
      double sum = 0, weight = 0;
      for (const auto& a : line)
        for (const auto& b : line) {
          const bool join = std::any_of(above.begin(), above.end(), [&](const auto& both) {
            return std::count(both.begin(), both.end(), a.front()) > 0 && std::count(both.begin(), both.end(), b.front()) > 0;
          });
          if (neighbours ? &a == &b || !join : &a != &b) continue;
          sum += std::real(sums(k, a) * std::conj(sums(k, b)));
          weight += static_cast<double>(a.size() * b.size());
        }
      if (weight > 0) shared.push_back(sum / weight);
    }
    return shared;
  }

  // The same as coupling() by the waves of a periodic surface, in both directions along each side.
  static double periodic_coupling(const CouplingTable& table, const Values& along_x, const Values& along_y) {
    const auto nx = static_cast<double>(table.nx), ny = static_cast<double>(table.ny);
    const auto last_x = static_cast<std::int64_t>(along_x.size()) - 1, last_y = static_cast<std::int64_t>(along_y.size()) - 1;
    double sum = 0;
    for (std::int64_t l = -last_y; l <= last_y; ++l)
      for (std::int64_t k = -last_x; k <= last_x; ++k) {
        if (k == 0 && l == 0) continue;
        const double length = std::hypot(static_cast<double>(k) / (nx * table.hx), static_cast<double>(l) / (ny * table.hy));
        sum += along_x[static_cast<std::size_t>(std::abs(k))] * along_y[static_cast<std::size_t>(std::abs(l))] /
               (std::numbers::pi * length);
      }
    return table.softness * sum / (nx * ny * std::sqrt(table.hx * table.hy)) + table.mean;
  }

  // Sets a block's shares and details from the couplings of its children. Returns its coupling with itself, 0 without contact.
  static double solve(const Level& level, const Values& self, Block& block) {
    const double between[4][4] = {{0, level.x, level.y, level.xy},
                                  {level.x, 0, level.xy, level.y},
                                  {level.y, level.xy, 0, level.x},
                                  {level.xy, level.y, level.x, 0}};
    // [A I] becomes [I A^-1] by Gauss & Jordan's method; a child without contact has a row of the identity.
    double a[4][8] = {};
    bool in[4];
    for (std::size_t i = 0; i < 4; ++i) {
      in[i] = block.child[i] >= 0 && self[static_cast<std::size_t>(block.child[i])] > 0;
      a[i][i] = in[i] ? self[static_cast<std::size_t>(block.child[i])] : 1;
      a[i][4 + i] = 1;
      for (std::size_t j = 0; j < i; ++j)
        if (in[i] && in[j]) a[i][j] = a[j][i] = between[i][j];
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const double pivot = a[k][k];
      for (double& value : a[k]) value /= pivot;
      for (std::size_t i = 0; i < 4; ++i) {
        const double factor = a[i][k];
        if (i == k) continue;
        for (std::size_t j = 0; j < 8; ++j) a[i][j] -= factor * a[k][j];
      }
    }
    double s = 0, row[4] = {};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        if (in[i] && in[j]) row[i] += a[i][4 + j];
    for (const double value : row) s += value;
    for (std::size_t i = 0; i < 4; ++i) {
      block.share[i] = s > 0 ? row[i] / s : 0;
      for (std::size_t j = 0; j < 4; ++j)
        block.detail[i][j] = in[i] && in[j] ? kept_detail * (a[i][4 + j] - row[i] * row[j] / s) : 0;
    }
    return s > 0 ? 1 / s : 0;
  }

  std::vector<Level> levels_;
  const double least_top_;     // of the surplus
  double self_ = 0, top_ = 0;  // couplings with itself of a cell, and of the whole contact set
};

}  // namespace rc
