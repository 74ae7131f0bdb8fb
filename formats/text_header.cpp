#include "formats/text_header.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/text_rows.h"
#include "formats/units.h"
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
    {"|unit x|", Role::other, nullptr, nullptr, &TextHeader::x_unit},
    {"|unit|units|einheit|length unit|length units|unit of length|l\xc3\xa4ngeneinheit|l\xe4ngeneinheit|", Role::other, nullptr,
     nullptr, &TextHeader::all_unit},
    {"|scan size|", Role::width, &TextHeader::scan, nullptr, &TextHeader::width_unit},
    {"|x-pixels|nx|w|ncols|cols|columns|xres|spalten|samps/line|samples/line|", Role::columns},
    {"|y-pixels|ny|h|nrows|rows|lines|number of lines|yres|zeilen|", Role::rows},
    {"|resolution|size|shape|pixels|points|", Role::size},
    {"|pixel size|cellsize|pitch|pixel pitch|spacing|schrittweite|punktabstand|pixelgr\xc3\xb6\xc3\x9f"
     "e|pixelgr\xf6\xdf"
     "e|",
     Role::other, &TextHeader::pixel_x, &TextHeader::pixel_y, &TextHeader::x_unit, &TextHeader::y_unit},
    {"|scale x|pitch x|x pitch|x-pitch|spacing x|x spacing|", Role::other, &TextHeader::pixel_x, nullptr, &TextHeader::x_unit},
    {"|scale y|pitch y|y pitch|y-pitch|spacing y|y spacing|", Role::other, &TextHeader::pixel_y, nullptr, &TextHeader::y_unit},
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

// A unit with or without brackets.
std::string_view bare_name(std::string_view unit) {
  const auto inner = label_of(unit);
  return inner.name.empty() && !inner.unit.empty() ? inner.unit : trimmed(unit);
}

// "10.00 um", "10um", "10 [um]": the number, and its unit.
std::pair<double, std::string_view> header_length(std::string_view key, std::string_view text) {
  auto gap = std::min(text.find_first_of(" \t;"), text.size());
  auto value = field_number(text.substr(0, gap));
  for (auto end = std::min<std::size_t>(gap, 40); !value && end > 1; value = field_number(text.substr(0, end))) gap = --end;
  if (!value) throw Error(key, ": ", in_quotes(text), " is not a number");
  if (!(*value > 0) || !std::isfinite(*value)) throw Error(key, " ", in_quotes(text), " is not a positive length");
  text = trimmed(text.substr(gap));
  if (text.starts_with(';') || text.starts_with(',')) text.remove_prefix(1);
  return {*value, bare_name(text)};
}

bool same_unit(std::string_view a, std::string_view b) {
  const auto one = metres_per(a), other = metres_per(b);
  return one && other ? *one == *other : a == b;
}

void refuse_two_units(std::string_view what, std::string_view one, std::string_view other) {
  if (one.empty() || other.empty() || same_unit(one, other)) return;
  throw Error("the header names two units of ", what, ", ", in_quotes(one), " and ", in_quotes(other), "; correct it");
}

void set_unit(std::string_view what, std::string_view unit, std::string_view& to) {
  refuse_two_units(what, to, unit);
  if (!unit.empty()) to = unit;
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

bool begins_with_digit(std::string_view text) { return text.find_first_of("0123456789") == 0; }

// "ncols 512" of ESRI's grids, "Width;10 um" of tables.
std::optional<Split> at_first_gap(std::string_view line) {
  const bool table = line.find_first_of(";\t") != line.npos;
  const auto gap = line.find_first_of(table ? ";\t" : line.find(',') == line.npos ? " " : ",");
  if (gap == line.npos) return std::nullopt;
  return Split{trimmed(line.substr(0, gap)), trimmed(line.substr(gap + 1))};
}

// The key of such a pair, and the unit beside its name: "Width [um]".
std::pair<const Key*, std::string_view> key_of(std::string_view name) {
  if (const Key* const key = key_named(name)) return {key, ""};
  const Label label = label_of(name);
  const Key* const key = label.unit.empty() ? nullptr : key_named(label.name);
  return key && key->number ? std::pair{key, label.unit} : std::pair<const Key*, std::string_view>{nullptr, ""};
}

// "Width: 10 um; Height: 8 um": its statements, if each has a known key; else nothing.
std::vector<std::string_view> statements(std::string_view line) {
  std::vector<std::string_view> found;
  while (!line.empty()) {
    const auto end = std::min(line.find(';'), line.size());
    const auto part = trimmed(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
    if (part.empty()) continue;
    const auto pair = at_separator(part);
    if (!pair || !key_of(pair->key).first) return {};
    found.push_back(part);
  }
  return found;
}

}  // namespace

void TextHeader::read_pair(const Key& key, const Split& pair, std::string_view key_unit) {
  std::string_view of_text = bare_name(pair.value);
  if (key.number) {
    const auto [length, unit] = header_length(pair.key, pair.value);
    this->*key.number = length;
    if (key.same_number) this->*key.same_number = length;
    of_text = unit;
    set_unit(pair.key, key_unit, of_text);
  }
  for (const auto to : {key.text, key.same_text})
    if (to) set_unit(pair.key, of_text, this->*to);
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
  if (const auto parts = statements(line); parts.size() > 1) {
    bool own = false;
    for (const std::string_view part : parts) own |= read_comment(part);
    return own;
  }
  const auto pair = at_separator(line);
  const auto [key, unit] = pair ? key_of(pair->key) : std::pair<const Key*, std::string_view>{nullptr, ""};
  if (!key || key->counts()) {
    read_counts(line);
    if (!key) read_words(line);
    return false;
  }
  read_pair(*key, *pair, unit);
  return key->role == Role::channel || key->role == Role::width || key->role == Role::kind;
}

bool TextHeader::read_line(std::string_view line) {
  if (std::string_view("0123456789-+.;,").find(line.front()) != line.npos || is_missing_mark(row_fields(line).front()))
    return false;
  if (const auto parts = statements(line); parts.size() > 1)
    return std::ranges::all_of(parts, [this](std::string_view part) { return read_line(part); });
  auto pair = at_separator(line);
  const bool blank = !pair && line.find_first_of(";\t,") == line.npos;
  if (!pair) pair = at_first_gap(line);
  const auto [key, unit] = pair ? key_of(pair->key) : std::pair<const Key*, std::string_view>{nullptr, ""};
  const bool takes_number = key && (key->number || key->counts());
  // Without a separator a value must look like one: "Unit 7" is a title.
  const auto fits = [&pair, role = key ? key->role : Role::no_data] {
    return role == Role::no_data ? field_number(pair->value) : metres_per(bare_name(pair->value));
  };
  const bool has_value = takes_number ? begins_with_digit(pair->value) : key && (!blank || fits());
  if (!has_value) {
    if (listing) read_words(line);
    return listing;
  }
  listing |= key->role == Role::kind;
  if (key->counts()) {
    read_counts(std::string(pair->key) + "=" + std::string(pair->value));
  } else {
    read_pair(*key, *pair, unit);
  }
  return true;
}

void TextHeader::read_words(std::string_view line) {
  if (line.empty()) return;
  above_ = std::exchange(last_, labels_of(line));
  const bool named = last_.all_named();
  const std::string_view only = last_.each.size() == 1 ? last_.each.front().unit : "";
  const bool has_unit = std::ranges::any_of(last_.each, [](const Label& label) { return !label.unit.empty(); });
  const bool odd = !only.empty() && !metres_per(only) && !line.ends_with(']');  // "Height (forward)"
  const bool clear = last_.all_clear() && last_.all_or_no_units() && !odd;
  if (named && (has_unit ? clear : last_.each.size() > 1)) {
    set_units(last_.each);
    named_ = last_;
  }
  if (unclear_unit.empty() && (named && has_unit ? !clear : mentions_unit(line))) unclear_unit = line;
}

bool TextHeader::names_unit() const {
  const std::string_view units[] = {width_unit, height_unit, x_unit, y_unit, z_unit, all_unit, unclear_unit};
  return std::ranges::any_of(units, [](std::string_view unit) { return !unit.empty(); });
}

void TextHeader::set_units(const std::vector<Label>& labels) {
  for (const Label& label : labels) {
    if (label.axis == Axis::x) set_unit("x", label.unit, x_unit);
    if (label.axis == Axis::y) set_unit("y", label.unit, y_unit);
    if (label.axis == Axis::z) set_unit("the heights", label.unit, z_unit);
    if (label.axis == Axis::all) set_unit("all lengths", label.unit, all_unit);
  }
}

void TextHeader::settle_columns(std::int64_t count, char separator) {
  const auto of_all = [&](const Labels& labels) {
    return std::ssize(labels.each) == count && (separator == ' ' || labels.separator == separator || labels.all_named());
  };
  const bool units_below = of_all(last_) && std::ranges::all_of(last_.each, [](const Label& label) {
                             return label.name.empty() && !label.unit.empty();
                           });
  heads = (units_below && of_all(above_) ? above_ : of_all(last_) ? last_ : of_all(named_) ? named_ : Labels{}).each;
  if (units_below) {
    for (std::size_t i = 0; i < heads.size(); ++i) {
      refuse_two_units("a column", heads[i].unit, last_.each[i].unit);
      heads[i].unit = last_.each[i].unit;
    }
  }
  // "x; y; profile": the third column has the heights.
  const auto other = std::ranges::find(heads, Axis::none, &Label::axis);
  if (count == 3 && other != heads.end() && std::ranges::count(heads, Axis::x, &Label::axis) == 1 &&
      std::ranges::count(heads, Axis::y, &Label::axis) == 1)
    other->axis = Axis::z;
  set_units(heads);
  const bool has_unit = std::ranges::any_of(heads, [](const Label& label) { return !label.unit.empty(); });
  if (has_unit && Labels{heads}.all_or_no_units()) unclear_unit.clear();
}

std::vector<std::size_t> TextHeader::points() const {
  std::vector<std::size_t> places;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    if (std::ranges::count(heads, axis, &Label::axis) != 1) return {};
    places.push_back(static_cast<std::size_t>(std::ranges::find(heads, axis, &Label::axis) - heads.begin()));
  }
  return places;
}

bool TextHeader::of_matrix() const { return columns || rows || size || width || scan || height || pixel_x || pixel_y || metres; }

void TextHeader::apply(const BareUnit& unit, Surface& surface) const {
  const bool other = (columns && *columns != surface.nx) || (rows && *rows != surface.ny);
  const bool other_size = size && *size != std::pair{surface.nx, surface.ny} && *size != std::pair{surface.ny, surface.nx};
  if (other || other_size) {
    const auto stated = size.value_or(std::pair{columns.value_or(surface.nx), rows.value_or(surface.ny)});
    throw Error("the header says ", stated.first, " x ", stated.second, " points, but there are ", surface.ny, " rows of ",
                surface.nx, " values; the file is truncated or damaged");
  }
  const auto lateral = [&](double length, std::string_view own, std::string_view axis_unit, std::string_view axis,
                           double points) {
    refuse_two_units(axis, own, axis_unit);
    // SPIP leaves out the unit of lateral lengths, which is nm.
    const auto named = !own.empty() ? own : !axis_unit.empty() ? axis_unit : names_kind && !pixel_x ? "nm" : all_unit;
    refuse_two_units(axis, named, all_unit);
    return file_length(join("the pitch along ", axis), length * file_unit(surface, "pitch", named, unit) / points);
  };
  for (const std::string_view name : {x_unit, y_unit})
    if (!name.empty() && !metres_per(name)) throw Error("the unit of x or y, ", in_quotes(name), ", is not a length");
  const auto nx = static_cast<double>(surface.nx), ny = static_cast<double>(surface.ny);
  const std::string_view along_y = pixel_y || height ? unit_along_y(unit, surface) : y_unit;
  if (pixel_x) surface.hx = lateral(*pixel_x, {}, x_unit, "x", 1);
  if (pixel_y) surface.hy = lateral(*pixel_y, {}, along_y, "y", 1);
  if (width) surface.hx = lateral(*width, width_unit, x_unit, "x", nx);
  if (scan && !surface.hx) {
    surface.hx = lateral(*scan, width_unit, x_unit, "x", nx);
    if (!pixel_y && !height) {
      surface.hy = surface.hx;
      surface.add_note("the scan size is that of a line; points have the same pitch along y");
    }
  }
  if (height) surface.hy = lateral(*height, height_unit, height_unit.empty() ? along_y : y_unit, "y", ny);

  std::string_view common;
  for (const Label& label : heads) set_unit("the columns of heights", label.unit, common);
  refuse_two_units("the heights", common, z_unit);
  const double vertical = heights_unit(unit, z_unit.empty() ? common : z_unit, surface) * factor.value_or(1);
  for (double& z : surface.heights) z = no_data && z == *no_data ? missing_height : z * vertical;
  surface.unclear_unit = unclear_unit;
}

// "Unit X" of Nova is that of y as well.
std::string_view TextHeader::unit_along_y(const BareUnit& unit, Surface& surface) const {
  if (!y_unit.empty() || !height_unit.empty() || x_unit.empty() || (unit.given && !names_kind)) return y_unit;
  if (!names_kind) surface.add_note(join("y has no unit, that of x is taken, ", x_unit));
  return x_unit;
}

double TextHeader::heights_unit(const BareUnit& unit, std::string_view own, Surface& surface) const {
  refuse_two_units("the heights", own, all_unit);
  if (own.empty()) own = all_unit;
  if (metres) return *metres * file_unit(surface, "heights", "m", unit);
  if (nanometres && own.empty()) return *nanometres * file_unit(surface, "heights", "nm", unit);
  return file_unit(surface, "heights", own, unit);
}

std::vector<double> TextHeader::units_of_points(const BareUnit& unit, Surface& surface) const {
  std::string_view own[] = {x_unit, y_unit, z_unit};
  if (points().empty() && heads.size() == 3) {
    for (std::size_t i = 0; i < 3; ++i) set_unit("a column", heads[i].unit, own[i]);
  }
  std::vector<double> found;
  for (const std::string_view name : {own[0], own[1]}) {
    refuse_two_units("a column", name, all_unit);
    found.push_back(file_unit(surface, "pitch", name.empty() ? all_unit : name, unit));
  }
  found.push_back(heights_unit(unit, own[2], surface) * factor.value_or(1));
  surface.unclear_unit = unclear_unit;
  return found;
}

}  // namespace rc::formats
