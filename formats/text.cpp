// A matrix of numbers, one row a line, separated by semicolons (as in MIRCO's input), commas or white space; "bad" and the like
// are missing. Lines that begin with '#' are comments. What comments and lines before the first row say of sizes, lengths and
// units is in text_header.cpp. Blank lines or another header divide a file into maps, of which the first is read.
#include <algorithm>
#include <string>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/text_header.h"
#include "formats/text_rows.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

struct TextMatrix {
  TextHeader header;
  std::int64_t nx = 0, rows = 0;
  std::vector<double> values;
  std::vector<std::int64_t> blocks;  // rows between blank lines
  bool more_headers = false;         // another map follows
  bool comma_pairs = true;           // every row is like "1,5"
};

std::string not_a_number(std::string_view field, std::int64_t row) {
  field = trimmed(field);
  if (field.empty()) return "the field is empty; write nan where a point is missing";
  const bool word = (field[0] >= 'A' && field[0] <= 'Z') || (field[0] >= 'a' && field[0] <= 'z') || field[0] == '"';
  return in_quotes(field) + " is not a number" +
         (row == 1 && word ? "; if the line names columns, delete it or put '#' before it" : "");
}

std::int64_t append_row(std::string_view line, std::int64_t row, std::vector<double>& values) {
  std::int64_t column = 0;
  for (const auto field : row_fields(line)) {
    ++column;
    const auto value = is_missing_mark(field) ? missing_height : field_number(field);
    if (!value) {
      throw Error("row ", row, ", column ", column, ": ", not_a_number(field, row));
    }
    values.push_back(*value);
  }
  return column;
}

TextMatrix parse_matrix(std::string_view file) {
  check_text(file);
  TextMatrix matrix;
  bool after_blank = false, other_header = false;
  while (!file.empty()) {
    const auto line = take_line(file);
    if (line.empty() || line == "\x1a") {  // DOS ended files with the latter
      after_blank = true;
      continue;
    }
    if (line.starts_with('#')) {
      TextHeader next;
      const bool begins_map = (matrix.rows == 0 ? matrix.header : next).read_comment(trimmed(line.substr(1)));
      other_header |= begins_map && matrix.rows > 0;
      continue;
    }
    matrix.more_headers = other_header;
    if (other_header) break;
    if (matrix.rows == 0 && matrix.header.read_line(line)) continue;
    if (after_blank || matrix.blocks.empty()) matrix.blocks.push_back(0);
    const std::int64_t row = ++matrix.rows, columns = append_row(line, row, matrix.values);
    if (row == 1) matrix.nx = columns;
    matrix.comma_pairs &=
        columns == 2 && line.find(',') != std::string_view::npos && line.find_first_of(" .;\t") == std::string_view::npos;
    if (columns != matrix.nx || columns == 0) {
      throw Error("row ", row, after_blank && row > 1 ? ", after a blank line," : "", " has ", columns, " values, expected ",
                  std::max<std::int64_t>(matrix.nx, 1), " as in row 1",
                  after_blank && row > 1 ? "; give a file with one map" : "");
    }
    ++matrix.blocks.back();
    after_blank = false;
  }
  if (matrix.rows == 0) throw Error("the file has no numbers");
  return matrix;
}

// The rows of the first map.
std::int64_t rows_of_first(const TextMatrix& matrix) {
  const auto& blocks = matrix.blocks;
  if (matrix.header.rows == matrix.rows || std::ranges::all_of(blocks, [](std::int64_t rows) { return rows == 1; }))
    return matrix.rows;
  const bool alike = std::ranges::all_of(blocks, [&](std::int64_t rows) { return rows == blocks.front(); });
  if (alike || matrix.header.rows == blocks.front()) return blocks.front();
  throw Error("blank lines divide the ", matrix.rows, " rows into ", blocks.size(), " blocks, the first of ", blocks.front(),
              ": one map or several? Remove the blank lines, or give a file with one map");
}

Surface first_map(TextMatrix&& matrix, double unit) {
  Surface surface;
  surface.nx = matrix.nx;
  surface.ny = rows_of_first(matrix);
  surface.heights = std::move(matrix.values);
  surface.heights.resize(static_cast<std::size_t>(surface.nx * surface.ny));
  if (matrix.more_headers) surface.note = "the first of several maps in the file is read";
  if (surface.ny < matrix.rows)
    surface.note = "the first of " + std::to_string(matrix.blocks.size()) + " maps, which blank lines divide, is read";
  matrix.header.apply(unit, surface);
  return surface;
}

}  // namespace

Surface read_text(std::string_view file, double unit) { return first_map(parse_matrix(file), unit); }

Surface read_text_or_points(std::string_view file, double unit) {
  TextMatrix matrix = parse_matrix(file);
  if (matrix.comma_pairs && !matrix.header.of_matrix())
    throw Error(
        "each row is one number with a decimal comma, which is a profile, or two whole numbers: give the format text for a map "
        "of 2 x ",
        matrix.rows);
  const bool three = matrix.nx == 3 && !matrix.header.of_matrix();
  const Columns kind = three ? kind_of_columns(matrix.values) : Columns::heights;
  if (kind == Columns::heights) return first_map(std::move(matrix), unit);
  const std::string otherwise = "give the format text for a map of 3 x " + std::to_string(matrix.rows);
  Surface surface;
  try {
    surface = read_xyz(file, unit);
  } catch (const Error& error) {
    throw Error("three columns that look like x, y, z: ", error.what(), "; or ", otherwise);
  }
  if (kind == Columns::unclear) throw Error("three columns: give the format xyz if they are x, y, z; or ", otherwise);
  surface.format = "xyz";
  surface.note = "three columns are taken as x, y, z; " + otherwise;
  return surface;
}

}  // namespace rc::formats
