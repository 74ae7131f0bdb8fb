#include "pictures/raster.h"

#include <algorithm>

namespace cli {

std::vector<Cover> covers(std::int64_t points, std::int64_t pixels) {
  std::vector<Cover> found;
  for (std::int64_t pixel = 0; pixel < pixels; ++pixel) {
    // In units of a pixel-th of a point, in which all ends are whole numbers.
    const std::int64_t begin = pixel * points, end = begin + points;
    Cover cover{begin / pixels, {}};
    for (std::int64_t point = cover.first; point * pixels < end; ++point) {
      const std::int64_t part = std::min(end, (point + 1) * pixels) - std::max(begin, point * pixels);
      cover.weights.push_back(static_cast<double>(part) / static_cast<double>(points));
    }
    found.push_back(std::move(cover));
  }
  return found;
}

}  // namespace cli
