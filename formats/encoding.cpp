#include "formats/encoding.h"

#include <bit>
#include <cstdint>
#include <optional>

#include "formats/binary.h"
#include "formats/error.h"

namespace rc::formats {

namespace {

constexpr std::string_view utf8_mark = "\xef\xbb\xbf", little_mark = "\xff\xfe", big_mark = "\xfe\xff";
constexpr std::string_view wide_little{"\xff\xfe\0\0", 4}, wide_big{"\0\0\xfe\xff", 4};

// Whether the first bytes alternate between ASCII text and zeros, the text at even positions or at odd ones.
bool alternates(std::string_view file, std::size_t text_at) {
  constexpr std::size_t least = 8, looked_at = 64;
  const std::string_view begin = file.substr(0, looked_at);
  if (file.size() < least || file.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < begin.size(); ++i) {
    const bool printable = (begin[i] >= ' ' && begin[i] <= '~') || begin[i] == '\t' || begin[i] == '\r' || begin[i] == '\n';
    if (i % 2 == text_at ? !printable : begin[i] != '\0') return false;
  }
  return true;
}

std::optional<std::endian> order_of_utf16(std::string_view file) {
  if (file.starts_with(little_mark) || alternates(file, 0)) return std::endian::little;
  if (file.starts_with(big_mark) || alternates(file, 1)) return std::endian::big;
  return std::nullopt;
}

void append_utf8(std::uint32_t code, std::string& out) {
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr unsigned first[] = {0, 0xc0, 0xe0, 0xf0};
  out += static_cast<char>(first[more] | code >> (6 * more));
  for (int k = more - 1; k >= 0; --k) out += static_cast<char>(0x80 | (code >> (6 * k) & 0x3f));
}

std::string from_utf16(std::string_view file, std::endian order) {
  if (file.size() % 2 != 0) throw Error("the text is in UTF-16, but ends within a character; it is truncated");
  const auto unit = [&](std::size_t at) -> std::uint32_t { return stored_number<std::uint16_t>(file.data() + at, order); };
  std::string out;
  out.reserve(file.size() / 2);
  for (std::size_t at = unit(0) == 0xfeff ? 2 : 0; at < file.size(); at += 2) {
    std::uint32_t code = unit(at);
    const bool pair = code >= 0xd800 && code < 0xdc00 && at + 2 < file.size() && (unit(at + 2) & 0xfc00) == 0xdc00;
    if (pair) {
      code = 0x10000 + ((code - 0xd800) << 10) + (unit(at + 2) - 0xdc00);
      at += 2;
    }
    append_utf8(code, out);
  }
  return out;
}

}  // namespace

std::string_view decoded(std::string_view file, std::string& converted) {
  if (file.starts_with(utf8_mark)) return file.substr(utf8_mark.size());
  if (file.starts_with(wide_little) || file.starts_with(wide_big)) throw Error("the text is in UTF-32; save it as UTF-8");
  const auto order = order_of_utf16(file);
  if (!order) return file;
  converted = from_utf16(file, *order);
  return converted;
}

}  // namespace rc::formats
