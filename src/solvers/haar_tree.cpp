#include "solvers/haar_tree.h"

#include <algorithm>
#include <cmath>

namespace rc {

namespace {

constexpr double detail = 0.5;      // damping of the differences inside a block
constexpr double anisotropy = 1.5;  // of cells above which only the short side is merged
constexpr double least_pivot = 1e-12;

// Triangle averages along one direction: couplings between pairs of cells from those between cells.
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

// The children of one block that are in contact.
struct HaarTree::Block {
  int count = 0;
  std::size_t child[4];
  double factor[4][4];  // Cholesky, of the couplings between the children

  void add(std::size_t cell) { child[count++] = cell; }

  void factorize(const Level& level, std::int64_t mx) {
    for (int i = 0; i < count; ++i)
      for (int j = 0; j <= i; ++j) {
        double value = level.a[child[i]];
        if (i != j) {
          const auto m = static_cast<std::size_t>(mx);
          const bool same_x = child[i] % m == child[j] % m, same_y = child[i] / m == child[j] / m;
          value = same_y ? level.kx : same_x ? level.ky : level.kxy;
        }
        for (int k = 0; k < j; ++k) value -= factor[i][k] * factor[j][k];
        factor[i][j] = i == j ? std::sqrt(std::max(value, least_pivot)) : value / factor[j][j];
      }
  }
  void solve(double* x) const {
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < i; ++k) x[i] -= factor[i][k] * x[k];
      x[i] /= factor[i][i];
    }
    for (int i = count; i-- > 0;) {
      for (int k = i + 1; k < count; ++k) x[i] -= factor[k][i] * x[k];
      x[i] /= factor[i][i];
    }
  }
};

HaarTree::HaarTree(std::int64_t mx, std::int64_t my, const CouplingTable& table, bool shifted) {
  std::vector<double> k = table.k;
  std::int64_t kx = table.mx, ky = table.my;
  double hx = table.hx, hy = table.hy, scale = 1;
  self_ = k[0];
  for (int depth = 0;; ++depth) {
    const auto n = static_cast<std::size_t>(mx * my);
    const auto at = [&](std::int64_t i, std::int64_t j) {
      return scale * k[static_cast<std::size_t>(std::min(j, ky - 1) * kx + std::min(i, kx - 1))];
    };
    Level level{mx, my, false, false, 0, 0, at(1, 0), at(0, 1), at(1, 1), std::vector<double>(n), std::vector<double>(n), {}, {}};
    if (depth > 0) {
      level.g.resize(n);
      level.y.resize(n);
    }
    level.merge_x = mx > 1 && (hx <= anisotropy * hy || my == 1);
    level.merge_y = my > 1 && (hy <= anisotropy * hx || mx == 1);
    const bool shift = shifted && depth % 2 == 0;
    level.shift_x = shift && level.merge_x && mx > 2;
    level.shift_y = shift && level.merge_y && my > 2;
    levels_.push_back(std::move(level));
    const Level& last = levels_.back();
    if (mx * my == 1) break;
    if (last.merge_x) {
      mx = (mx + last.shift_x + 1) / 2;
      hx *= 2;
    }
    if (last.merge_y) {
      my = (my + last.shift_y + 1) / 2;
      hy *= 2;
    }
    // Beyond the table the couplings fall with the size of the cells.
    const bool room_x = !last.merge_x || kx >= 8, room_y = !last.merge_y || ky >= 8;
    if (room_x && room_y) {
      if (last.merge_x) {
        k = halved(k, kx, ky, true);
        kx /= 2;
      }
      if (last.merge_y) {
        k = halved(k, kx, ky, false);
        ky /= 2;
      }
    } else {
      scale *= last.merge_x && last.merge_y ? 0.5 : std::sqrt(0.5);
    }
  }
}

template <class Visit> void HaarTree::for_blocks(std::size_t l, const Visit& visit) {
  const Level &level = levels_[l], &next = levels_[l + 1];
  for (std::int64_t py = 0; py < next.my; ++py) {
    const std::int64_t y0 = level.merge_y ? 2 * py - level.shift_y : py, y1 = level.merge_y ? y0 + 2 : y0 + 1;
    for (std::int64_t px = 0; px < next.mx; ++px) {
      const std::int64_t x0 = level.merge_x ? 2 * px - level.shift_x : px, x1 = level.merge_x ? x0 + 2 : x0 + 1;
      Block block;
      for (std::int64_t y = std::max<std::int64_t>(y0, 0); y < std::min(y1, level.my); ++y)
        for (std::int64_t x = std::max<std::int64_t>(x0, 0); x < std::min(x1, level.mx); ++x) {
          const auto cell = static_cast<std::size_t>(y * level.mx + x);
          if (level.a[cell] > 0) block.add(cell);
        }
      visit(static_cast<std::size_t>(py * next.mx + px), block);
    }
  }
}

void HaarTree::set_up(const std::vector<char>& active) {
  Level& finest = levels_.front();
  for (std::size_t i = 0; i < active.size(); ++i) finest.a[i] = active[i] ? self_ : 0;
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    Level &level = levels_[l], &next = levels_[l + 1];
    for_blocks(l, [&](std::size_t parent, Block& block) {
      if (block.count == 0) {
        next.a[parent] = 0;
        return;
      }
      if (block.count == 1) {
        level.w[block.child[0]] = 1;
        next.a[parent] = level.a[block.child[0]];
        return;
      }
      block.factorize(level, level.mx);
      double x[4] = {1, 1, 1, 1}, sum = 0;
      block.solve(x);
      for (int i = 0; i < block.count; ++i) sum += x[i];
      for (int i = 0; i < block.count; ++i) level.w[block.child[i]] = x[i] / sum;
      next.a[parent] = 1 / sum;
    });
  }
}

void HaarTree::apply_add(const std::vector<double>& g, double scale, std::vector<double>& y) {
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    const Level& level = levels_[l];
    const std::vector<double>& from = l == 0 ? g : level.g;
    std::vector<double>& to = levels_[l + 1].g;
    for_blocks(l, [&](std::size_t parent, const Block& block) {
      double sum = 0;
      for (int i = 0; i < block.count; ++i) sum += level.w[block.child[i]] * from[block.child[i]];
      to[parent] = sum;
    });
  }
  Level& top = levels_.back();
  if (levels_.size() == 1) {
    if (top.a[0] > 0) y[0] += scale * g[0] / top.a[0];
    return;
  }
  top.y[0] = top.a[0] > 0 ? top.g[0] / top.a[0] : 0;
  for (std::size_t l = levels_.size() - 1; l-- > 0;) {
    Level& level = levels_[l];
    const Level& next = levels_[l + 1];
    const std::vector<double>& from = l == 0 ? g : level.g;
    for_blocks(l, [&](std::size_t parent, Block& block) {
      double x[4];
      const double below = next.y[parent];
      if (block.count == 1) {
        x[0] = below;
      } else {
        block.factorize(level, level.mx);
        for (int i = 0; i < block.count; ++i) x[i] = from[block.child[i]] - next.g[parent];
        block.solve(x);
        double sum = 0;
        for (int i = 0; i < block.count; ++i) sum += x[i];
        for (int i = 0; i < block.count; ++i)
          x[i] = detail * (x[i] - level.w[block.child[i]] * sum) + level.w[block.child[i]] * below;
      }
      for (int i = 0; i < block.count; ++i) {
        if (l == 0)
          y[block.child[i]] += scale * x[i];
        else
          level.y[block.child[i]] = x[i];
      }
    });
  }
}

}  // namespace rc
