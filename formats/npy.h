// The place of the numbers in a .npy file, for readers of a part of them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rc::formats {

inline constexpr std::size_t npy_longest_header = 1 << 16;

struct NpyLayout {
  std::int64_t ny, nx;
  bool fortran_order;  // columns are whole in the file, not rows
  bool floating;       // the numbers are not integers
  std::size_t size;    // bytes of a number
  double (*load)(const char* bytes, std::endian order);
  std::endian order;
  std::size_t data;  // bytes before the first number

  double number(const char* bytes) const { return load(bytes, order); }
};

// The layout of a file that begins with these bytes; 12 + npy_longest_header are enough. Throws an Error that names the fault of
// the header. Does not check whether the data are complete.
NpyLayout npy_layout(std::string_view file);

}  // namespace rc::formats
