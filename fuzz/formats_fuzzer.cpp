// The readers' library: any file in memory, with a format, a unit and a pitch from the bytes. A refused call writes nothing and
// says why; what is read is prepared, and given back.
#include <roughcontact/formats.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <span>
#include <string>

#include "bytes.h"
#include "require.h"

namespace {

using fuzz::require;

constexpr std::int64_t most_prepared = 1 << 12;  // points; more would only be slow

double number(fuzz::Bytes& bytes) {
  const int kind = bytes.whole();
  if (kind < -100) return kind < -115 ? NAN : INFINITY;
  return kind < 0 ? 0 : kind < 20 ? kind - 10 : std::pow(10.0, kind - 70);
}

void require_result(rc_status status) {
  const std::string message = rc_surface_read_last_error();
  require(status == RC_OK || status == RC_ERR_ARGUMENT || status == RC_ERR_MEMORY, "a documented status");
  require((status == RC_OK) == message.empty(), "what is refused is explained");
  require(message.find_first_of("\n\r") == std::string::npos, "an error is one line");
}

void require_in_order(const rc_surface_file& file) {
  require(file.nx >= 1 && file.ny >= 1 && file.heights, "a surface has points");
  const std::span heights(file.heights, static_cast<std::size_t>(file.nx * file.ny));
  require(std::ranges::none_of(heights, [](double z) { return std::isinf(z); }), "heights are finite or missing");
  require(std::ranges::count_if(heights, [](double z) { return std::isnan(z); }) == file.missing, "missing points are counted");
  for (const double h : {file.hx, file.hy}) require(h >= 0, "a pitch is positive, or 0 where it is not known");
  require(std::memchr(file.format, 0, sizeof file.format) && std::memchr(file.assumed, 0, sizeof file.assumed), "texts end");
  require(file.format[0] != '\0', "the format is named");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, std::min<std::size_t>(size, 4));
  constexpr const char* units[] = {nullptr, "m", "um", "nm", "km", "V", ""};
  constexpr const char* formats[] = {nullptr, nullptr, nullptr, "text", "xyz", "plu", "sdf", "nc", "pfu"};
  constexpr const char* names[] = {nullptr, "a.txt", "a.xyz", "a.plu", "a.X3P", "a", "", ".gsf", "a.zip"};
  rc_surface_read_spec spec = RC_SURFACE_READ_SPEC_INIT;
  const std::uint8_t first = bytes.byte(), second = bytes.byte();
  spec.unit = units[first % std::size(units)];
  spec.format = formats[second % std::size(formats)];
  const char* const name = names[(second / 16) % std::size(names)];
  spec.hx = number(bytes);
  spec.hy = number(bytes);

  rc_surface_file file = RC_SURFACE_FILE_INIT;
  const rc_surface_file untouched = file;
  const std::size_t skipped = std::min<std::size_t>(size, 4);
  const rc_status status = rc_surface_read_memory(data + skipped, size - skipped, name, &spec, &file);
  require_result(status);
  require(status == RC_OK || std::memcmp(&file, &untouched, sizeof file) == 0, "a refused call writes nothing");
  if (status != RC_OK) return 0;
  require_in_order(file);
  if (file.nx * file.ny <= most_prepared) {
    require_result(rc_surface_remove_form(file.nx, file.ny, 1 + first % 3, file.heights));
    require_result(rc_surface_fill(file.nx, file.ny, file.hx > 0 ? file.hx : 1, file.hy > 0 ? file.hy : 1, file.heights));
  }
  rc_surface_file_free(&file);
  require(!file.heights && !file.storage, "freed");
  return 0;
}
