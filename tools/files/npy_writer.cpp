#include "files/npy_writer.h"

#include <array>
#include <bit>
#include <cstddef>
#include <string>

#include "text.h"

namespace cli {

namespace {

std::array<unsigned char, 8> little_endian(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  std::array<unsigned char, 8> bytes{};
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<unsigned char>(bits >> (8 * k));
  return bytes;
}

}  // namespace

std::string npy_header(std::int64_t nx, std::int64_t ny, const char* descr) {
  constexpr std::size_t preamble = 10;
  std::string dictionary = format("{'descr': '%s', 'fortran_order': False, 'shape': (%lld, %lld), }", descr,
                                  static_cast<long long>(ny), static_cast<long long>(nx));
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
  for (const double value : values) {
    const auto bytes = little_endian(value);
    std::fwrite(bytes.data(), 1, bytes.size(), file);
  }
}

}  // namespace cli
