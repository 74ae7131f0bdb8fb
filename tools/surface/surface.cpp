#include "surface/surface.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>

#include "error.h"
#include "surface/readers.h"
#include "text.h"
#include "units.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

struct Format {
  std::string_view name;
  std::string_view magic;       // how such a file begins; "": not recognisable by its contents
  std::string_view extensions;  // each followed by a space
  Surface (*read)(std::string_view file, double unit);
};

constexpr Format formats[] = {
    {"Gwyddion Simple Field", gsf_magic, ".gsf ", read_gsf},
    {"NumPy array", npy_magic, ".npy ", read_npy},
    {"text matrix", "", ".txt .csv .tsv .dat .asc ", read_text},
};

std::string contents(const fs::path& path) {
  std::error_code error;
  const auto type = fs::status(path, error).type();
  if (type == fs::file_type::directory) throw Error("is a folder, give a file");
  if (type == fs::file_type::character || type == fs::file_type::block) throw Error("is a device, give a file");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::fopen(path.c_str(), "rb"), std::fclose};
  if (!stream) throw Error(std::strerror(errno));

  std::string bytes;
  if (type == fs::file_type::regular) bytes.reserve(fs::file_size(path));
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, stream.get())) bytes.append(block, count);
  if (std::ferror(stream.get())) throw Error(std::strerror(errno));
  return bytes;
}

const Format& format_of(const fs::path& path, std::string_view file) {
  const auto by_magic = [&](const Format& f) { return !f.magic.empty() && file.starts_with(f.magic); };
  if (const auto found = std::ranges::find_if(formats, by_magic); found != std::end(formats)) return *found;

  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  const auto by_extension = [&](const Format& f) { return f.extensions.find(extension + " ") != std::string_view::npos; };
  const auto found = std::ranges::find_if(formats, by_extension);
  if (!extension.empty() && found != std::end(formats)) return *found;

  std::string known;
  for (const auto& f : formats)
    known += (known.empty() ? "" : ", ") + std::string(f.name) + " (" + std::string(trimmed(f.extensions)) + ")";
  throw Error("unknown format, readable are " + known);
}

void check_finite(const Surface& surface) {
  const auto missing = [](double z) { return !std::isfinite(z); };
  const auto count = std::ranges::count_if(surface.heights, missing);
  if (count == 0) return;

  const auto first = std::ranges::find_if(surface.heights, missing) - surface.heights.begin();
  throw Error(std::to_string(count) + (count == 1 ? " missing value" : " missing values") +
              ", first at ix=" + std::to_string(first % surface.nx) + ", iy=" + std::to_string(first / surface.nx) + "; fill " +
              (count == 1 ? "it" : "them") + " first");
}

}  // namespace

void check_data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t available) {
  const std::string grid = std::to_string(nx) + " x " + std::to_string(ny);
  if (nx < 1 || ny < 1) throw Error("the header says " + grid + " points, at least 1 x 1 are needed");

  // Divides instead of multiplying: nx*ny of a wrong header may be beyond any integer.
  const auto columns = static_cast<std::uint64_t>(nx), rows = static_cast<std::uint64_t>(ny);
  const std::uint64_t numbers = available / bytes_per_number;
  if (rows > numbers / columns) {
    throw Error("the header says " + grid + " points, but the file has data for " + std::to_string(numbers) +
                "; it is truncated");
  }
  if (columns * rows * bytes_per_number != available) {
    throw Error("the header says " + grid + " points, but " + std::to_string(available - columns * rows * bytes_per_number) +
                " bytes follow their data");
  }
}

double file_unit(std::string_view key, std::string_view name, double unit) {
  if (name.empty()) return unit;
  if (const auto metres = metres_per(name)) return *metres;
  throw Error(std::string(key) + " " + in_quotes(name) +
              " is not a length, known are m and m with an SI prefix (mm, um, nm, pm)");
}

Surface read_surface(const fs::path& path, double unit) {
  try {
    const std::string file = contents(path);
    Surface surface = format_of(path, file).read(file, unit);
    check_finite(surface);
    return surface;
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

}  // namespace cli
