// The part of H that is summed directly: all of H within a box, or H less its smooth part, a difference that ends at the cutoff.
#pragma once

#include <cstdint>
#include <vector>

#include "aligned.h"
#include "kernel.h"
#include "loops.h"

namespace rc_split {

// Which tiles a tile interacts with directly.
struct Range {
  std::int64_t x = 0, y = 0;        // tiles
  std::int64_t rows = 0;            // cells along y
  std::vector<std::int64_t> width;  // [y + 1]: tiles to either side at so many tiles' distance along y

  // All tiles with a cell centre within `distance` of one of the tile's.
  static Range within(double distance, double hx, double hy);
  static Range of_box(std::int64_t tiles_x, std::int64_t tiles_y);
};

template <class T> class ShortRange {
 public:
  // H less its smooth part of cutoff rc.
  ShortRange(Kernel& kernel, const Smoothed& smoothed, double rc);
  // H between the tiles of a box.
  ShortRange(Kernel& kernel, std::int64_t tiles_x, std::int64_t tiles_y);

  const Range& range() const { return range_; }
  // The entry between a point and one x cells to the right of it and y below; the next ones along a row follow, and those of the
  // next row are ld() further on.
  const T* entry(std::int64_t x, std::int64_t y) const { return table_.data() + (my_ + y) * ld_ + mx_ + x; }
  std::ptrdiff_t ld() const { return ld_; }
  // The lowest entry, or 0.
  double lowest() const { return lowest_; }

 private:
  template <class Value> void fill(std::int64_t nx, std::int64_t ny, const Value& value);

  Range range_;
  std::int64_t mx_, my_, ld_;  // the table holds offsets from -mx, -my to mx, my
  double lowest_ = 0;
  Array<T> table_;
};

}  // namespace rc_split
