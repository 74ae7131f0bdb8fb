// Numbers stored in files: every access is checked against the end of the file.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace rc::formats {

// The number stored at `bytes` in the given byte order.
template <class Number> Number stored_number(const char* bytes, std::endian order) {
  char raw[sizeof(Number)];
  std::memcpy(raw, bytes, sizeof raw);
  if (order != std::endian::native) std::reverse(raw, raw + sizeof raw);
  Number value;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

// `size` bytes from `offset` on; an Error that names `what` where the file is shorter.
std::string_view piece(std::string_view file, std::uint64_t offset, std::uint64_t size, std::string_view what);

template <class Number>
Number field(std::string_view file, std::uint64_t offset, std::string_view what, std::endian order = std::endian::little) {
  return stored_number<Number>(piece(file, offset, sizeof(Number), what).data(), order);
}

// Appends convert(number) for every number in `data`.
template <class Number, class Convert>
void append_numbers(std::string_view data, std::endian order, std::vector<double>& out, Convert convert) {
  out.reserve(out.size() + data.size() / sizeof(Number));
  for (std::size_t at = 0; at + sizeof(Number) <= data.size(); at += sizeof(Number)) {
    out.push_back(convert(stored_number<Number>(data.data() + at, order)));
  }
}

}  // namespace rc::formats
