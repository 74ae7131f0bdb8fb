// A map of contact.engineering in NetCDF: heights(x, y), with y fastest, and variables x and y whose attribute length is the size
// of the whole map and unit its unit.
#include <cmath>
#include <string>

#include "formats/error.h"
#include "formats/netcdf_file.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

using Variable = NetcdfFile::Variable;

std::string_view unit_of(const Variable* variable) {
  for (const auto name : {"unit", "length_unit", "units"}) {
    if (const auto text = netcdf_text(variable, name); !text.empty()) return text;
  }
  return {};
}

// Whether x is the first index.
bool x_is_slow(const Variable& heights) {
  if (heights.dimensions.size() != 2) {
    throw Error("\"heights\" has ", heights.dimensions.size(), " dimensions, 2 are needed",
                heights.dimensions.size() == 1 ? "; it is a profile" : "");
  }
  if (heights.dimensions[0] == "x" && heights.dimensions[1] == "y") return true;
  if (heights.dimensions[0] == "y" && heights.dimensions[1] == "x") return false;
  throw Error("\"heights\" has the dimensions ", in_quotes(heights.dimensions[0]), " and ", in_quotes(heights.dimensions[1]),
              ", x and y are needed");
}

// Coordinates may be rounded, but not be spaced unevenly.
void check_even(const std::vector<double>& places, std::string_view axis) {
  constexpr double most_off = 1e-2;  // of the pitch
  const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!(std::abs(places[i] - places.front() - step * static_cast<double>(i)) <= most_off * std::abs(step)))
      throw Error("the coordinates along ", axis, " are not evenly spaced; interpolate the heights on a regular grid");
  }
}

// From the size of the whole map, or from the first and the last coordinate.
std::optional<double> pitch(const NetcdfFile& file, std::string_view axis, std::int64_t points, Surface& surface,
                            std::string_view own_unit, const BareUnit& unit) {
  const Variable* const variable = file.find(axis);
  if (!variable) return std::nullopt;
  const std::string name = join("the pitch along ", axis);
  const auto in_metres = [&](double length) { return file_length(name, length * file_unit(surface, "pitch", own_unit, unit)); };
  if (const auto length = netcdf_number(variable, "length")) return in_metres(*length / static_cast<double>(points));
  const auto coordinates = netcdf_numbers(variable->type, variable->values, name);
  if (points < 2 || std::ssize(coordinates) != points) return std::nullopt;
  check_even(coordinates, axis);
  return in_metres(std::abs(coordinates.back() - coordinates.front()) / static_cast<double>(points - 1));
}

}  // namespace

Surface read_netcdf(std::string_view file, const BareUnit& unit) {
  const NetcdfFile netcdf{file};
  const Variable* const heights = netcdf.find("heights");
  if (!heights) throw Error("the file has no variable \"heights\"");
  const bool transposed = x_is_slow(*heights);

  Surface surface;
  surface.nx = heights->shape[transposed ? 0 : 1];
  surface.ny = heights->shape[transposed ? 1 : 0];
  if (surface.nx < 1 || surface.ny < 1)
    throw Error("\"heights\" has an unlimited dimension; convert the file with \"nccopy -u\"");
  // The unit of x is that of the other lengths, unless they have their own or the caller gives one.
  const auto along_x_unit = unit_of(netcdf.find("x")), along_y_unit = unit_of(netcdf.find("y")), own_unit = unit_of(heights);
  const auto or_of_x = [&](std::string_view own, std::string_view what) {
    if (!own.empty() || along_x_unit.empty() || unit.given) return own;
    surface.add_note(join("the ", what, " have no unit, that of x is taken, ", along_x_unit));
    return along_x_unit;
  };
  surface.hx = pitch(netcdf, "x", surface.nx, surface, along_x_unit, unit);
  surface.hy = pitch(netcdf, "y", surface.ny, surface,
                     netcdf.find("y") ? or_of_x(along_y_unit, "coordinates along y") : along_y_unit, unit);
  const double vertical = file_unit(surface, "heights", or_of_x(own_unit, "heights"), unit);
  const double scale = netcdf_number(heights, "scale_factor").value_or(1) * vertical;
  const double offset = netcdf_number(heights, "add_offset").value_or(0) * vertical;
  const double fill = netcdf_number(heights, "_FillValue").value_or(netcdf_default_fill(heights->type));
  const double other_fill = netcdf_number(heights, "missing_value").value_or(fill);

  const auto raw = netcdf_numbers(heights->type, heights->values, "\"heights\"");
  const std::int64_t column = transposed ? surface.ny : 1, row = transposed ? 1 : surface.nx;
  surface.heights.reserve(raw.size());
  for (std::int64_t iy = 0; iy < surface.ny; ++iy) {
    for (std::int64_t ix = 0; ix < surface.nx; ++ix) {
      const double value = raw[static_cast<std::size_t>(iy * row + ix * column)];
      surface.heights.push_back(value == fill || value == other_fill ? missing_height : scale * value + offset);
    }
  }
  const auto along_x = netcdf_number(netcdf.find("x"), "periodic"), along_y = netcdf_number(netcdf.find("y"), "periodic");
  if (along_x || along_y) surface.periodic = along_x.value_or(0) != 0 && along_y.value_or(0) != 0;
  return surface;
}

}  // namespace rc::formats
