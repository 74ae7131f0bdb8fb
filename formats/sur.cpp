// Digital Surf's .sur, as written by Mountains and the instruments that embed it: a header of 512 bytes, a comment, private data,
// then nx*ny integers of 16 or 32 bits, x fastest. With magic DSCOMPRESSED the integers are in zlib streams: their number, the
// length of each unpacked and packed, then the streams. Heights are relative: the offset of z is not added.
#include <zlib.h>

#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::uint64_t header_size = 512;
constexpr std::uint16_t surface_type = 2;

std::string_view text_field(std::string_view header, std::uint64_t offset) {
  const auto text = header.substr(offset, 16);
  return trimmed(text.substr(0, text.find('\0')));
}

// The pitch along an axis or the height of a step.
double step_length(std::string_view header, std::string_view name, std::uint64_t number_at, double metres) {
  return file_length(name, metres * static_cast<double>(field<float>(header, number_at, name)));
}

// Appends what the stream holds if that is `expected` bytes.
bool inflate_stream(std::string_view packed, std::size_t expected, std::string& out) {
  const std::size_t before = out.size();
  out.resize(before + expected);
  auto size = static_cast<uLongf>(expected);
  const int status = uncompress(reinterpret_cast<Bytef*>(out.data() + before), &size,
                                reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
  return status == Z_OK && size == expected;
}

std::string inflate_streams(std::string_view data, std::size_t expected) {
  const std::uint64_t count = field<std::uint32_t>(data, 0, "the number of compressed streams");
  piece(data, 4, 8 * count, "the table of compressed streams");
  std::uint64_t at = 4 + 8 * count, unpacked = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto raw = field<std::uint32_t>(data, 4 + 8 * k, "the table of compressed streams");
    const auto packed = field<std::uint32_t>(data, 8 + 8 * k, "the table of compressed streams");
    piece(data, at, packed, "compressed stream " + std::to_string(k + 1));
    // zlib shrinks data to no less than a thousandth, which bounds what a small file may hold.
    if (raw > 1032 * std::uint64_t{packed} + 64) {
      throw Error("compressed stream ", k + 1, " claims ", raw, " bytes, more than ", packed,
                  " compressed ones can hold; the file is damaged");
    }
    at += packed;
    unpacked += raw;
  }
  if (unpacked != expected) {
    throw Error("the compressed streams hold ", unpacked, " bytes, the header asks for ", expected, "; the file is damaged");
  }

  std::string out;
  std::uint64_t from = 4 + 8 * count;
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto raw = field<std::uint32_t>(data, 4 + 8 * k, ""), packed = field<std::uint32_t>(data, 8 + 8 * k, "");
    if (!inflate_stream(data.substr(from, packed), raw, out))
      throw Error("compressed stream ", k + 1, " cannot be unpacked; the file is damaged");
    from += packed;
  }
  return out;
}

void check_kind(std::string_view header) {
  if (const auto order = field<std::uint16_t>(header, 12, "the byte order"); order != 0)
    throw Error("the byte order is ", order, ", only 0 (little-endian) can be read");
  if (const auto type = field<std::uint16_t>(header, 18, "the type"); type != surface_type) {
    throw Error("the studiable is of type ", type, ", only 2 (a surface) can be read", type == 1 ? "; 1 is a profile" : "");
  }
}

}  // namespace

Surface read_sur(std::string_view file, const BareUnit& unit) {
  const std::string_view header = piece(file, 0, header_size, "the header of 512 bytes");
  const bool compressed = header.starts_with("DSCOMPRESSED");
  if (!compressed && !header.starts_with("DIGITAL SURF"))
    throw Error("the file begins neither with DIGITAL SURF nor with DSCOMPRESSED");
  check_kind(header);

  Surface surface;
  surface.nx = field<std::int32_t>(header, 108, "nx");
  surface.ny = field<std::int32_t>(header, 112, "ny");
  const std::int64_t points = field<std::int32_t>(header, 116, "the number of points");
  if (surface.nx < 1 || surface.ny < 1 || surface.nx * surface.ny != points) {
    throw Error("the header says ", surface.nx, " x ", surface.ny, " points and ", points, " in all; the file is damaged");
  }
  const auto unit_at = [&](std::uint64_t at, std::string_view what) {
    return file_unit(surface, what, text_field(header, at), unit);
  };
  surface.hx = step_length(header, "the pitch along x", 120, unit_at(180, "pitch"));
  surface.hy = step_length(header, "the pitch along y", 124, unit_at(196, "pitch"));
  const double step = step_length(header, "the step of heights", 128, unit_at(212, "heights"));

  const auto bits = field<std::uint16_t>(header, 98, "the size of numbers");
  if (bits != 16 && bits != 32) throw Error("numbers have ", bits, " bits, only 16 and 32 can be read");
  const std::size_t bytes = bits / 8u;
  const std::uint64_t skipped = field<std::uint16_t>(header, 334, "the size of the comment") +
                                field<std::uint16_t>(header, 336, "the size of private data");
  piece(file, header_size, skipped, "the comment");
  const std::string_view rest = file.substr(header_size + skipped);
  const std::string unpacked =
      compressed ? inflate_streams(rest, packed_data_size(surface.nx, surface.ny, bytes, file.size())) : "";
  const std::string_view data =
      compressed ? std::string_view(unpacked) : rest.substr(0, data_size(surface.nx, surface.ny, bytes, rest.size()));

  const bool has_missing = field<std::uint16_t>(header, 86, "the flag of special points") == 1;
  const std::int64_t missing_code = std::int64_t{field<std::int32_t>(header, 100, "the lowest number")} - 2;
  const auto height = [&](std::int64_t raw) {
    return has_missing && raw == missing_code ? missing_height : step * static_cast<double>(raw);
  };
  if (bits == 16) append_numbers<std::int16_t>(data, std::endian::little, surface.heights, height);
  if (bits == 32) append_numbers<std::int32_t>(data, std::endian::little, surface.heights, height);
  if (const auto objects = field<std::uint16_t>(header, 14, "the number of objects"); objects > 1) {
    surface.add_note(join("the first of ", objects, " surfaces in the file is read"));
  }
  return surface;
}

}  // namespace rc::formats
