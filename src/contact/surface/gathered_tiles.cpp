#include "contact/surface/gathered_tiles.h"

#include <algorithm>
#include <utility>

#include "contact/surface/step_surface.h"
#include "core/error.h"
#include "core/limits.h"

namespace rc {

namespace {

constexpr std::int64_t side = TileLows::side;

}  // namespace

double GatheredTiles::gap(std::int64_t point) const {
  const std::int64_t nx = shared_.points().nx();
  const auto tile = first_.find(shared_.tiles().of(point));
  if (tile == first_.end()) fail(RC_ERR_INTERNAL, "nobody has asked for the tile of point ", point);
  return values_[tile->second + static_cast<std::size_t>(point / nx % side * side + point % nx % side)];
}

void GatheredTiles::hold_tiles_of(std::span<const std::int64_t> points) {
  std::vector<std::int64_t> tiles;
  for (const std::int64_t point : points)
    if (const std::int64_t tile = shared_.tiles().of(point); tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  hold(tiles);
}

// Each process gives the rows that it has of the tiles, one tile after the other. A tile may lie in rows of several processes.
void GatheredTiles::hold(std::span<const std::int64_t> tiles) {
  const Rows& rows = shared_.points().rows();
  const std::int64_t nx = shared_.points().nx(), columns = shared_.tiles().columns();
  std::vector<std::int64_t> wanted;
  for (const std::int64_t tile : tiles)
    if (!first_.contains(tile)) wanted.push_back(tile);
  if (wanted.empty()) return;
  // visit(tile, row in it, first point, how many) in rows first .. end-1.
  const auto each_row = [&](std::int64_t first, std::int64_t end, const auto& visit) {
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const std::int64_t top = wanted[k] / columns * side, left = wanted[k] % columns * side;
      for (std::int64_t y = std::max(top, first); y < std::min(top + side, end); ++y)
        visit(k, y - top, y * nx + left, std::min(side, nx - left));
    }
  };
  std::vector<double> mine;
  const std::int64_t first = rows.first(), before = first * nx;
  each_row(first, first + rows.own(0), [&](std::size_t, std::int64_t, std::int64_t point, std::int64_t count) {
    for (std::int64_t i = point - before; i < point - before + count; ++i)
      mine.push_back(shared_.included(static_cast<std::size_t>(i)) ? shared_.gap()[static_cast<std::size_t>(i)] : nan);
  });
  const std::vector<double> all = rows.joined(std::move(mine));
  const std::size_t held = values_.size();
  constexpr auto size = static_cast<std::size_t>(side * side);
  values_.resize(held + wanted.size() * size, nan);
  auto from = all.begin();
  rows.each_share([&](std::int64_t begin, std::int64_t end) {
    each_row(begin, end, [&](std::size_t k, std::int64_t row, std::int64_t, std::int64_t count) {
      std::copy_n(from, count, values_.begin() + static_cast<std::ptrdiff_t>(held + k * size) + row * side);
      from += count;
    });
  });
  for (std::size_t k = 0; k < wanted.size(); ++k) first_.emplace(wanted[k], held + k * size);
}

}  // namespace rc
