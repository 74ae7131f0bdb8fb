// Readers of single formats and what they share. A reader gets the whole file and throws an Error that says what is wrong with
// it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "surface/surface.h"

namespace cli {

inline constexpr std::string_view gsf_magic = "Gwyddion Simple Field 1.0\n";
inline constexpr std::string_view npy_magic = "\x93NUMPY";

Surface read_gsf(std::string_view file, double unit);
Surface read_npy(std::string_view file, double unit);
Surface read_text(std::string_view file, double unit);

// Throws unless nx, ny >= 1 and the data of nx*ny numbers fill exactly `available` bytes.
void check_data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t available);

// Metres per unit named in a file under `key`; `unit` where the name is empty. Throws if it is not a length.
double file_unit(std::string_view key, std::string_view name, double unit);

// The number stored at `bytes` in the given byte order.
template <class Number> Number stored_number(const char* bytes, std::endian order) {
  char raw[sizeof(Number)];
  std::memcpy(raw, bytes, sizeof raw);
  if (order != std::endian::native) std::reverse(raw, raw + sizeof raw);
  Number value;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

}  // namespace cli
