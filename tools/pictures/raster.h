// Fields brought to the pixels of a picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cli {

struct Size {
  std::int64_t width, height;
};

// The part of points first .. that a pixel covers: the weights sum to 1.
struct Cover {
  std::int64_t first;
  std::vector<double> weights;
};
std::vector<Cover> covers(std::int64_t points, std::int64_t pixels);

// The mean of a field on nx x ny cells over each pixel, x fastest, by the area of the cells in it: the mean over all pixels is
// that over all cells, whatever the sizes. value(i): of cell i, finite.
template <class Value> std::vector<double> pixel_means(std::int64_t nx, std::int64_t ny, Size size, Value value) {
  const std::vector<Cover> columns = covers(nx, size.width), rows = covers(ny, size.height);
  std::vector<double> means;
  means.reserve(static_cast<std::size_t>(size.width * size.height));
  for (const Cover& row : rows) {
    for (const Cover& column : columns) {
      double mean = 0;
      for (std::size_t y = 0; y < row.weights.size(); ++y) {
        const std::int64_t start = (row.first + static_cast<std::int64_t>(y)) * nx + column.first;
        for (std::size_t x = 0; x < column.weights.size(); ++x)
          mean += row.weights[y] * column.weights[x] * value(static_cast<std::size_t>(start) + x);
      }
      means.push_back(mean);
    }
  }
  return means;
}

}  // namespace cli
