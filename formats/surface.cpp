#include "formats/surface.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>

#include "formats/encoding.h"
#include "formats/error.h"
#include "formats/readers.h"
#include "formats/registry.h"
#include "formats/units.h"
#include "formats/wording.h"
#include "platform/files.h"

namespace rc::formats {

namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& path) {
  std::error_code error;
  const auto type = fs::status(path, error).type();
  if (type == fs::file_type::directory) throw Error("is a folder, give a file");
  if (type == fs::file_type::character || type == fs::file_type::block) throw Error("is a device, give a file");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{rc_platform::open_to_read(path), std::fclose};
  if (!stream) throw Error(std::strerror(errno));

  std::string bytes;
  if (const auto size = fs::file_size(path, error); !error) bytes.reserve(size);
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, stream.get())) bytes.append(block, count);
  if (std::ferror(stream.get())) throw Error(std::strerror(errno));
  return bytes;
}

// Returns the result of work(); adds the file's name to its Error.
template <class Work> auto of_file(const fs::path& path, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(path.empty() ? "the file" : path.string(), ": ", error.what());
  }
}

}  // namespace

std::string_view piece(std::string_view file, std::uint64_t offset, std::uint64_t size, std::string_view what) {
  if (offset > file.size() || size > file.size() - offset) {
    throw Error("the file has ", file.size(), " bytes and ends within ", what, " (", size, " bytes from byte ", offset,
                "); it is truncated");
  }
  return file.substr(offset, size);
}

std::size_t data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t available) {
  const std::string grid = join(nx, " x ", ny);
  if (nx < 1 || ny < 1) throw Error("the header says ", grid, " points, at least 1 x 1 are needed");

  // Divides, because nx*ny of a wrong header may overflow.
  const auto columns = static_cast<std::uint64_t>(nx), rows = static_cast<std::uint64_t>(ny);
  const std::uint64_t numbers = available / bytes_per_number;
  if (rows > numbers / columns) {
    throw Error("the header says ", grid, " points, but the file has data for ", numbers, "; it is truncated");
  }
  return columns * rows * bytes_per_number;
}

void check_data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t available) {
  const std::size_t size = data_size(nx, ny, bytes_per_number, available);
  if (size == available) return;
  throw Error("the header says ", nx, " x ", ny, " points, but ", available - size, " bytes follow their data");
}

std::size_t packed_data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t file_size) {
  const std::uint64_t most = most_unpacked(file_size) / std::max(bytes_per_number, sizeof(double));
  if (nx >= 1 && ny >= 1 && static_cast<std::uint64_t>(ny) > most / static_cast<std::uint64_t>(nx)) {
    throw Error("the header says ", nx, " x ", ny, " points, more than the ", most, " that are unpacked from a file of ",
                file_size, " bytes; it is truncated or damaged");
  }
  return data_size(nx, ny, bytes_per_number, most_unpacked(file_size));
}

void Surface::add_note(std::string_view text) { note += join(note.empty() ? "" : "; ", text); }

double file_unit(Surface& surface, std::string_view what, std::string_view name, const BareUnit& unit) {
  const auto metres = name.empty() ? unit.metres : metres_per(name);
  if (!metres) throw Error("the unit of the ", what, " ", in_quotes(name), " is not a length, known are ", known_lengths);
  if (name == "A") surface.add_note(join("the unit A of the ", what, " is read as angstrom"));
  surface.lengths.push_back({what, std::string(name), *metres});
  return *metres;
}

double file_length(std::string_view key, double metres) {
  constexpr double least = 1e-18, most = 1e9;  // beyond these a header is damaged
  if (metres >= least && metres <= most) return metres;
  throw Error(key, " is ", rc::in_digits(metres, 6), " m, ",
              metres > 0 && std::isfinite(metres) ? "which no surface has; the header is damaged" : "not a positive length");
}

Surface read_surface(const fs::path& path, const BareUnit& unit, const std::optional<std::string>& format) {
  if (format) named_format(*format);  // an unknown one is refused before the file is read
  return read_surface(of_file(path, [&] { return contents(path); }), path, unit, format);
}

Surface read_surface(std::string_view file, const fs::path& name, const BareUnit& unit,
                     const std::optional<std::string>& format) {
  const Format* const named = format ? &named_format(*format) : nullptr;
  return of_file(name, [&] {
    std::string converted;
    const std::string_view plain = decoded(file, converted);
    const Format& chosen = named ? *named : recognised_format(plain, lower_case(name.extension().string()));
    const bool guessed = !named && chosen.read == read_text;
    Surface surface = guessed ? read_text_or_points(plain, unit) : chosen.read(plain, unit);
    if (surface.format.empty()) surface.format = chosen.name;
    surface.file = name.empty() ? "the file" : name.string();
    for (double& z : surface.heights) {
      if (!std::isfinite(z)) z = missing_height;
    }
    return surface;
  });
}

}  // namespace rc::formats
