#include "files/array_files.h"

#include <bit>
#include <cstddef>

#include "core/text.h"
#include "formats/readers.h"
#include "text.h"

namespace cli {

namespace {

template <class Bits> void write_little_endian(std::FILE* file, Bits bits) {
  unsigned char bytes[sizeof bits];
  for (std::size_t k = 0; k < sizeof bits; ++k) bytes[k] = static_cast<unsigned char>(bits >> (8 * k));
  std::fwrite(bytes, 1, sizeof bytes, file);
}

}  // namespace

std::string npy_header(std::int64_t nx, std::int64_t ny, const char* descr) {
  constexpr std::size_t preamble = 10;
  std::string dictionary = rc::join("{'descr': '", descr, "', 'fortran_order': False, 'shape': (", ny, ", ", nx, "), }");
  while ((preamble + dictionary.size() + 1) % 64 != 0) dictionary += ' ';
  dictionary += '\n';

  std::string header{"\x93NUMPY\x01\x00", 8};
  header += static_cast<char>(dictionary.size() & 0xff);
  header += static_cast<char>(dictionary.size() >> 8);
  return header + dictionary;
}

void write_npy(std::FILE* file, const std::vector<double>& values, std::int64_t nx, std::int64_t ny) {
  const std::string header = npy_header(nx, ny);
  std::fwrite(header.data(), 1, header.size(), file);
  for (const double value : values) write_little_endian(file, std::bit_cast<std::uint64_t>(value));
}

void write_gsf(std::FILE* file, const Surface& surface) {
  std::string header = rc::join(gsf_magic, "XRes = ", surface.nx, "\nYRes = ", surface.ny, "\n");
  header += format("XReal = %.17g\nYReal = %.17g\nXYUnits = m\nZUnits = m\n", *surface.hx * static_cast<double>(surface.nx),
                   *surface.hy * static_cast<double>(surface.ny));
  if (surface.periodic) header += rc::join("Periodic = ", *surface.periodic ? 1 : 0, "\n");
  header.append(4 - header.size() % 4, '\0');
  std::fwrite(header.data(), 1, header.size(), file);
  for (const double z : surface.heights) write_little_endian(file, std::bit_cast<std::uint32_t>(static_cast<float>(z)));
}

}  // namespace cli
