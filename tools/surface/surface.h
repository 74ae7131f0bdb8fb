// A measured surface: heights on a grid, x fastest, all lengths in metres.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cli {

struct Surface {
  std::int64_t nx = 0, ny = 0;
  std::optional<double> hx, hy;  // pitch along x and y; nothing where the file does not say
  std::vector<double> heights;
};

// Reads a file of any format in the table of readers. `unit` is metres per unit of lengths for which the file names no unit.
// Throws an Error that begins with the file's name; heights are finite.
Surface read_surface(const std::filesystem::path& path, double unit);

}  // namespace cli
