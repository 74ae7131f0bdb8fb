// A matrix of numbers, one row a line, separated by semicolons (as in MIRCO's input), tabs, commas or white space; empty fields,
// "bad" and the like are missing. Lines that begin with '#' are comments. What comments and lines before the first row say of
// sizes, lengths and units is in text_header.cpp. Blank lines or another header divide a file into maps, of which the first is
// read.
#include <algorithm>
#include <string>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/text_table.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

// The rows of the first map.
std::int64_t rows_of_first(const TextTable& table) {
  const auto& blocks = table.blocks;
  if (table.header.rows == table.rows || std::ranges::all_of(blocks, [](std::int64_t rows) { return rows == 1; }))
    return table.rows;
  const bool equal = std::ranges::all_of(blocks, [&](std::int64_t rows) { return rows == blocks.front(); });
  if (equal || table.header.rows == blocks.front()) return blocks.front();
  throw Error("blank lines divide the ", table.rows, " rows into ", blocks.size(), " blocks, the first of ", blocks.front(),
              ": one map or several? Remove the blank lines, or give a file with one map");
}

Surface first_map(TextTable&& table, const BareUnit& unit) {
  Surface surface;
  surface.nx = table.columns;
  surface.ny = rows_of_first(table);
  surface.heights = std::move(table.values);
  surface.heights.resize(static_cast<std::size_t>(surface.nx * surface.ny));
  surface.note = table.note;
  if (surface.ny < table.rows) {
    surface.add_note(join("the first of ", table.blocks.size(), " maps, which blank lines divide, is read"));
  } else if (table.more_headers) {
    surface.add_note("the first of several maps in the file is read");
  }
  table.header.apply(unit, surface);
  return surface;
}

}  // namespace

Surface read_text(std::string_view file, const BareUnit& unit) { return first_map(read_table(file, false), unit); }

Surface read_text_or_points(std::string_view file, const BareUnit& unit) {
  TextTable table = read_table(file, false);
  if (table.comma_pairs && !table.header.of_matrix())
    throw Error(
        "each row is one number with a decimal comma, which is a profile, or two whole numbers: give the format text for a map "
        "of 2 x ",
        table.rows);
  const bool named = !table.header.points().empty();
  const bool three = table.columns == 3 && !table.header.of_matrix();
  const Columns kind = named ? Columns::points : three ? kind_of_columns(table.values) : Columns::heights;
  if (kind == Columns::heights) return first_map(std::move(table), unit);
  const std::string otherwise = join("give the format text for a map of ", table.columns, " x ", table.rows);
  Surface surface;
  try {
    surface = read_xyz(file, unit);
  } catch (const Error& error) {
    throw Error(named ? "columns" : "three columns that look like", " x, y, z: ", error.what(), "; or ", otherwise);
  }
  if (kind == Columns::unclear) throw Error("three columns: give the format xyz if they are x, y, z; or ", otherwise);
  surface.format = "xyz";
  if (!named) surface.add_note("three columns are taken as x, y, z; " + otherwise);
  return surface;
}

}  // namespace rc::formats
