// A measured surface: heights on a grid, x fastest, all lengths in metres.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rc::formats {

struct Surface {
  std::int64_t nx = 0, ny = 0;
  std::optional<double> hx, hy;  // pitch along x and y; nothing if the file does not say
  std::vector<double> heights;   // NaN: missing
  std::optional<bool> periodic;  // whether the surface repeats; nothing if the file does not say
  bool names_unit = true;        // whether the file names the units of all its lengths
  std::string format;            // name of the format that was read
  std::string note;              // what the user should know about the file; "" if nothing
};

// Reads a file in the named format, or in the one that its contents or else its extension show. `unit` is metres per unit of
// lengths for which the file names no unit. Heights are finite or NaN. Throws an Error that begins with the file's name.
Surface read_surface(const std::filesystem::path& path, double unit, const std::optional<std::string>& format = std::nullopt);

// The same for a file in memory; `name` stands in messages, and shows the extension.
Surface read_surface(std::string_view file, const std::filesystem::path& name, double unit,
                     const std::optional<std::string>& format = std::nullopt);

}  // namespace rc::formats
