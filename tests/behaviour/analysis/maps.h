// Maps of contact, and the library's analyses of them.
#pragma once

#include <roughcontact/analysis.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/contact.h"
#include "support/unit_system.h"

namespace analysis {

using pairs::Field;

struct Map {
  rc_system system = support::unit_system();
  Field p;
  std::vector<std::uint8_t> mask;  // empty: none

  const std::uint8_t* mask_data() const { return mask.empty() ? nullptr : mask.data(); }
  std::size_t points() const { return p.size(); }
  double cell() const { return system.hx * system.hy; }
  bool touches(std::int64_t i) const;
};

// Rows from the first on; '#': pressure 1, digits: that pressure, 'x': masked, its pressure NaN, else none. hx = 0.5, hy = 2.
Map drawn(const std::vector<std::string>& rows, std::int32_t boundary = RC_BOUNDARY_FREE);
// Pressures 0 .. 1 at a share of the points; a share of them masked.
Map random_map(std::int64_t nx, std::int64_t ny, std::int32_t boundary, double share, double masked, std::mt19937_64& random);
rc_area area_of(const Map& map);

struct Patches {
  std::int64_t count = -7;
  std::vector<std::int64_t> label, cells, peak;
  Field area, perimeter, load, mean_pressure, max_pressure;
};
Patches patches_of(const Map& map, std::int32_t neighbours);

struct Histogram {
  rc_histogram said = RC_HISTOGRAM_INIT;
  std::vector<std::int64_t> counts;
  Field density;
};
Histogram histogram_of(const Map& map, std::int64_t bins, double upper);

}  // namespace analysis
