#include "files/array_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/text.h"
#include "formats/error.h"
#include "formats/readers.h"
#include "text.h"

namespace cli {

namespace {

template <class Value> void write_little_endian(std::FILE* file, std::vector<Value> values) {
  if constexpr (std::endian::native == std::endian::big)
    for (Value& value : values) std::reverse(reinterpret_cast<char*>(&value), reinterpret_cast<char*>(&value + 1));
  std::fwrite(values.data(), sizeof(Value), values.size(), file);
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
  write_little_endian(file, values);
}

void write_gsf(std::FILE* file, const Surface& surface) {
  std::vector<float> heights;
  double largest = 0, error = 0;
  for (const double z : surface.heights) {
    heights.push_back(static_cast<float>(z));
    largest = std::max(largest, std::abs(z));
    error = std::max(error, std::abs(static_cast<double>(heights.back()) - z));
  }
  if (!(error <= 1e-6 * largest))
    throw Error("the heights are beyond the range of single precision, which a .gsf file has: write a .npy file");
  std::string header = rc::join(gsf_magic, "XRes = ", surface.nx, "\nYRes = ", surface.ny, "\n");
  header += format("XReal = %.17g\nYReal = %.17g\nXYUnits = m\nZUnits = m\n", *surface.hx * static_cast<double>(surface.nx),
                   *surface.hy * static_cast<double>(surface.ny));
  if (surface.periodic) header += rc::join("Periodic = ", *surface.periodic ? 1 : 0, "\n");
  header.append(4 - header.size() % 4, '\0');
  std::fwrite(header.data(), 1, header.size(), file);
  write_little_endian(file, std::move(heights));
}

}  // namespace cli
