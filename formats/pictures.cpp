#include "formats/pictures.h"

#include <bit>

#include "formats/error.h"

namespace rc::formats {

void check_picture(std::int64_t nx, std::int64_t ny, int channels, int bits, Samples samples) {
  if (channels != 1)
    throw Error("the picture has ", channels, " channels; heights are one channel of grey, without transparency");
  const bool known = samples == Samples::whole ? bits == 8 || bits == 16 || bits == 32 : bits == 32 || bits == 64;
  if (!known)
    throw Error("the picture has samples of ", bits,
                " bits, read are whole numbers of 8, 16 and 32 bits, and floats of 32 and 64");
  constexpr std::int64_t most = std::int64_t{1} << 31;
  if (nx < 1 || ny < 1 || nx > most || ny > most)
    throw Error("the header says ", nx, " x ", ny, " points, at least 1 x 1 are needed");
}

Surface surface_of_picture(std::int64_t nx, std::int64_t ny, int bits, Samples samples, std::string_view rows,
                           const BareUnit& unit) {
  Surface surface;
  surface.nx = nx;
  surface.ny = ny;
  const auto append = [&]<class Number>(Number, double factor) {
    append_numbers<Number>(rows, std::endian::native, surface.heights,
                           [factor](Number z) { return factor * static_cast<double>(z); });
  };
  if (samples == Samples::real) {
    const double metres = file_unit(surface, "heights", "", unit);
    bits == 32 ? append(float{}, metres) : append(double{}, metres);
    return surface;
  }
  if (bits == 8) append(std::uint8_t{}, 1);
  if (bits == 16) append(std::uint16_t{}, 1);
  if (bits == 32) append(std::uint32_t{}, 1);
  surface.full_scale = static_cast<double>((std::uint64_t{1} << bits) - 1);
  if (bits == 8) surface.add_note("heights have 8 bits: their steps are the height range over 255");
  return surface;
}

}  // namespace rc::formats
