#include "contact/blocks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <roughcontact/plugin.hpp>
#include <utility>
#include <vector>

namespace rc {

namespace {

// act(point) for every included point of a block.
template <class Act> void each_point(const Blocks& blocks, std::int64_t block, const SurfaceState& fine, Act&& act) {
  const std::int64_t x = block % blocks.coarse_nx() * blocks.factor, y = block / blocks.coarse_nx() * blocks.factor;
  for (std::int64_t iy = y; iy < std::min(y + blocks.factor, blocks.ny); ++iy)
    for (std::int64_t ix = x; ix < std::min(x + blocks.factor, blocks.nx); ++ix)
      if (fine.included(static_cast<std::size_t>(iy * blocks.nx + ix))) act(iy * blocks.nx + ix);
}

}  // namespace

std::int64_t Blocks::included(std::int64_t block, const SurfaceState& fine) const {
  std::int64_t count = 0;
  each_point(*this, block, fine, [&](std::int64_t) { ++count; });
  return count;
}

CoarseGrid halved(const SurfaceState& surface, std::int64_t nx, std::int64_t ny, const rc_team& team) {
  return downsample(nx, ny, surface.gap(), surface.masks(), Filter::mean,
                    [&](std::int64_t rows, const std::function<void(std::int64_t)>& act) {
                      roughcontact::for_each(team, rows, true, [&](std::int64_t row, std::int64_t) { act(row); });
                    });
}

Pressures spread(const Pressures& coarse, const Blocks& blocks, const SurfaceState& fine, Cut cut) {
  std::vector<std::pair<std::int64_t, double>> all;
  for (std::size_t k = 0; k < coarse.p.size(); ++k) {
    double p = coarse.p[k];
    if (!(p > 0)) continue;
    const std::int64_t block = coarse.on.point(static_cast<std::int64_t>(k));
    if (cut == Cut::same_force)
      p *= static_cast<double>(blocks.factor * blocks.factor) / static_cast<double>(blocks.included(block, fine));
    each_point(blocks, block, fine, [&](std::int64_t point) { all.emplace_back(point, p); });
  }
  std::sort(all.begin(), all.end());
  Pressures result;
  result.on.n = static_cast<std::int64_t>(all.size());
  result.on.index.reserve(all.size());
  result.p.reserve(all.size());
  for (const auto& [point, p] : all) {
    result.on.index.push_back(point);
    result.p.push_back(p);
  }
  if (result.on.n == blocks.nx * blocks.ny) result.on.index.clear();
  return result;
}

double cut_share(const Pressures& coarse, const Blocks& blocks, const SurfaceState& fine) {
  const auto whole = static_cast<double>(blocks.factor * blocks.factor);
  double sum = 0, cut = 0;
  for (std::size_t k = 0; k < coarse.p.size(); ++k) {
    if (!(coarse.p[k] > 0)) continue;
    sum += coarse.p[k];
    const std::int64_t block = coarse.on.point(static_cast<std::int64_t>(k));
    cut += coarse.p[k] * (1 - static_cast<double>(blocks.included(block, fine)) / whole);
  }
  return sum > 0 ? cut / sum : 0;
}

double left_out(const Pressures& p, const Blocks& blocks, const SurfaceState& fine, std::span<const double> coarse_gap) {
  double sum = 0, largest = 0;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < p.p.size(); ++k) {
    if (!(p.p[k] > 0)) continue;
    const std::int64_t point = p.on.point(static_cast<std::int64_t>(k));
    const double detail = fine.gap()[static_cast<std::size_t>(point)] - coarse_gap[static_cast<std::size_t>(blocks.of(point))];
    // In units of the largest, so that squares stay within double precision.
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
