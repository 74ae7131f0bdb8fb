#include "contact/surface/blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rc {

namespace {

// act(point) for every included point of a block.
template <class Act> void each_point(const Blocks& blocks, std::int64_t block, const StepSurface& fine, Act&& act) {
  const std::int64_t x = block % blocks.coarse_nx() * blocks.factor, y = block / blocks.coarse_nx() * blocks.factor;
  for (std::int64_t iy = y; iy < std::min(y + blocks.factor, blocks.ny); ++iy)
    for (std::int64_t ix = x; ix < std::min(x + blocks.factor, blocks.nx); ++ix)
      if (fine.included(static_cast<std::size_t>(iy * blocks.nx + ix))) act(iy * blocks.nx + ix);
}

}  // namespace

std::vector<std::int64_t> Blocks::points_under(const Pressures& coarse) const {
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < coarse.p.size(); ++k) {
    if (!(coarse.p[k] > 0)) continue;
    const std::int64_t block = coarse.on.point(static_cast<std::int64_t>(k));
    const std::int64_t x = block % coarse_nx() * factor, y = block / coarse_nx() * factor;
    for (std::int64_t iy = y; iy < std::min(y + factor, ny); ++iy)
      for (std::int64_t ix = x; ix < std::min(x + factor, nx); ++ix) points.push_back(iy * nx + ix);
  }
  return points;
}

std::int64_t Blocks::included(std::int64_t block, const StepSurface& fine) const {
  std::int64_t count = 0;
  each_point(*this, block, fine, [&](std::int64_t) { ++count; });
  return count;
}

// Blocks come row by row, and points go out row by row.
Pressures spread(const Pressures& coarse, const Blocks& blocks, const StepSurface& fine, Cut cut) {
  Pressures result;
  const auto room = static_cast<std::size_t>(coarse.contacts() * blocks.factor * blocks.factor);
  result.on.index.reserve(room);
  result.p.reserve(room);
  std::vector<std::pair<std::int64_t, double>> row;  // first column and pressure of blocks side by side
  for (std::size_t k = 0; k < coarse.p.size();) {
    const std::int64_t y = coarse.on.point(static_cast<std::int64_t>(k)) / blocks.coarse_nx();
    row.clear();
    for (; k < coarse.p.size(); ++k) {
      const std::int64_t block = coarse.on.point(static_cast<std::int64_t>(k));
      if (block / blocks.coarse_nx() != y) break;
      double p = coarse.p[k];
      if (!(p > 0)) continue;
      if (cut == Cut::same_force)
        p *= static_cast<double>(blocks.factor * blocks.factor) / static_cast<double>(blocks.included(block, fine));
      row.emplace_back(block % blocks.coarse_nx() * blocks.factor, p);
    }
    for (std::int64_t iy = y * blocks.factor; iy < std::min((y + 1) * blocks.factor, blocks.ny); ++iy)
      for (const auto& [x, p] : row)
        for (std::int64_t point = iy * blocks.nx + x; point < iy * blocks.nx + std::min(x + blocks.factor, blocks.nx); ++point) {
          if (!fine.included(static_cast<std::size_t>(point))) continue;
          result.on.index.push_back(point);
          result.p.push_back(p);
        }
  }
  result.on.n = static_cast<std::int64_t>(result.p.size());
  if (result.on.n == blocks.nx * blocks.ny) result.on.index.clear();
  return result;
}

double left_out(const Pressures& p, const Blocks& blocks, const StepSurface& fine, const GapValues& coarse_gap) {
  double sum = 0, largest = 0;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < p.p.size(); ++k) {
    if (!(p.p[k] > 0)) continue;
    const std::int64_t point = p.on.point(static_cast<std::int64_t>(k));
    const double detail = fine.gap()[static_cast<std::size_t>(point)] - coarse_gap[static_cast<std::size_t>(blocks.of(point))];
    // Squares are summed in units of the largest detail, so that they stay within double precision.
    if (const double size = std::abs(detail); size > largest) {
      sum *= (largest / size) * (largest / size);
      largest = size;
    }
    if (largest > 0) sum += (detail / largest) * (detail / largest);
    ++count;
  }
  return count > 0 ? largest * std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace rc
