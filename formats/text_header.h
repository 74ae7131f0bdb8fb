// Reads sizes, lengths, units and names of columns from the lines before the numbers of a text export.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/column_names.h"
#include "formats/surface.h"

namespace rc::formats {

struct TextHeader {
  enum class Role;
  struct Key;
  struct Split;

  std::optional<std::int64_t> columns, rows;
  std::optional<std::pair<std::int64_t, std::int64_t>> size;  // "512 x 256", of which the first may be the rows
  std::optional<double> width, height;                        // of the whole field
  std::optional<double> scan;                                 // of a line of square points
  std::optional<double> pixel_x, pixel_y;                     // pitch
  std::string_view width_unit, height_unit, x_unit, y_unit, z_unit;
  std::string_view all_unit;         // of all lengths
  std::optional<double> metres;      // per unit of the heights
  std::optional<double> nanometres;  // the same, unless z_unit says it
  std::optional<double> factor;      // of the heights
  std::optional<double> no_data;     // the height that marks a missing point
  bool names_kind = false;           // "File Format = ASCII", as SPIP's and Nova's exports have it
  bool listing = false;              // it stands in a line without '#': so do others that are not understood
  std::vector<Label> heads;          // of the columns; empty if no line has one for each
  std::string unclear_unit;          // a line with a unit that is not understood

  // A comment without its '#': what is not understood is passed over. Whether it begins the header of a map.
  bool read_comment(std::string_view line);

  // A line before the first row. Whether it is understood.
  bool read_line(std::string_view line);

  // A line before the first row that is words: units of named lengths, names of columns, or a remark.
  void read_words(std::string_view line);

  // Whether any line was about a unit.
  bool names_unit() const;

  // Finds the heads of the columns in the last lines of words. separator: of the numbers.
  void settle_columns(std::int64_t count, char separator);

  // Whether anything shows that the rows are a matrix.
  bool of_matrix() const;

  // The places of x, y and z among the columns; empty if these are not named.
  std::vector<std::size_t> points() const;

  // Sets pitch and unit of a matrix, scales its heights. Throws if the header states another number of rows or columns.
  void apply(const BareUnit& unit, Surface& surface) const;

  // Sets the units of a surface of points. Returns metres per unit of x, y and z.
  std::vector<double> units_of_points(const BareUnit& unit, Surface& surface) const;

 private:
  void read_pair(const Key& key, const Split& pair, std::string_view key_unit);
  void read_counts(std::string_view line);
  void set_units(const std::vector<Label>& labels);
  double heights_unit(const BareUnit& unit, std::string_view own, Surface& surface) const;
  std::string_view unit_along_y(const BareUnit& unit, Surface& surface) const;

  Labels above_, last_, named_;  // the last two lines of words; the last one with nothing but known names
};

}  // namespace rc::formats
