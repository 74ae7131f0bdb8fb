// One map cut, cleaned, or brought onto the grid of another, by the functions of libroughcontact-formats.
#include "request/registration.h"

#include <roughcontact/formats.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace rc::request {

namespace {

// Ends of the regions along x and y [length].
struct Region {
  double x0, x1, y0, y1;
};

std::vector<double> lengths(const Words& words, std::string_view word, Units& units, std::string_view text) {
  const auto found = read_quantities(words.spelt(word), split(text, ','), Dimension::length, units.bare.metres);
  units.see(found);
  std::vector<double> values;
  for (const Quantity& each : found) values.push_back(each.si());
  return values;
}

// "x0..x1,y0..y1", or a margin that is cut off on all sides.
Region region(const Words& words, Units& units, const Given& given, const Map& map) {
  const double x = static_cast<double>(map.nx) * map.hx, y = static_cast<double>(map.ny) * map.hy;
  if (given.numbers.size() == 4) {
    const double f = units.bare.metres;
    return {f * given.numbers[0], f * given.numbers[1], f * given.numbers[2], f * given.numbers[3]};
  }
  const std::string text = given.text ? given.text : exact(given.numbers.front());
  const auto parts = split(text, ',');
  if (parts.size() == 1 && text.find("..") == std::string::npos) {
    const double margin = lengths(words, "crop", units, text).front();
    if (!(margin >= 0)) throw Error(words.spelt("crop"), ": ", given.shown(), " is negative, give a margin of 0 or more");
    return {margin, x - margin, margin, y - margin};
  }
  std::string ends;
  for (const std::string_view part : parts) {
    const auto dots = part.find("..");
    if (parts.size() != 2 || dots == std::string_view::npos)
      throw Error(words.spelt("crop"), ": ", given.shown(), " has not the form x0..x1,y0..y1, nor is it a margin");
    ends += join(ends.empty() ? "" : ",", part.substr(0, dots), ",", part.substr(dots + 2));
  }
  const auto values = lengths(words, "crop", units, ends);
  return {values[0], values[1], values[2], values[3]};
}

void cut(const Region& part, Map& map) {
  const std::int64_t nx = map.nx, ny = map.ny;
  double* const z = map.writable().data();
  for (std::int64_t k = 0; k < map.maps; ++k) {
    map.nx = nx;
    map.ny = ny;
    double* const one = z + k * nx * ny;
    check_formats(rc_surface_crop(&map.nx, &map.ny, map.hx, map.hy, part.x0, part.x1, part.y0, part.y1, one), map);
    std::copy_n(one, map.nx * map.ny, z + k * map.nx * map.ny);
  }
  map.own.resize(map.points());
  map.z = map.own.data();
  if (map.periodic == 1) map.periodic = -1;  // a part of it is a sample of a larger surface
}

// Points of a row with this pitch that lie between the first and the last point of another, whose first is at `from`.
std::pair<std::int64_t, std::int64_t> overlap(std::int64_t n, double h, double from, std::int64_t other, double pitch) {
  constexpr double round_off = 1e-9;  // of a pitch
  const double to = from + static_cast<double>(other - 1) * pitch;
  return {std::max<std::int64_t>(0, std::llround(std::ceil(from / h - round_off))),
          std::min<std::int64_t>(n - 1, std::llround(std::floor(to / h + round_off)))};
}

}  // namespace

void crop(const Words& words, Units& units, Map& map, rc_request& request) {
  const Given* const given = words.find("crop");
  if (!given) return;
  const Region part = region(words, units, *given, map);
  const auto before = static_cast<double>(map.nx * map.ny);
  mark_masked(map);
  cut(part, map);
  request.remarks.push_back({RC_REMARK_CROPPED,
                             RC_FACT,
                             "crop",
                             join(map.name, " is cropped to ", map.nx, " x ", map.ny, " points"),
                             {before, static_cast<double>(map.nx * map.ny), 0}});
}

std::int64_t despike(const Words& words, Map& map, rc_request& request) {
  const Given* const given = words.find("despike");
  if (!given) return 0;
  const double factor = given->text ? finite_number(words.spelt("despike"), given->text) : given->numbers.front();
  if (!(factor > 0)) throw Error(words.spelt("despike"), ": ", given->shown(), " is not positive, give about 10");
  mark_masked(map);
  std::int64_t all = 0;
  double largest = 0, *z = map.writable().data();
  for (std::int64_t k = 0; k < map.maps; ++k, z += map.nx * map.ny) {
    std::int64_t spikes = 0;
    double residual = 0;
    check_formats(rc_surface_despike(map.nx, map.ny, factor, z, &spikes, &residual), map);
    all += spikes;
    largest = std::max(largest, residual);
  }
  if (all > 0)
    request.remarks.push_back({RC_REMARK_SPIKES,
                               RC_FACT,
                               "despike",
                               join(map.name, ": ", all, " spike", all == 1 ? "" : "s", " taken out"),
                               {static_cast<double>(all), largest, 0}});
  return all;
}

void mirror(const Words& words, Map& other) {
  if (!words.find("mirror") || !other.z) return;
  mark_masked(other);
  check_formats(
      rc_surface_mirror(other.nx, other.ny, static_cast<std::int32_t>(words.chosen("mirror")) + 1, other.writable().data()),
      other);
}

void onto_grid(const Words& words, Units& units, Map& other, Map& map, rc_request& request) {
  const Given *const moved = words.find("shift"), *const how = words.find("resample");
  double dx = 0, dy = 0;
  if (moved) {
    const auto values = words.quantities(*moved, Dimension::length, units.bare.metres);
    units.see(values);
    dx = values.front().si();
    dy = values.back().si();
  }
  const bool same = other.nx == map.nx && other.ny == map.ny,
             pitch = same_pitch(other.hx, map.hx) && same_pitch(other.hy, map.hy);
  if (!other.z || !map.z || (same && pitch && !moved) || !(how || pitch) || (!same && !how && !moved)) return;
  mark_masked(other);
  rc_surface_resampling spec = RC_SURFACE_RESAMPLING_INIT;
  std::vector<double> found(static_cast<std::size_t>(map.nx * map.ny));
  spec.nx = other.nx;
  spec.ny = other.ny;
  spec.hx = other.hx;
  spec.hy = other.hy;
  spec.heights = other.z;
  spec.periodic = other.periodic == 1 ? 1 : 0;
  spec.interpolation = how && words.chosen("resample") == 0 ? RC_SURFACE_LINEAR : RC_SURFACE_CUBIC;
  spec.to_nx = map.nx;
  spec.to_ny = map.ny;
  spec.to_hx = map.hx;
  spec.to_hy = map.hy;
  spec.x0 = 0.5 * (map.hx - other.hx) - dx;  // the edges of the first cells are at one place
  spec.y0 = 0.5 * (map.hy - other.hy) - dy;
  spec.to = found.data();
  check_formats(rc_surface_resample(&spec), other);
  if (!pitch)
    request.remarks.push_back({RC_REMARK_RESAMPLED,
                               RC_FACT,
                               "resample",
                               join(other.name, " is resampled on the grid of ", map.name),
                               {other.hx, map.hx, 0}});
  const std::int64_t nx = other.nx, ny = other.ny;
  const double hx = other.hx, hy = other.hy;
  other.own = std::move(found);
  other.z = other.own.data();
  other.nx = map.nx;
  other.ny = map.ny;
  other.hx = map.hx;
  other.hy = map.hy;
  if (spec.periodic == 1) return;
  const auto [x0, x1] = overlap(map.nx, map.hx, -spec.x0, nx, hx);
  const auto [y0, y1] = overlap(map.ny, map.hy, -spec.y0, ny, hy);
  if (x0 > x1 || y0 > y1)
    throw Error(words.spelt("shift"), ": ", moved ? moved->shown() : "0", " leaves the two maps nothing in common");
  if (x0 == 0 && y0 == 0 && x1 == map.nx - 1 && y1 == map.ny - 1) return;
  const auto edge = [](std::int64_t cells, double h) { return static_cast<double>(cells) * h; };
  const Region common{edge(x0, map.hx), edge(x1 + 1, map.hx), edge(y0, map.hy), edge(y1 + 1, map.hy)};
  mark_masked(map);
  cut(common, other);
  cut(common, map);
  request.remarks.push_back({RC_REMARK_OVERLAP,
                             RC_FACT,
                             "shift",
                             join(map.nx, " x ", map.ny, " points that both maps have are left"),
                             {static_cast<double>(map.nx * map.ny), dx, dy}});
}

}  // namespace rc::request
