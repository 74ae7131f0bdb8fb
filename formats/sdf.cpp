// Surface data file of ISO 25178-71, which comes from BCR and NPL. Text: a first line "aISO-1.0", lines "key = value" and ";"
// comments, a line "*", nx*ny numbers with BAD where one is missing. Binary: "bISO-1.0", a header of 81 bytes, numbers. Heights
// are numbers times Zscale, in metres; the lowest integer (text: none) and NaN are missing.
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <type_traits>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/text_rows.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::uint64_t binary_header = 81;
constexpr std::size_t longest_sdf_header = 1 << 16;

using SdfHeader = std::map<std::string, std::string_view>;  // keys in lower case: writers disagree

// Cuts the lines up to the one with '*' off the file.
SdfHeader take_sdf_header(std::string_view& file) {
  SdfHeader header;
  for (std::size_t before = file.size();; before = file.size()) {
    const auto line = take_line(file);
    if (line == "*") return header;
    if (file.empty() || header.size() > 1000 || before - file.size() > longest_sdf_header)
      throw Error("the header has no end: a line \"*\" is missing; the file is truncated or damaged");
    const auto equals = line.find('=');
    if (line.empty() || line.starts_with(';')) continue;
    if (equals == std::string_view::npos && !header.empty()) throw Error("header line ", in_quotes(line), " has no '='");
    if (equals == std::string_view::npos) {
      header["magic"] = line;
    } else {
      header[lower_case(trimmed(line.substr(0, equals)))] = trimmed(line.substr(equals + 1));
    }
  }
}

std::string_view entry(const SdfHeader& header, const std::string& key) {
  const auto found = header.find(lower_case(key));
  if (found == header.end()) throw Error("the header has no ", key);
  return found->second;
}

std::string_view take_word(std::string_view& text) {
  constexpr std::string_view space = " \t\r\n\f\v";
  text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
  const auto word = text.substr(0, text.find_first_of(space));
  text.remove_prefix(word.size());
  return word;
}

Surface read_ascii(std::string_view file) {
  const SdfHeader header = take_sdf_header(file);
  Surface surface;
  surface.nx = whole_number("NumPoints", entry(header, "NumPoints"));
  surface.ny = whole_number("NumProfiles", entry(header, "NumProfiles"));
  surface.hx = file_length("Xscale", finite_number("Xscale", entry(header, "Xscale")));
  surface.hy = file_length("Yscale", finite_number("Yscale", entry(header, "Yscale")));
  const double scale = file_length("Zscale", finite_number("Zscale", entry(header, "Zscale")));
  const std::size_t count = data_size(surface.nx, surface.ny, 2, file.size() + 1) / 2;  // a digit and a space each

  surface.heights.reserve(count);
  while (surface.heights.size() < count) {
    const auto word = take_word(file);
    const auto value = lower_case(word) == "bad" ? missing_height : to_number(word);
    if (word.empty() || word == "*") {
      throw Error("the header says ", surface.nx, " x ", surface.ny, " points, but the file has ", surface.heights.size(),
                  "; it is truncated");
    }
    if (!value) throw Error("number ", surface.heights.size() + 1, ": ", in_quotes(word), " is not a number");
    surface.heights.push_back(scale * *value);
  }
  if (const auto word = take_word(file); !word.empty() && word != "*")
    throw Error("more numbers follow the ", count, " that the header says: ", in_quotes(word));
  return surface;
}

// The lowest value of a signed integer marks a missing point; NaN stays NaN.
template <class Number> double height(Number raw, double scale) {
  if (std::is_integral_v<Number> && std::is_signed_v<Number> && raw == std::numeric_limits<Number>::min()) return missing_height;
  return scale * static_cast<double>(raw);
}

template <class Number> void read_numbers(std::string_view data, double scale, Surface& surface) {
  const std::size_t size = data_size(surface.nx, surface.ny, sizeof(Number), data.size());
  append_numbers<Number>(data.substr(0, size), std::endian::little, surface.heights,
                         [scale](Number raw) { return height(raw, scale); });
}

Surface read_binary(std::string_view file) {
  const std::string_view header = piece(file, 0, binary_header, "the header of 81 bytes");
  Surface surface;
  surface.nx = field<std::uint16_t>(header, 42, "NumPoints");
  surface.ny = field<std::uint16_t>(header, 44, "NumProfiles");
  surface.hx = file_length("Xscale", field<double>(header, 46, "Xscale"));
  surface.hy = file_length("Yscale", field<double>(header, 54, "Yscale"));
  const double scale = file_length("Zscale", field<double>(header, 62, "Zscale"));
  const int compression = field<std::uint8_t>(header, 78, ""), type = field<std::uint8_t>(header, 79, ""),
            check = field<std::uint8_t>(header, 80, "");
  if (compression != 0) throw Error("compression ", compression, " cannot be read, only 0 (none)");
  if (check != 0) throw Error("checksum of type ", check, " cannot be read, only 0 (none)");

  using Read = void (*)(std::string_view, double, Surface&);
  constexpr Read readers[] = {read_numbers<std::uint8_t>, read_numbers<std::uint16_t>, read_numbers<std::uint32_t>,
                              read_numbers<float>,        read_numbers<std::int8_t>,   read_numbers<std::int16_t>,
                              read_numbers<std::int32_t>, read_numbers<double>};
  if (type >= static_cast<int>(std::size(readers))) throw Error("data type ", type, " cannot be read, known are 0 to 7");
  readers[type](file.substr(binary_header), scale, surface);
  return surface;
}

}  // namespace

Surface read_sdf(std::string_view file, const BareUnit& unit) {
  const bool binary = file.starts_with("bISO-") || file.starts_with("bBCR-");
  if (binary || file.starts_with("aISO-") || file.starts_with("aBCR-") || file.starts_with("aNPL-")) {
    Surface surface = binary ? read_binary(file) : read_ascii(file);
    file_unit(surface, "lengths", "m", unit);
    return surface;
  }
  throw Error("the file begins with ", in_quotes(file.substr(0, 8)),
              ", expected is aISO-1.0, aBCR-1.0, aNPL-V1.0, bISO-1.0 or bBCR-1.0");
}

}  // namespace rc::formats
