#include "formats/text_header.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/text_rows.h"
#include "formats/wording.h"

namespace rc::formats {

// Lines such as "Width: 10 um".
enum class TextHeader::Meaning {
  channel,
  columns,
  rows,
  size,
  width,
  height,
  x_unit,
  y_unit,
  lateral_unit,
  z_unit,
  pixel,
  pixel_x,
  pixel_y,
  metres,
  nanometres,
  factor,
  no_data,
  kind,
  nothing
};

struct TextHeader::Key {
  std::string_view name;  // ASCII in lower case
  Meaning meaning;

  bool counts() const { return meaning == Meaning::rows || meaning == Meaning::columns || meaning == Meaning::size; }
};

struct TextHeader::Split {
  std::string_view key, value;
};

namespace {

using Meaning = TextHeader::Meaning;
using Key = TextHeader::Key;
using Split = TextHeader::Split;

// Gwyddion translates its labels, and older versions write them in Latin-1.
constexpr Key header_keys[] = {
    {"channel", Meaning::channel},
    {"kan\xc3\xa1l", Meaning::channel},
    {"kanal", Meaning::channel},
    {"canal", Meaning::channel},
    {"canale", Meaning::channel},
    {"\xd0\x9a\xd0\xb0\xd0\xbd\xd0\xb0\xd0\xbb", Meaning::channel},
    {"width", Meaning::width},
    {"breite", Meaning::width},
    {"\xc5\xa0\xc3\xad\xc5\x99ka", Meaning::width},
    {"anchura", Meaning::width},
    {"largeur", Meaning::width},
    {"larghezza", Meaning::width},
    {"largura", Meaning::width},
    {"\xe5\xb9\x85", Meaning::width},
    {"\xed\x8f\xad", Meaning::width},
    {"\xd0\xa8\xd0\xb8\xd1\x80\xd0\xb8\xd0\xbd\xd0\xb0", Meaning::width},
    {"x-length", Meaning::width},
    {"height", Meaning::height},
    {"h\xc3\xb6he", Meaning::height},
    {"h\xf6he", Meaning::height},
    {"hoehe", Meaning::height},
    {"v\xc3\xbd\xc5\xa1ka", Meaning::height},
    {"altura", Meaning::height},
    {"hauteur", Meaning::height},
    {"altezza", Meaning::height},
    {"\xe9\xab\x98\xe3\x81\x95", Meaning::height},
    {"\xeb\x86\x92\xec\x9d\xb4", Meaning::height},
    {"\xd0\x92\xd1\x8b\xd1\x81\xd0\xbe\xd1\x82\xd0\xb0", Meaning::height},
    {"y-length", Meaning::height},
    {"value units", Meaning::z_unit},
    {"value unit", Meaning::z_unit},
    {"einheiten", Meaning::z_unit},
    {"werteinheit", Meaning::z_unit},
    {"werteinheiten", Meaning::z_unit},
    {"einheit der werte", Meaning::z_unit},
    {"einheiten der werte", Meaning::z_unit},
    {"jednotky hodnot", Meaning::z_unit},
    {"unit\xc3\xa9s", Meaning::z_unit},
    {"unit\xe9s", Meaning::z_unit},
    {"unit\xc3\xa0 valore", Meaning::z_unit},
    {"unidades de valor", Meaning::z_unit},
    {"\xe5\x80\xa4\xe3\x81\xae\xe5\x8d\x98\xe4\xbd\x8d", Meaning::z_unit},
    {"\xea\xb0\x92 \xeb\x8b\xa8\xec\x9c\x84", Meaning::z_unit},
    {"\xd0\x95\xd0\xb4\xd0\xb8\xd0\xbd\xd0\xb8\xd1\x86\xd1\x8b "
     "\xd0\xb8\xd0\xb7\xd0\xbc\xd0\xb5\xd1\x80\xd0\xb5\xd0\xbd\xd0\xb8\xd1\x8f",
     Meaning::z_unit},
    {"z-unit", Meaning::z_unit},
    {"unit data", Meaning::z_unit},
    {"x-unit", Meaning::x_unit},
    {"y-unit", Meaning::y_unit},
    {"unit x", Meaning::lateral_unit},
    {"unit y", Meaning::y_unit},
    {"x-pixels", Meaning::columns},
    {"nx", Meaning::columns},
    {"w", Meaning::columns},
    {"ncols", Meaning::columns},
    {"cols", Meaning::columns},
    {"columns", Meaning::columns},
    {"xres", Meaning::columns},
    {"spalten", Meaning::columns},
    {"y-pixels", Meaning::rows},
    {"ny", Meaning::rows},
    {"h", Meaning::rows},
    {"nrows", Meaning::rows},
    {"rows", Meaning::rows},
    {"lines", Meaning::rows},
    {"yres", Meaning::rows},
    {"zeilen", Meaning::rows},
    {"resolution", Meaning::size},
    {"size", Meaning::size},
    {"shape", Meaning::size},
    {"pixels", Meaning::size},
    {"points", Meaning::size},
    {"pixel size", Meaning::pixel},
    {"cellsize", Meaning::pixel},
    {"scale x", Meaning::pixel_x},
    {"scale y", Meaning::pixel_y},
    {"height conversion factor (-> m)", Meaning::metres},
    {"bit2nm", Meaning::nanometres},
    {"scale data", Meaning::factor},
    {"nodata_value", Meaning::no_data},
    {"file format", Meaning::kind},
    {"data unit", Meaning::nothing},
    {"xllcorner", Meaning::nothing},
    {"yllcorner", Meaning::nothing},
    {"xllcenter", Meaning::nothing},
    {"yllcenter", Meaning::nothing},
};

std::string in_lower_case(std::string_view text) {
  std::string lower{text};
  std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return lower;
}

const Key* key_named(std::string_view name) {
  const std::string lower = in_lower_case(trimmed(name));
  const auto found = std::ranges::find(header_keys, lower, &Key::name);
  return found == std::end(header_keys) ? nullptr : found;
}

// "10.00 um": the number, and its unit.
std::pair<double, std::string_view> header_length(std::string_view key, std::string_view text) {
  const auto gap = std::min(text.find_first_of(" \t"), text.size());
  const auto number = text.substr(0, gap);
  const auto value = field_number(number);
  if (!value) throw Error(std::string(key) + ": " + in_quotes(number) + " is not a number");
  if (!(*value > 0) || !std::isfinite(*value))
    throw Error(std::string(key) + " " + in_quotes(text) + " is not a positive length");
  return {*value, trimmed(text.substr(gap))};
}

// Nothing for words, as in "columns: x, y, z".
std::optional<std::int64_t> header_count(std::string_view text) {
  const auto value = to_integer(text);
  return value && *value > 0 ? value : std::nullopt;
}

// The whole number that the text begins with, if nothing but points ("px") or another statement follows it.
std::optional<std::int64_t> leading_count(std::string_view text) {
  const auto end = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto rest = trimmed(text.substr(end));
  const bool points = rest.starts_with("px") || rest.starts_with("pixel") || rest.starts_with("point");
  if (!rest.empty() && !points && rest.find_first_of(",;)") != 0 && rest.find_first_of(":=") == std::string_view::npos)
    return std::nullopt;
  return header_count(text.substr(0, end));
}

// "512 x 256 pixels", "(512, 256)"
std::optional<std::pair<std::int64_t, std::int64_t>> two_counts(std::string_view text) {
  if (text.starts_with('(')) text.remove_prefix(1);
  const auto between = text.find_first_of("xX*,");
  if (between == std::string_view::npos) return std::nullopt;
  const auto first = header_count(trimmed(text.substr(0, between))), second = leading_count(trimmed(text.substr(between + 1)));
  return first && second ? std::optional(std::pair{*first, *second}) : std::nullopt;
}

// At the first '=' or colon, also the full-width one of Japanese texts.
std::optional<Split> at_separator(std::string_view line) {
  constexpr std::string_view wide = "\xef\xbc\x9a";
  const auto narrow_at = line.find_first_of(":="), wide_at = line.find(wide), at = std::min(narrow_at, wide_at);
  if (at == std::string_view::npos) return std::nullopt;
  return Split{trimmed(line.substr(0, at)), trimmed(line.substr(at + (at == wide_at ? wide.size() : 1)))};
}

}  // namespace

void TextHeader::read_pair(const Key& key, const Split& pair) {
  const auto [name, value] = pair;
  switch (key.meaning) {
    case Meaning::width: {
      const auto [length, unit] = header_length(name, value);
      width = length, width_unit = unit;
      break;
    }
    case Meaning::height: {
      const auto [length, unit] = header_length(name, value);
      height = length, height_unit = unit;
      break;
    }
    case Meaning::pixel: {
      const auto [length, unit] = header_length(name, value);
      pixel_x = pixel_y = length, x_unit = y_unit = unit;
      break;
    }
    case Meaning::pixel_x:
      pixel_x = header_length(name, value).first;
      break;
    case Meaning::pixel_y:
      pixel_y = header_length(name, value).first;
      break;
    case Meaning::x_unit:
      x_unit = value;
      break;
    case Meaning::y_unit:
      y_unit = value;
      break;
    case Meaning::lateral_unit:
      x_unit = y_unit = value;
      break;
    case Meaning::z_unit:
      z_unit = value;
      break;
    case Meaning::metres:
      metres = header_length(name, value).first;
      break;
    case Meaning::nanometres:
      nanometres = header_length(name, value).first;
      break;
    case Meaning::factor:
      factor = header_length(name, value).first;
      break;
    case Meaning::no_data:
      no_data = field_number(value);
      break;
    case Meaning::kind:
      names_kind = true;
      break;
    case Meaning::columns:
    case Meaning::rows:
    case Meaning::size:
    case Meaning::channel:
    case Meaning::nothing:
      break;
  }
}

void TextHeader::read_counts(std::string_view line) {
  // "number of rows = 4, columns = 5"
  for (auto at = line.find_first_of(":="); at != std::string_view::npos; at = line.find_first_of(":=", at + 1)) {
    const auto before = trimmed(line.substr(0, at)), value = trimmed(line.substr(at + 1));
    const auto word = before.find_last_of(" \t,;(");
    const Key* const key = key_named(word == std::string_view::npos ? before : before.substr(word + 1));
    if (!key) continue;
    if (key->meaning == Meaning::size && !size) size = two_counts(value);
    if (const auto count = leading_count(value)) {
      if (key->meaning == Meaning::rows) rows = count;
      if (key->meaning == Meaning::columns) columns = count;
    }
  }
  // "4 rows, 5 columns"
  for (std::string_view rest = line; !rest.empty();) {
    const auto end = std::min(rest.find_first_of(",;\t"), rest.size());
    const auto part = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const auto gap = std::min(part.find(' '), part.size());
    const auto count = header_count(part.substr(0, gap));
    const Key* const key = count ? key_named(part.substr(gap)) : nullptr;
    if (key && key->meaning == Meaning::rows) rows = count;
    if (key && key->meaning == Meaning::columns) columns = count;
  }
}

bool TextHeader::read_comment(std::string_view line) {
  const auto pair = at_separator(line);
  const Key* const key = pair ? key_named(pair->key) : nullptr;
  if (!key || key->counts()) {
    read_counts(line);
    return false;
  }
  read_pair(*key, *pair);
  return key->meaning == Meaning::channel || key->meaning == Meaning::width || key->meaning == Meaning::kind;
}

bool TextHeader::read_line(std::string_view line) {
  const char first = line.front();
  const auto fields = row_fields(line);
  if ((first >= '0' && first <= '9') || first == '-' || first == '+' || first == '.' || is_missing_mark(fields.front()))
    return false;
  auto pair = at_separator(line);
  if (!pair) {
    // "ncols 512" of ESRI's grids
    const auto gap = line.find_first_of(" \t");
    if (gap == std::string_view::npos || !field_number(trimmed(line.substr(gap)))) return listing;
    pair = Split{line.substr(0, gap), trimmed(line.substr(gap))};
  }
  const Key* const key = key_named(pair->key);
  if (!key) return listing;
  listing |= key->meaning == Meaning::kind;
  if (key->counts()) {
    read_counts(std::string(pair->key) + "=" + std::string(pair->value));
  } else {
    read_pair(*key, *pair);
  }
  return true;
}

bool TextHeader::of_matrix() const { return columns || rows || size || width || height || pixel_x || pixel_y || metres; }

void TextHeader::apply(double unit, Surface& surface) const {
  const bool other = (columns && *columns != surface.nx) || (rows && *rows != surface.ny);
  const bool other_size = size && *size != std::pair{surface.nx, surface.ny} && *size != std::pair{surface.ny, surface.nx};
  if (other || other_size) {
    const auto stated = size.value_or(std::pair{columns.value_or(surface.nx), rows.value_or(surface.ny)});
    throw Error(
        format("the header says %lld x %lld points, but there are %lld rows of %lld values; the file is truncated or damaged",
               static_cast<long long>(stated.first), static_cast<long long>(stated.second), static_cast<long long>(surface.ny),
               static_cast<long long>(surface.nx)));
  }
  // SPIP leaves out the unit of lateral lengths, which is nm.
  const double lateral = names_kind && !pixel_x ? 1e-9 : unit;
  const auto lateral_unit = [&](std::string_view own, std::string_view axis) {
    return file_unit("the unit of the lengths", own.empty() ? axis : own, lateral);
  };
  const auto nx = static_cast<double>(surface.nx), ny = static_cast<double>(surface.ny);
  if (pixel_x) surface.hx = file_length("the pitch along x", *pixel_x * lateral_unit({}, x_unit));
  if (pixel_y) surface.hy = file_length("the pitch along y", *pixel_y * lateral_unit({}, y_unit.empty() ? x_unit : y_unit));
  if (width) surface.hx = file_length("the pitch along x", *width * lateral_unit(width_unit, x_unit) / nx);
  if (height)
    surface.hy = file_length("the pitch along y", *height * lateral_unit(height_unit, y_unit.empty() ? x_unit : y_unit) / ny);

  double vertical = metres ? *metres : nanometres && z_unit.empty() ? 1e-9 * *nanometres : file_unit("Value units", z_unit, unit);
  vertical *= factor.value_or(1);
  surface.names_unit = metres || nanometres || !z_unit.empty();
  for (double& z : surface.heights) z = no_data && z == *no_data ? missing_height : z * vertical;
}

}  // namespace rc::formats
