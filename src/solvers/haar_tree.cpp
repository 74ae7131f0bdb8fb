#include "solvers/haar_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <roughcontact/plugin.hpp>

namespace rc {

namespace {

constexpr double detail = 0.5;      // damping of the differences inside a block
constexpr double anisotropy = 1.5;  // of cells above which only the short side is merged
constexpr float least_top = 0.1F;   // of what is taken off the top
constexpr double least_pivot = 1e-12;
constexpr std::int64_t blocks_per_item = 4096;
constexpr std::int64_t least_shared = 16384;  // blocks of a level below which one thread does them sooner

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

// With A the couplings of the children in the pattern: s = 1' A^-1 1, w = A^-1 1 / s, and the differences A^-1 - s w w', whose
// rows add up to 0, so that the values off the diagonal tell all.
HaarTree::Block HaarTree::solved(const Level& level, const double a[4], unsigned pattern, double& parent) {
  Block block{};
  int child[4], count = 0;
  for (int i = 0; i < 4; ++i)
    if (pattern >> i & 1U) child[count++] = i;
  parent = 0;
  if (count == 0) return block;
  if (count == 1) {
    block.w[child[0]] = 1;
    parent = a[child[0]];
    return block;
  }
  double factor[4][4], inverse[4][4];
  for (int i = 0; i < count; ++i)
    for (int j = 0; j <= i; ++j) {
      const int across = child[i] ^ child[j];
      double value = i == j ? a[child[i]] : across == 1 ? level.kx : across == 2 ? level.ky : level.kxy;
      for (int k = 0; k < j; ++k) value -= factor[i][k] * factor[j][k];
      factor[i][j] = i == j ? std::sqrt(std::max(value, least_pivot)) : value / factor[j][j];
    }
  for (int c = 0; c < count; ++c) {
    double* const x = inverse[c];
    for (int i = 0; i < count; ++i) {
      x[i] = i == c ? 1 : 0;
      for (int k = 0; k < i; ++k) x[i] -= factor[i][k] * x[k];
      x[i] /= factor[i][i];
    }
    for (int i = count; i-- > 0;) {
      for (int k = i + 1; k < count; ++k) x[i] -= factor[k][i] * x[k];
      x[i] /= factor[i][i];
    }
  }
  double rows[4] = {}, s = 0;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) rows[i] += inverse[i][j];
    s += rows[i];
  }
  constexpr int place[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};
  for (int i = 0; i < count; ++i) {
    block.w[child[i]] = static_cast<float>(rows[i] / s);
    for (int j = 0; j < i; ++j)
      block.m[place[child[i]][child[j]]] = static_cast<float>(detail * (inverse[i][j] - rows[i] * rows[j] / s));
  }
  parent = 1 / s;
  return block;
}

// Blocks of cells that are given by their places; these become the places of the blocks.
void HaarTree::link(Level& level, std::vector<std::int32_t>& x, std::vector<std::int32_t>& y) const {
  std::vector<std::int32_t> px, py;
  const auto column = [&](std::size_t i) { return level.merge_x ? (x[i] + level.shift_x) / 2 : std::int64_t{x[i]}; };
  const auto row = [&](std::size_t i) { return level.merge_y ? (y[i] + level.shift_y) / 2 : std::int64_t{y[i]}; };
  // The rows of a block follow each other; each is in ascending order, so the two are merged.
  for (std::size_t begin = 0; begin < x.size();) {
    const std::int64_t parent_row = row(begin);
    std::size_t middle = begin;
    while (middle < x.size() && y[middle] == y[begin]) ++middle;
    std::size_t end = middle;
    while (end < x.size() && row(end) == parent_row) ++end;
    std::size_t upper = begin, lower = middle;
    while (upper < middle || lower < end) {
      const bool both = upper < middle && lower < end;
      const std::int64_t parent_column = both             ? std::min(column(upper), column(lower))
                                         : upper < middle ? column(upper)
                                                          : column(lower);
      const std::size_t at = level.child.size();
      level.child.insert(level.child.end(), 4, -1);
      const auto take = [&](std::size_t& i, std::size_t limit) {
        for (; i < limit && column(i) == parent_column; ++i) {
          const bool right = level.merge_x && (x[i] + level.shift_x) % 2 != 0,
                     below = level.merge_y && (y[i] + level.shift_y) % 2 != 0;
          level.child[at + (right ? 1 : 0) + (below ? 2 : 0)] = static_cast<std::int32_t>(i);
        }
      };
      take(upper, middle);
      take(lower, end);
      px.push_back(static_cast<std::int32_t>(parent_column));
      py.push_back(static_cast<std::int32_t>(parent_row));
    }
    begin = end;
  }
  x = std::move(px);
  y = std::move(py);
  level.parents = static_cast<std::int64_t>(x.size());
}

HaarTree::HaarTree(const Cells& cells, const CouplingTable& table, bool shifted) : self_(static_cast<float>(table.k[0])) {
  std::vector<double> k = table.k;
  std::int64_t mx = cells.mx, my = cells.my, kx = table.mx, ky = table.my;
  double hx = table.hx, hy = table.hy, scale = 1;
  std::vector<std::int32_t> x = cells.x, y = cells.y;
  for (int depth = 0; mx * my > 1 || depth == 0; ++depth) {
    const auto at = [&](std::int64_t i, std::int64_t j) {
      return scale * k[static_cast<std::size_t>(std::min(j, ky - 1) * kx + std::min(i, kx - 1))];
    };
    Level level{mx, my, false, false, 0, 0, at(1, 0), at(0, 1), at(1, 1), 0, {}, {}, above_};
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
    level.parents = mx * my;
    if (!cells.full()) link(level, x, y);
    if (depth > 0) level.blocks.resize(static_cast<std::size_t>(level.parents));
    // Beyond the table the couplings fall with the size of the cells.
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
    if (depth > 0) above_ += static_cast<std::size_t>(levels_.back().parents);
    levels_.push_back(std::move(level));
    levels_.back().offset = above_;  // where this level's parents begin
  }
  above_ += static_cast<std::size_t>(levels_.back().parents);
  const double a[4] = {table.k[0], table.k[0], table.k[0], table.k[0]};
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    double parent = 0;
    finest_.push_back(solved(levels_.front(), a, pattern, parent));
    finest_above_.push_back(static_cast<float>(parent));
  }
}

// An item is some rows of blocks, or a range of them where not every cell exists.
std::int64_t HaarTree::items(const Level& level) {
  if (!level.child.empty()) return (level.parents + blocks_per_item - 1) / blocks_per_item;
  const std::int64_t columns = level.merge_x ? (level.mx + level.shift_x + 1) / 2 : level.mx, rows = level.parents / columns;
  const std::int64_t rows_per_item = std::max<std::int64_t>(1, blocks_per_item / columns);
  return (rows + rows_per_item - 1) / rows_per_item;
}

// visit(parent, children); a child that does not exist is -1.
template <class Visit> void HaarTree::visit_item(const Level& level, std::int64_t item, const Visit& visit) {
  std::int64_t c[4];
  if (!level.child.empty()) {
    const std::int64_t end = std::min((item + 1) * blocks_per_item, level.parents);
    for (std::int64_t p = item * blocks_per_item; p < end; ++p) {
      const std::int32_t* const child = level.child.data() + 4 * p;
      for (int i = 0; i < 4; ++i) c[i] = child[i];
      visit(p, c, std::false_type{});
    }
    return;
  }
  const std::int64_t columns = level.merge_x ? (level.mx + level.shift_x + 1) / 2 : level.mx, rows = level.parents / columns;
  const std::int64_t rows_per_item = std::max<std::int64_t>(1, blocks_per_item / columns);
  for (std::int64_t py = item * rows_per_item; py < std::min((item + 1) * rows_per_item, rows); ++py) {
    const std::int64_t y0 = level.merge_y ? 2 * py - level.shift_y : py, y1 = level.merge_y ? y0 + 1 : level.my;
    const bool has0 = y0 >= 0, has1 = y1 < level.my;
    const std::int64_t p = py * columns;
    const auto at_edge = [&](std::int64_t px) {
      const std::int64_t x0 = level.merge_x ? 2 * px - level.shift_x : px, x1 = level.merge_x ? x0 + 1 : level.mx;
      const bool left = x0 >= 0, right = x1 < level.mx;
      c[0] = has0 && left ? y0 * level.mx + x0 : -1;
      c[1] = has0 && right ? y0 * level.mx + x1 : -1;
      c[2] = has1 && left ? y1 * level.mx + x0 : -1;
      c[3] = has1 && right ? y1 * level.mx + x1 : -1;
      visit(p + px, c, std::false_type{});
    };
    if (!level.merge_x || !has0 || !has1) {
      for (std::int64_t px = 0; px < columns; ++px) at_edge(px);
      continue;
    }
    const std::int64_t first = level.shift_x, last = (level.mx + level.shift_x) / 2;
    for (std::int64_t px = 0; px < first; ++px) at_edge(px);
    for (std::int64_t px = first; px < last; ++px) {
      const std::int64_t x0 = 2 * px - level.shift_x;
      c[0] = y0 * level.mx + x0;
      c[1] = c[0] + 1;
      c[2] = c[0] + level.mx;
      c[3] = c[2] + 1;
      visit(p + px, c, std::true_type{});
    }
    for (std::int64_t px = std::max(first, last); px < columns; ++px) at_edge(px);
  }
}

template <class Visit> void HaarTree::visit_all(const Level& level, const rc_team& team, const Visit& visit) {
  roughcontact::for_each(team, items(level), level.parents >= least_shared,
                         [&](std::int64_t item, std::int64_t) { visit_item(level, item, visit); });
}

namespace {

// Children that exist and are in contact.
template <class Exist> unsigned pattern(const std::uint8_t* active, const std::int64_t* c, Exist) {
  unsigned found = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (Exist::value || c[i] >= 0) found |= static_cast<unsigned>(active[c[i]]) << i;
  return found;
}

template <class Value, class Exist> std::array<Value, 4> values(const Value* from, const std::int64_t* c, Exist) {
  std::array<Value, 4> v;
  for (std::size_t i = 0; i < 4; ++i) v[i] = Exist::value || c[i] >= 0 ? from[c[i]] : Value{0};
  return v;
}

}  // namespace

void HaarTree::set_up(const std::uint8_t* active, float surplus, HaarScratch& scratch, const rc_team& team) {
  scratch.g.resize(std::max(scratch.g.size(), above_));
  scratch.y.resize(std::max(scratch.y.size(), above_));
  float* const a = scratch.g.data();  // self couplings, level by level
  visit_all(levels_.front(), team,
            [&](std::int64_t p, const std::int64_t* c, auto exist) { a[p] = finest_above_[pattern(active, c, exist)]; });
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    const float* const below = a + levels_[l - 1].offset;
    float* const above = a + level.offset;
    visit_all(level, team, [&](std::int64_t p, const std::int64_t* c, auto exist) {
      const std::array<float, 4> child = values(below, c, exist);
      double self[4], parent = 0;
      unsigned in = 0;
      for (unsigned i = 0; i < 4; ++i) {
        self[i] = child[i];
        in |= static_cast<unsigned>(child[i] > 0) << i;
      }
      level.blocks[static_cast<std::size_t>(p)] = solved(level, self, in, parent);
      above[p] = static_cast<float>(parent);
    });
  }
  top_ = std::max(a[above_ - 1] - surplus, least_top * surplus);
}

template <class Real>
double HaarTree::apply(const Real* g, const std::uint8_t* active, Real scale, bool first, Real* z, const Real* q,
                       HaarScratch& scratch, const rc_team& team) const {
  float* const up = scratch.g.data();
  float* const down = scratch.y.data();
  const Level& finest = levels_.front();
  visit_all(finest, team, [&](std::int64_t p, const std::int64_t* c, auto exist) {
    const Block& block = finest_[pattern(active, c, exist)];
    const std::array<Real, 4> v = values(g, c, exist);
    float sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += block.w[i] * static_cast<float>(v[i]);
    up[p] = sum;
  });
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const Level& level = levels_[l];
    const float* const from = up + levels_[l - 1].offset;
    float* const to = up + level.offset;
    visit_all(level, team, [&](std::int64_t p, const std::int64_t* c, auto exist) {
      const Block& block = level.blocks[static_cast<std::size_t>(p)];
      const std::array<float, 4> v = values(from, c, exist);
      to[p] = (block.w[0] * v[0] + block.w[1] * v[1]) + (block.w[2] * v[2] + block.w[3] * v[3]);
    });
  }
  down[above_ - 1] = top_ > 0 ? up[above_ - 1] / top_ : 0;
  const auto differences = [](const Block& b, const std::array<float, 4>& v, float y) {
    const float d01 = b.m[0] * (v[1] - v[0]), d02 = b.m[1] * (v[2] - v[0]), d03 = b.m[2] * (v[3] - v[0]);
    const float d12 = b.m[3] * (v[2] - v[1]), d13 = b.m[4] * (v[3] - v[1]), d23 = b.m[5] * (v[3] - v[2]);
    return std::array<float, 4>{(d01 + d02) + (d03 + b.w[0] * y), (d12 + d13) + (b.w[1] * y - d01),
                                (d23 - d02) + (b.w[2] * y - d12), (b.w[3] * y - d03) - (d13 + d23)};
  };
  for (std::size_t l = levels_.size(); l-- > 1;) {
    const Level& level = levels_[l];
    const float *const from = up + levels_[l - 1].offset, *const above = down + level.offset;
    float* const to = down + levels_[l - 1].offset;
    visit_all(level, team, [&](std::int64_t p, const std::int64_t* c, auto exist) {
      const std::array<float, 4> y = differences(level.blocks[static_cast<std::size_t>(p)], values(from, c, exist), above[p]);
      for (std::size_t i = 0; i < 4; ++i)
        if (exist || c[i] >= 0) to[c[i]] = y[i];
    });
  }
  std::vector<double> sums(q ? static_cast<std::size_t>(items(finest)) : 0, 0.0);
  roughcontact::for_each(team, items(finest), finest.parents >= least_shared, [&](std::int64_t item, std::int64_t) {
    double sum = 0;
    visit_item(finest, item, [&](std::int64_t p, const std::int64_t* c, auto exist) {
      const unsigned in = pattern(active, c, exist);
      if (in == 0) return;
      const std::array<Real, 4> v = values(g, c, exist);
      const std::array<float, 4> y = differences(
          finest_[in], {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), static_cast<float>(v[3])},
          down[p]);
      for (std::size_t i = 0; i < 4; ++i) {
        if (!(in >> i & 1U)) continue;
        const Real value = (first ? Real{0} : z[c[i]]) + scale * static_cast<Real>(y[i]);
        z[c[i]] = value;
        if (q) sum += static_cast<double>(value) * static_cast<double>(q[c[i]]);
      }
    });
    if (q) sums[static_cast<std::size_t>(item)] = sum;
  });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

template double HaarTree::apply(const float*, const std::uint8_t*, float, bool, float*, const float*, HaarScratch&,
                                const rc_team&) const;
template double HaarTree::apply(const double*, const std::uint8_t*, double, bool, double*, const double*, HaarScratch&,
                                const rc_team&) const;

}  // namespace rc
