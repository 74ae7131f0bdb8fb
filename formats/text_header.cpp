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

// Lines such as "Width: 10 um": what is to be done with the value.
enum class TextHeader::Role { channel, columns, rows, size, width, no_data, kind, other };

struct TextHeader::Key {
  std::string_view names;  // ASCII in lower case, between bars
  Role role = Role::other;
  // The member for a number and its unit, or for a text.
  std::optional<double> TextHeader::*number = nullptr, TextHeader::*same_number = nullptr;
  std::string_view TextHeader::*text = nullptr, TextHeader::*same_text = nullptr;

  bool counts() const { return role == Role::rows || role == Role::columns || role == Role::size; }
};

struct TextHeader::Split {
  std::string_view key, value;
};

namespace {

using Role = TextHeader::Role;
using Key = TextHeader::Key;
using Split = TextHeader::Split;

// Gwyddion translates its labels, and older versions write them in Latin-1.
constexpr Key header_keys[] = {
    {"|channel|kan\xc3\xa1l|kanal|canal|canale|\xd0\x9a\xd0\xb0\xd0\xbd\xd0\xb0\xd0\xbb|", Role::channel},
    {"|width|breite|\xc5\xa0\xc3\xad\xc5\x99ka|anchura|largeur|larghezza|largura|\xe5\xb9\x85|\xed\x8f\xad|"
     "\xd0\xa8\xd0\xb8\xd1\x80\xd0\xb8\xd0\xbd\xd0\xb0|x-length|",
     Role::width, &TextHeader::width, nullptr, &TextHeader::width_unit},
    {"|height|h\xc3\xb6he|h\xf6he|hoehe|v\xc3\xbd\xc5\xa1ka|altura|hauteur|altezza|\xe9\xab\x98\xe3\x81\x95|"
     "\xeb\x86\x92\xec\x9d\xb4|\xd0\x92\xd1\x8b\xd1\x81\xd0\xbe\xd1\x82\xd0\xb0|y-length|",
     Role::other, &TextHeader::height, nullptr, &TextHeader::height_unit},
    {"|value units|value unit|einheiten|werteinheit|werteinheiten|einheit der werte|einheiten der werte|"
     "jednotky hodnot|unit\xc3\xa9s|unit\xe9s|unit\xc3\xa0 valore|unidades de valor|"
     "\xe5\x80\xa4\xe3\x81\xae\xe5\x8d\x98\xe4\xbd\x8d|\xea\xb0\x92 \xeb\x8b\xa8\xec\x9c\x84|"
     "\xd0\x95\xd0\xb4\xd0\xb8\xd0\xbd\xd0\xb8\xd1\x86\xd1\x8b "
     "\xd0\xb8\xd0\xb7\xd0\xbc\xd0\xb5\xd1\x80\xd0\xb5\xd0\xbd\xd0\xb8\xd1\x8f|"
     "z-unit|unit data|",
     Role::other, nullptr, nullptr, &TextHeader::z_unit},
    {"|x-unit|", Role::other, nullptr, nullptr, &TextHeader::x_unit},
    {"|y-unit|unit y|", Role::other, nullptr, nullptr, &TextHeader::y_unit},
    {"|unit x|", Role::other, nullptr, nullptr, &TextHeader::x_unit, &TextHeader::y_unit},
    {"|x-pixels|nx|w|ncols|cols|columns|xres|spalten|", Role::columns},
    {"|y-pixels|ny|h|nrows|rows|lines|yres|zeilen|", Role::rows},
    {"|resolution|size|shape|pixels|points|", Role::size},
    {"|pixel size|cellsize|", Role::other, &TextHeader::pixel_x, &TextHeader::pixel_y, &TextHeader::x_unit, &TextHeader::y_unit},
    {"|scale x|", Role::other, &TextHeader::pixel_x},
    {"|scale y|", Role::other, &TextHeader::pixel_y},
    {"|height conversion factor (-> m)|", Role::other, &TextHeader::metres},
    {"|bit2nm|", Role::other, &TextHeader::nanometres},
    {"|scale data|", Role::other, &TextHeader::factor},
    {"|nodata_value|", Role::no_data},
    {"|file format|", Role::kind},
    {"|data unit|xllcorner|yllcorner|xllcenter|yllcenter|"},
};

const Key* key_named(std::string_view name) {
  const std::string barred = join('|', lower_case(trimmed(name)), '|');
  const auto found = std::ranges::find_if(header_keys, [&](const Key& key) { return key.names.find(barred) != key.names.npos; });
  return found == std::end(header_keys) ? nullptr : found;
}

// "10.00 um": the number, and its unit.
std::pair<double, std::string_view> header_length(std::string_view key, std::string_view text) {
  const auto gap = std::min(text.find_first_of(" \t"), text.size());
  const auto number = text.substr(0, gap);
  const auto value = field_number(number);
  if (!value) throw Error(key, ": ", in_quotes(number), " is not a number");
  if (!(*value > 0) || !std::isfinite(*value)) throw Error(key, " ", in_quotes(text), " is not a positive length");
  return {*value, trimmed(text.substr(gap))};
}

// Empty for words, as in "columns: x, y, z".
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
  std::string_view of_text = pair.value;
  if (key.number) {
    const auto [length, unit] = header_length(pair.key, pair.value);
    this->*key.number = length;
    if (key.same_number) this->*key.same_number = length;
    of_text = unit;
  }
  if (key.text) this->*key.text = of_text;
  if (key.same_text) this->*key.same_text = of_text;
  if (key.role == Role::no_data) no_data = field_number(pair.value);
  names_kind |= key.role == Role::kind;
}

void TextHeader::read_counts(std::string_view line) {
  // "number of rows = 4, columns = 5"
  for (auto at = line.find_first_of(":="); at != std::string_view::npos; at = line.find_first_of(":=", at + 1)) {
    const auto before = trimmed(line.substr(0, at)), value = trimmed(line.substr(at + 1));
    const auto word = before.find_last_of(" \t,;(");
    const Key* const key = key_named(word == std::string_view::npos ? before : before.substr(word + 1));
    if (!key) continue;
    if (key->role == Role::size && !size) size = two_counts(value);
    if (const auto count = leading_count(value)) {
      if (key->role == Role::rows) rows = count;
      if (key->role == Role::columns) columns = count;
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
    if (key && key->role == Role::rows) rows = count;
    if (key && key->role == Role::columns) columns = count;
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
  return key->role == Role::channel || key->role == Role::width || key->role == Role::kind;
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
  listing |= key->role == Role::kind;
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
    throw Error("the header says ", stated.first, " x ", stated.second, " points, but there are ", surface.ny, " rows of ",
                surface.nx, " values; the file is truncated or damaged");
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
