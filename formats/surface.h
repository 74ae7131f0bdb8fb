// A measured surface: heights on a grid, x fastest, all lengths in metres.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rc::formats {

// The unit of lengths that have none: what the caller gives, else m.
struct BareUnit {
  std::string name = "m";
  double metres = 1;
  bool given = false;
};

struct Surface {
  std::int64_t nx = 0, ny = 0;
  std::optional<double> hx, hy;  // pitch along x and y; nothing if the file does not say
  std::vector<double> heights;   // NaN: missing
  double full_scale = 0;         // the value of heights without a scale that stands for the height range; 0: they have one
  std::optional<bool> periodic;  // whether the surface repeats; nothing if the file does not say
  // The lengths that were read: "heights", "pitch", or both as "lengths"; the unit that the file names for them, "" if none;
  // metres.
  struct Length {
    std::string_view what;
    std::string unit;
    double metres;
  };
  std::vector<Length> lengths;
  std::string unclear_unit;  // a line with a unit that may or may not be that of the lengths; "" if there is none
  std::string file;          // its name, for messages
  std::string format;        // name of the format that was read
  std::string note;          // what the user should know about the file; "" if nothing

  void add_note(std::string_view text);
};

// Reads a file in the named format, or in the one that its contents or else its extension show. `unit` is that of lengths for
// which the file names none; `check_units` says whether they contradict each other. Heights are finite or NaN.
// Throws an Error that begins with the file's name.
Surface read_surface(const std::filesystem::path& path, const BareUnit& unit,
                     const std::optional<std::string>& format = std::nullopt);

// The same for a file in memory; `name` stands in messages, and shows the extension.
Surface read_surface(std::string_view file, const std::filesystem::path& name, const BareUnit& unit,
                     const std::optional<std::string>& format = std::nullopt);

}  // namespace rc::formats
