#include "tiles.h"

#include "common/domain.h"

namespace rc_split {

using rc_common::for_each_point;

Tiles::Tiles(const rc_domain& domain, std::int64_t nx, std::int64_t ny) {
  const auto [left, top, width, height] = rc_common::bounding_box(domain, nx, ny);
  box_ = {left / side, top / side, (left + width - 1) / side - left / side + 1, (top + height - 1) / side - top / side + 1};

  // Entries per tile, then the tiles' numbers, then the entries in the order of tiles.
  const auto place = [this](std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>((y / side - box_.y) * box_.nx + x / side - box_.x);
  };
  map_.assign(static_cast<std::size_t>(box_.tiles()), 0);
  for_each_point(domain, nx, [&](std::int64_t, std::int64_t x, std::int64_t y) { ++map_[place(x, y)]; });
  first_.push_back(0);
  for (std::int64_t y = 0; y < box_.ny; ++y) {
    row_first_.push_back(count());
    for (std::int64_t x = 0; x < box_.nx; ++x) {
      std::int32_t& tile = map_[static_cast<std::size_t>(y * box_.nx + x)];
      if (tile == 0) {
        tile = -1;
        continue;
      }
      first_.push_back(first_.back() + tile);
      tile = static_cast<std::int32_t>(places_.size());
      places_.push_back({box_.x + x, box_.y + y});
    }
  }
  row_first_.push_back(count());
  std::vector<std::int64_t> next(first_.begin(), first_.end() - 1);
  positions_.resize(static_cast<std::size_t>(domain.n));
  cells_.resize(static_cast<std::size_t>(domain.n));
  for_each_point(domain, nx, [&](std::int64_t i, std::int64_t x, std::int64_t y) {
    const auto entry = static_cast<std::size_t>(next[static_cast<std::size_t>(map_[place(x, y)])]++);
    positions_[entry] = i;
    cells_[entry] = static_cast<std::uint8_t>(y % side * side + x % side);
  });
}

}  // namespace rc_split
