// A matrix of numbers, one row a line, separated by semicolons (as in MIRCO's input), commas or white space; "bad" and the like
// are missing. Lines that begin with '#' are comments, of which those of a Gwyddion export are understood: "# Width: 10.00 um",
// "# Height: 10.00 um" (of the whole field) and "# Value units: m". Of the header of phase-shifting interferometers "pixel
// size=1e-6 m" and "height conversion factor (-> m)=1e-8" are.
#include <string>

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/text_rows.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

struct Comments {
  std::optional<double> width, height;         // metres
  std::optional<double> pixel, height_factor;  // metres
  std::string_view value_units;
};

// "10.00 um" in metres.
double length(std::string_view key, std::string_view text, double unit) {
  const auto gap = text.find_first_of(" \t");
  const double value = finite_number(key, text.substr(0, gap));
  const auto name = gap == std::string_view::npos ? std::string_view{} : trimmed(text.substr(gap));
  const double metres = value * file_unit(key, name, unit);
  if (!(metres > 0)) throw Error(std::string(key) + " " + in_quotes(text) + " is not a positive length");
  return metres;
}

void read_comment(std::string_view line, double unit, Comments& comments) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos) return;
  const auto key = trimmed(line.substr(0, colon)), value = trimmed(line.substr(colon + 1));
  if (key == "Width") comments.width = length(key, value, unit);
  if (key == "Height") comments.height = length(key, value, unit);
  if (key == "Value units") comments.value_units = value;
}

// Reads a line "key=value" before the first row. The size and the unit of the raw data follow from the rows and the factor.
bool read_header_line(std::string_view line, double unit, Comments& comments) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return false;
  const auto key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
  if (key == "pixel size") comments.pixel = length(key, value, unit);
  if (key == "height conversion factor (-> m)") comments.height_factor = length(key, value, 1);
  return key == "h" || key == "pixel size" || key == "data unit" || key == "height conversion factor (-> m)";
}

std::string not_a_number(std::string_view field, std::int64_t row) {
  field = trimmed(field);
  if (field.empty()) return "the field is empty; write nan where a point is missing";
  const bool word = (field[0] >= 'A' && field[0] <= 'Z') || (field[0] >= 'a' && field[0] <= 'z') || field[0] == '"';
  const bool header = row == 1 && word;
  return in_quotes(field) + " is not a number" +
         (header ? "; if the line names columns, delete it or put '#' before it" : " (the decimal mark is a point)");
}

std::size_t append_row(std::string_view line, std::int64_t row, std::vector<double>& heights) {
  std::size_t column = 0;
  for (const auto field : row_fields(line)) {
    ++column;
    const auto value = is_missing_mark(field) ? missing_height : to_number(field);
    if (!value) {
      throw Error("row " + std::to_string(row) + ", column " + std::to_string(column) + ": " + not_a_number(field, row));
    }
    heights.push_back(*value);
  }
  return column;
}

}  // namespace

Surface read_text(std::string_view file, double unit) {
  if (file.starts_with("\xef\xbb\xbf")) file.remove_prefix(3);  // byte order mark

  Surface surface;
  Comments comments;
  while (!file.empty()) {
    const auto line = take_line(file);
    if (line.empty()) continue;
    if (line.starts_with('#')) {
      read_comment(line.substr(1), unit, comments);
      continue;
    }
    if (surface.ny == 0 && read_header_line(line, unit, comments)) continue;
    ++surface.ny;
    const auto columns = static_cast<std::int64_t>(append_row(line, surface.ny, surface.heights));
    if (surface.ny == 1) surface.nx = columns;
    if (columns != surface.nx || columns == 0) {
      throw Error("row " + std::to_string(surface.ny) + " has " + std::to_string(columns) + " values, expected " +
                  std::to_string(std::max<std::int64_t>(surface.nx, 1)) + " as in row 1");
    }
  }
  if (surface.ny == 0) throw Error("the file has no numbers");

  const double vertical = comments.height_factor ? *comments.height_factor : file_unit("Value units", comments.value_units, unit);
  surface.names_unit = comments.height_factor || !comments.value_units.empty();
  for (double& z : surface.heights) z *= vertical;
  surface.hx = surface.hy = comments.pixel;
  if (comments.width) surface.hx = *comments.width / static_cast<double>(surface.nx);
  if (comments.height) surface.hy = *comments.height / static_cast<double>(surface.ny);
  return surface;
}

}  // namespace rc::formats
