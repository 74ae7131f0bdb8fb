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
  std::vector<double> heights;   // NaN: missing
  std::string format;            // name of the format that was read
  std::string note;              // what the user should know about the file; "" if nothing
};

// Reads a file of any format in the registry: the one that is named, or the one that the contents or else the extension say.
// `unit` is metres per unit of lengths for which the file names no unit. Throws an Error that begins with the file's name;
// heights are finite or NaN.
Surface read_surface(const std::filesystem::path& path, double unit, const std::optional<std::string>& format = std::nullopt);

}  // namespace cli
