// Numbers from the bytes of an input, one after the other; zeros after the end.
#pragma once

#include <cstdint>
#include <string_view>

namespace fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : rest_(reinterpret_cast<const char*>(data), size) {}

  bool empty() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }
  /** -128 .. 127 */
  int whole() { return static_cast<std::int8_t>(byte()); }
  bool flag() { return (byte() & 1) != 0; }
  /** 0 .. count - 1 */
  std::size_t below(std::size_t count) { return byte() % count; }
  /** The text up to `end`, which is taken too. */
  std::string_view until(char end) {
    const auto length = rest_.find(end);
    const auto text = rest_.substr(0, length);
    rest_.remove_prefix(length == std::string_view::npos ? rest_.size() : length + 1);
    return text;
  }

 private:
  std::string_view rest_;
};

}  // namespace fuzz
