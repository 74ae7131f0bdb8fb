// Surfaces brought to the size of a picture.
#pragma once

#include <cstdint>
#include <vector>

namespace cli {

// A field on nx x ny cells, x fastest.
struct Raster {
  std::int64_t nx, ny;
  std::vector<float> values;
};

struct Size {
  std::int64_t width, height;  // pixels
};

// Reduces a field to at most one cell a pixel, by the means or the maxima of blocks. NaN is ignored; the mean of a block without
// numbers is NaN.
Raster block_mean(const std::vector<double>& field, std::int64_t nx, std::int64_t ny, Size size);
Raster block_max(const std::vector<double>& field, std::int64_t nx, std::int64_t ny, Size size);

// Grows spots of positive values to at least 2 x 2 pixels where the cells are smaller than that; larger spots keep their shape.
void grow_small_spots(Raster& raster, Size size);

}  // namespace cli
