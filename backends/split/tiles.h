// The domain in tiles of 16 x 16 cells: its entries in the order of tiles, and which tile lies where.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <span>
#include <vector>

#include "loops.h"

namespace rc_split {

// A rectangle of tiles.
struct Frame {
  std::int64_t x = 0, y = 0, nx = 0, ny = 0;

  std::int64_t tiles() const { return nx * ny; }
  bool operator==(const Frame&) const = default;
};

struct TilePlace {
  std::int64_t x, y;  // of the grid's tiles
};

class Tiles {
 public:
  Tiles() = default;
  Tiles(const rc_domain& domain, std::int64_t nx, std::int64_t ny);

  std::int64_t count() const { return static_cast<std::int64_t>(places_.size()); }
  const Frame& box() const { return box_; }
  TilePlace place(std::int64_t tile) const { return places_[static_cast<std::size_t>(tile)]; }

  // The tile at a place, -1 where there is none.
  std::int64_t at(std::int64_t x, std::int64_t y) const {
    if (x < box_.x || y < box_.y || x >= box_.x + box_.nx || y >= box_.y + box_.ny) return -1;
    return map_[static_cast<std::size_t>((y - box_.y) * box_.nx + x - box_.x)];
  }

  // The tiles of a row of the grid's tiles, from left to right: numbers `begin` to `end`.
  struct Run {
    std::int64_t begin, end;
  };
  Run row(std::int64_t y) const {
    if (y < box_.y || y >= box_.y + box_.ny) return {0, 0};
    const auto r = static_cast<std::size_t>(y - box_.y);
    return {row_first_[r], row_first_[r + 1]};
  }

  // A tile's entries: positions in a vector over the domain, and cells in the tile, ascending. They are entries first(tile) to
  // first(tile + 1) of all.
  std::int64_t first(std::int64_t tile) const { return first_[static_cast<std::size_t>(tile)]; }
  std::int64_t entries(std::int64_t tile) const { return first(tile + 1) - first(tile); }
  const std::int64_t* positions(std::int64_t tile) const { return positions_.data() + first(tile); }
  const std::uint8_t* cells(std::int64_t tile) const { return cells_.data() + first(tile); }

 private:
  Frame box_;
  std::vector<std::int32_t> map_;  // of the box
  std::vector<TilePlace> places_;  // row by row
  std::vector<std::int64_t> row_first_;
  std::vector<std::int64_t> first_, positions_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace rc_split
