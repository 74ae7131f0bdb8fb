// The regular grid on which scattered coordinates lie, whatever their order.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rc::formats {

struct GridAxis {
  double pitch;
  std::int64_t count;               // grid lines from the first to the last coordinate
  std::vector<std::int64_t> index;  // of each coordinate, 0 .. count-1
};

// Coordinates may be off their line by a tenth of the pitch, because files round them, and lines may be missing. `most_lines`
// bounds the number of lines. Throws an Error that names the axis if there is no such grid.
GridAxis find_grid_axis(const std::vector<double>& coordinates, std::int64_t most_lines, std::string_view name);

}  // namespace rc::formats
