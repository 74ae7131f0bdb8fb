// Reads sizes, lengths and units from the lines before the numbers of a text export.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "formats/surface.h"

namespace rc::formats {

struct TextHeader {
  enum class Role;
  struct Key;
  struct Split;

  std::optional<std::int64_t> columns, rows;
  std::optional<std::pair<std::int64_t, std::int64_t>> size;  // "512 x 256", of which the first may be the rows
  std::optional<double> width, height;                        // of the whole field
  std::optional<double> pixel_x, pixel_y;                     // pitch
  std::string_view width_unit, height_unit, x_unit, y_unit, z_unit;
  std::optional<double> metres;      // per unit of the heights
  std::optional<double> nanometres;  // the same, unless z_unit says it
  std::optional<double> factor;      // of the heights
  std::optional<double> no_data;     // the height that marks a missing point
  bool names_kind = false;           // "File Format = ASCII", as SPIP's and Nova's exports have it
  bool listing = false;              // it stands in a line without '#': so do others that are not understood

  // A comment without its '#': what is not understood is passed over. Whether it begins the header of a map.
  bool read_comment(std::string_view line);

  // A line before the first row. Whether it belongs to the header.
  bool read_line(std::string_view line);

  // Whether anything shows that the rows are a matrix.
  bool of_matrix() const;

  // Sets pitch and unit, scales the heights. unit: metres per unit of lengths without one. Throws if the header states another
  // number of rows or columns.
  void apply(double unit, Surface& surface) const;

 private:
  void read_pair(const Key& key, const Split& pair);
  void read_counts(std::string_view line);
};

}  // namespace rc::formats
