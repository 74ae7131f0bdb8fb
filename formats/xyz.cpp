// Three columns x, y, z, separated by white space, commas or semicolons, on a regular grid in any order. Nodes without a point
// and points without a height ("nan", "bad", "no data", "***") are missing. Lines before the first number, and those that begin
// with '#', are comments. Rows go upwards with y.
#include <algorithm>
#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/regular_grid.h"
#include "formats/text_rows.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

// Limits the grid: a diagonal line of n points would span n^2 nodes.
constexpr std::int64_t most_nodes_per_point = 10;

struct Points {
  std::vector<double> x, y, z;
};

bool begins_with_number(std::string_view line) { return line.find_first_of("0123456789+-.\"") == 0; }

double coordinate(std::string_view text, std::int64_t line, const char* name) {
  const auto value = field_number(text);
  if (value && std::isfinite(*value)) return *value;
  throw Error("line ", line, ": ", name, " ", in_quotes(trimmed(text)), " is not a finite number");
}

Points parse_points(std::string_view file) {
  check_text(file);
  Points points;
  std::int64_t number = 0;
  while (!file.empty()) {
    const auto line = take_line(file);
    ++number;
    if (line.empty() || line.starts_with('#') || line == "\x1a") continue;
    if (points.x.empty() && !begins_with_number(line)) continue;
    const auto parts = row_fields(line);
    const bool no_data = parts.size() == 4 && is_missing_mark(std::string(parts[2]) + " " + std::string(parts[3]));
    if (parts.size() != 3 && !no_data) {
      throw Error("line ", number, " has ", parts.size(),
                  " columns, three are needed: x, y and z; give the format text if this is a matrix");
    }
    points.x.push_back(coordinate(parts[0], number, "x"));
    points.y.push_back(coordinate(parts[1], number, "y"));
    points.z.push_back(no_data || is_missing_mark(parts[2]) ? missing_height : coordinate(parts[2], number, "z"));
  }
  return points;
}

}  // namespace

Surface read_xyz(std::string_view file, double unit) {
  const Points points = parse_points(file);
  const auto count = static_cast<std::int64_t>(points.x.size());
  if (count == 0) throw Error("the file has no line with three numbers");
  const std::int64_t most_nodes = most_nodes_per_point * count;
  const GridAxis x = find_grid_axis(points.x, most_nodes, "x"), y = find_grid_axis(points.y, most_nodes, "y");
  if (y.count > most_nodes / x.count) {
    throw Error("the ", count, " points span a grid of ", x.count, " x ", y.count, " nodes, of which less than one in ",
                most_nodes_per_point, " has a point; interpolate them on a grid first");
  }

  Surface surface;
  surface.names_unit = false;
  surface.nx = x.count;
  surface.ny = y.count;
  surface.hx = file_length("the pitch along x", unit * x.pitch);
  surface.hy = file_length("the pitch along y", unit * y.pitch);
  surface.heights.assign(static_cast<std::size_t>(x.count * y.count), missing_height);
  std::vector<bool> taken(surface.heights.size());
  for (std::size_t i = 0; i < points.z.size(); ++i) {
    const auto node = static_cast<std::size_t>(y.index[i] * x.count + x.index[i]);
    if (taken[node]) {
      throw Error("two points are at x = ", rc::in_digits(points.x[i], 6), ", y = ", rc::in_digits(points.y[i], 6), ", node ",
                  x.index[i], ", ", y.index[i], " of the grid; remove one");
    }
    taken[node] = true;
    surface.heights[node] = unit * points.z[i];
  }
  return surface;
}

}  // namespace rc::formats
