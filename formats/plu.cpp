// Sensofar's PLu, also written by the Leica DCM3D. Little-endian: at byte 388 ny, nx, a count (u32), then dy/dx, dx, dy (f32,
// micrometres) and more; at 428 the type of the measurement; at 500 ny and nx again, and from 508 on the heights (f32,
// micrometres, x fastest). What follows them (range, pictures) is not read.
#include "formats/error.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::uint32_t topography = 3;
constexpr float missing_code = 1000001;
constexpr std::uint64_t data_start = 508;

}  // namespace

Surface read_plu(std::string_view file, const BareUnit& unit) {
  const std::string_view header = piece(file, 0, data_start, "the header of 508 bytes");
  if (const auto type = field<std::uint32_t>(header, 428, "the type"); type != topography) {
    throw Error("the measurement is of type ", type, ", only 3 (a topography) can be read", type == 1 ? "; 1 is a profile" : "");
  }

  Surface surface;
  surface.ny = field<std::uint32_t>(header, 500, "ny");
  surface.nx = field<std::uint32_t>(header, 504, "nx");
  const auto ny = field<std::uint32_t>(header, 388, "ny"), nx = field<std::uint32_t>(header, 392, "nx");
  if (nx != surface.nx || ny != surface.ny) {
    throw Error("the header says ", nx, " x ", ny, " points at byte 388 and ", surface.nx, " x ", surface.ny,
                " at byte 500; the file is damaged or not a .plu");
  }
  file_unit(surface, "lengths", "um", unit);
  surface.hx = file_length("the pitch along x", 1e-6 * static_cast<double>(field<float>(header, 404, "dx")));
  surface.hy = file_length("the pitch along y", 1e-6 * static_cast<double>(field<float>(header, 408, "dy")));

  const std::string_view data = file.substr(data_start);
  const std::size_t size = data_size(surface.nx, surface.ny, sizeof(float), data.size());
  append_numbers<float>(data.substr(0, size), std::endian::little, surface.heights,
                        [](float z) { return z == missing_code ? missing_height : 1e-6 * static_cast<double>(z); });
  return surface;
}

}  // namespace rc::formats
