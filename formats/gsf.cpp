// Gwyddion Simple Field: a text header of "Name = value" lines, NUL bytes up to a multiple of four (at least one), then XRes*YRes
// little-endian float32 heights, rows from top to bottom. XReal and YReal are the size of the whole field. Gwyddion keeps
// lines that it does not know; two are this project's own: "Periodic = 1" (0), the surface repeats (does not), and "ZOffset",
// which was taken off the heights before they became float32.
#include <cmath>
#include <map>
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::size_t longest_header = 1 << 16;

using Header = std::map<std::string_view, std::string_view>;

Header parse_header(std::string_view text) {
  Header header;
  int number = 1;  // the magic line is the first
  for (const auto line : split(text, '\n')) {
    ++number;
    if (trimmed(line).empty()) continue;
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) throw Error("header line ", number, " ", in_quotes(line), " has no '='");
    header[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  return header;
}

std::int64_t resolution(const Header& header, std::string_view key) {
  const auto entry = header.find(key);
  if (entry == header.end()) throw Error("the header has no ", key);
  return whole_number(key, entry->second);
}

std::string_view text_of(const Header& header, std::string_view key) {
  const auto entry = header.find(key);
  return entry == header.end() ? std::string_view{} : entry->second;
}

std::optional<double> pitch(const Header& header, std::string_view key, std::int64_t points, double unit) {
  const auto entry = header.find(key);
  if (entry == header.end()) return std::nullopt;
  const double size = finite_number(key, entry->second);
  return file_length(std::string(key) + " over the points", size * unit / static_cast<double>(points));
}

double offset(const Header& header) {
  const auto text = text_of(header, "ZOffset");
  return text.empty() ? 0 : finite_number("ZOffset", text);
}

std::optional<bool> repeats(const Header& header) {
  const auto text = text_of(header, "Periodic");
  if (text.empty()) return std::nullopt;
  if (text != "0" && text != "1") throw Error("Periodic ", in_quotes(text), " is neither 0 nor 1");
  return text == "1";
}

}  // namespace

Surface read_gsf(std::string_view file, const BareUnit& unit) {
  if (!file.starts_with(gsf_magic)) throw Error("the first line is not \"Gwyddion Simple Field 1.0\"");
  const auto end = file.substr(0, longest_header).find('\0');
  if (end == std::string_view::npos) throw Error("the header has no end within ", longest_header, " bytes");
  const Header header = parse_header(file.substr(gsf_magic.size(), end - gsf_magic.size()));

  const std::size_t start = (end / 4 + 1) * 4;
  if (start > file.size() || file.substr(end, start - end).find_first_not_of('\0') != std::string_view::npos) {
    throw Error("the header is not padded with NUL bytes to a multiple of 4");
  }
  const std::string_view data = file.substr(start);

  Surface surface;
  surface.nx = resolution(header, "XRes");
  surface.ny = resolution(header, "YRes");
  check_data_size(surface.nx, surface.ny, sizeof(float), data.size());

  const auto lateral_unit = text_of(header, "XYUnits"), vertical_unit = text_of(header, "ZUnits");
  const bool has_pitch = header.contains("XReal") || header.contains("YReal");
  const double lateral = has_pitch ? file_unit(surface, "pitch", lateral_unit, unit) : 1;
  surface.hx = pitch(header, "XReal", surface.nx, lateral);
  surface.hy = pitch(header, "YReal", surface.ny, lateral);

  surface.periodic = repeats(header);
  const double vertical = file_unit(surface, "heights", vertical_unit, unit);
  append_numbers<float>(data, std::endian::little, surface.heights, [vertical, taken_off = offset(header)](float z) {
    return vertical * (static_cast<double>(z) + taken_off);
  });
  return surface;
}

}  // namespace rc::formats
