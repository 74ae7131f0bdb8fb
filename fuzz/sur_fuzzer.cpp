// Digital Surf. A plain file that can be read is also packed, and must then read the same. Damaged streams alone would never get
// past zlib's checksums.
#include <zlib.h>

#include <cstring>

#include "formats/readers.h"
#include "reader.h"
#include "require.h"

namespace {

constexpr std::size_t header_size = 512;

void append_word(std::string& file, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) file.push_back(static_cast<char>(word >> shift & 0xff));
}

// The same heights as one stream, without what follows them.
std::string packed(std::string_view file, std::size_t points) {
  const std::size_t skipped =
      rc::formats::field<std::uint16_t>(file, 334, "") + std::size_t{rc::formats::field<std::uint16_t>(file, 336, "")};
  const std::string_view data =
      file.substr(header_size + skipped, points * (rc::formats::field<std::uint16_t>(file, 98, "") / 8u));
  std::string stream(compressBound(data.size()), '\0');
  uLongf length = stream.size();
  fuzz::require(compress2(reinterpret_cast<Bytef*>(stream.data()), &length, reinterpret_cast<const Bytef*>(data.data()),
                          data.size(), 1) == Z_OK,
                "zlib packs");
  std::string result = "DSCOMPRESSED" + std::string(file.substr(12, header_size - 12 + skipped));
  append_word(result, 1);
  append_word(result, static_cast<std::uint32_t>(data.size()));
  append_word(result, static_cast<std::uint32_t>(length));
  return result.append(stream, 0, length);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view file = fuzz::text(data, size);
  const auto surface = fuzz::check_reader(rc::formats::read_sur, file);
  if (!surface || !file.starts_with("DIGITAL SURF")) return 0;
  const auto again = fuzz::check_reader(rc::formats::read_sur, packed(file, surface->heights.size()));
  fuzz::require(again && same_bits(again->heights, surface->heights), "a packed file reads as the plain one");
  return 0;
}
