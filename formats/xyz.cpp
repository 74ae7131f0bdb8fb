// Three columns x, y, z, separated by white space, commas or semicolons, on a regular grid in any order; if a line names x, y and
// z, in its order and among others. Nodes without a point and points without a height ("nan", "bad", "no data", "***", nothing)
// are missing. Lines before the first number, and those that begin with '#', are comments, of which text_header.cpp reads units.
// Rows go upwards with y.
#include <algorithm>
#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/regular_grid.h"
#include "formats/text_table.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

// Limits the grid: a diagonal line of n points would span n^2 nodes.
constexpr std::int64_t most_nodes_per_point = 10;

struct Points {
  std::vector<double> x, y, z;
};

Points points_of(const TextTable& table, const std::vector<std::size_t>& places) {
  Points points;
  const auto columns = static_cast<std::size_t>(table.columns);
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const double* const row = &table.values[i * columns];
    for (const std::size_t k : {0, 1}) {
      if (!std::isfinite(row[places[k]]))
        throw Error("line ", table.lines[i], ": ", k == 0 ? "x" : "y", " is missing or not finite");
    }
    points.x.push_back(row[places[0]]);
    points.y.push_back(row[places[1]]);
    points.z.push_back(row[places[2]]);
  }
  return points;
}

}  // namespace

Surface read_xyz(std::string_view file, const BareUnit& unit) {
  const TextTable table = read_table(file, true);
  auto places = table.header.points();
  if (places.empty() && table.columns != 3)
    throw Error("line ", table.lines.front(), " has ", table.columns,
                " columns, three are needed: x, y and z; give the format text if this is a matrix");
  if (places.empty()) places = {0, 1, 2};
  const Points points = points_of(table, places);
  const auto count = static_cast<std::int64_t>(points.x.size());
  const std::int64_t most_nodes = most_nodes_per_point * count;
  const GridAxis x = find_grid_axis(points.x, most_nodes, "x"), y = find_grid_axis(points.y, most_nodes, "y");
  if (y.count > most_nodes / x.count) {
    throw Error("the ", count, " points span a grid of ", x.count, " x ", y.count, " nodes, of which less than one in ",
                most_nodes_per_point, " has a point; interpolate them on a grid first");
  }

  Surface surface;
  surface.note = table.note;
  if (table.columns > 3) surface.add_note("the columns beside x, y and z are not read");
  const std::vector<double> metres = table.header.units_of_points(unit, surface);
  surface.nx = x.count;
  surface.ny = y.count;
  surface.hx = file_length("the pitch along x", metres[0] * x.pitch);
  surface.hy = file_length("the pitch along y", metres[1] * y.pitch);
  surface.heights.assign(static_cast<std::size_t>(x.count * y.count), missing_height);
  std::vector<bool> taken(surface.heights.size());
  for (std::size_t i = 0; i < points.z.size(); ++i) {
    const auto node = static_cast<std::size_t>(y.index[i] * x.count + x.index[i]);
    if (taken[node]) {
      throw Error("two points are at x = ", rc::in_digits(points.x[i], 6), ", y = ", rc::in_digits(points.y[i], 6), ", node ",
                  x.index[i], ", ", y.index[i], " of the grid; remove one");
    }
    taken[node] = true;
    const bool missing = table.header.no_data && points.z[i] == *table.header.no_data;
    surface.heights[node] = missing ? missing_height : metres[2] * points.z[i];
  }
  return surface;
}

}  // namespace rc::formats
