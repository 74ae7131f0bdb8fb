#include "maps.h"

#include <limits>

namespace analysis {

using namespace pairs;

bool Map::touches(std::int64_t i) const {
  const auto k = static_cast<std::size_t>(i);
  return (mask.empty() || mask[k] != 0) && p[k] > 0;
}

Map drawn(const std::vector<std::string>& rows, std::int32_t boundary) {
  Map map;
  map.system.boundary = boundary;
  map.system.nx = static_cast<std::int64_t>(rows[0].size());
  map.system.ny = static_cast<std::int64_t>(rows.size());
  map.system.hx = 0.5;
  map.system.hy = 2;
  bool masked = false;
  for (const std::string& row : rows)
    for (const char cell : row) {
      const bool digit = cell >= '0' && cell <= '9';
      map.p.push_back(cell == 'x' ? std::numeric_limits<double>::quiet_NaN() : cell == '#' ? 1 : digit ? cell - '0' : 0);
      map.mask.push_back(cell != 'x');
      masked = masked || cell == 'x';
    }
  if (!masked) map.mask.clear();
  return map;
}

Map random_map(std::int64_t nx, std::int64_t ny, std::int32_t boundary, double share, double masked, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Map map;
  map.system.boundary = boundary;
  map.system.nx = nx;
  map.system.ny = ny;
  map.system.hx = 0.3;
  map.system.hy = 0.7;
  for (std::int64_t i = 0; i < nx * ny; ++i) {
    map.p.push_back(uniform(random) < share ? uniform(random) : 0);
    if (masked > 0) map.mask.push_back(uniform(random) >= masked);
  }
  return map;
}

rc_area area_of(const Map& map) {
  rc_area area = RC_AREA_INIT;
  check(rc_area_measure(&map.system, RC_IN(map.p.data()), RC_IN(map.mask_data()), &area) == RC_OK, rc_last_error());
  return area;
}

Patches patches_of(const Map& map, std::int32_t neighbours) {
  Patches found;
  rc_patches patches = RC_PATCHES_INIT;
  patches.neighbours = neighbours;
  check(rc_patches_find(&map.system, RC_IN(map.p.data()), RC_IN(map.mask_data()), &patches) == RC_OK, rc_last_error());
  const auto count = static_cast<std::size_t>(patches.count);
  found.label.assign(map.points(), -7);
  for (auto* numbers : {&found.cells, &found.peak}) numbers->assign(count, -7);
  for (Field* values : {&found.area, &found.perimeter, &found.load, &found.mean_pressure, &found.max_pressure})
    values->assign(count, -7);
  patches.room = patches.count;
  patches.label = RC_OUT(found.label.data());
  patches.cells = RC_OUT(found.cells.data());
  patches.area = RC_OUT(found.area.data());
  patches.perimeter = RC_OUT(found.perimeter.data());
  patches.load = RC_OUT(found.load.data());
  patches.mean_pressure = RC_OUT(found.mean_pressure.data());
  patches.max_pressure = RC_OUT(found.max_pressure.data());
  patches.peak = RC_OUT(found.peak.data());
  check(rc_patches_find(&map.system, RC_IN(map.p.data()), RC_IN(map.mask_data()), &patches) == RC_OK, rc_last_error());
  found.count = patches.count;
  check_equal(found.count, patches.room, "count with and without arrays");
  return found;
}

Histogram histogram_of(const Map& map, std::int64_t bins, double upper) {
  Histogram found;
  found.counts.assign(static_cast<std::size_t>(bins), -7);
  found.density.assign(static_cast<std::size_t>(bins), -7);
  found.said.bins = bins;
  found.said.upper = upper;
  found.said.counts = RC_OUT(found.counts.data());
  found.said.density = RC_OUT(found.density.data());
  check(rc_histogram_fill(&map.system, RC_IN(map.p.data()), RC_IN(map.mask_data()), &found.said) == RC_OK, rc_last_error());
  return found;
}

}  // namespace analysis
