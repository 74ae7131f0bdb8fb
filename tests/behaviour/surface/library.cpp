#include "library.h"

#include <bit>

#include "support/cmocka.hpp"

namespace surface_tests {

void require_ok(rc_status status) {
  if (status != RC_OK) fail_msg("status %d: %s", static_cast<int>(status), rc_surface_last_error());
}

rc_surface_map map_of(const Grid& grid) {
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = grid.nx;
  map.ny = grid.ny;
  map.hx = grid.hx;
  map.hy = grid.hy;
  map.heights = grid.z.data();
  map.periodic = grid.periodic ? 1 : 0;
  return map;
}

Grid midpoint(std::uint64_t seed, int levels, double hurst, int stage, bool crop, bool additions) {
  rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
  spec.seed = seed;
  spec.levels = levels;
  spec.hurst = hurst;
  spec.additions = additions ? 1 : 0;
  if (stage < 0) stage = levels;
  Grid grid;
  grid.nx = grid.ny = (std::int64_t{1} << stage) + (crop ? 0 : 1);
  grid.z.resize(static_cast<std::size_t>(grid.nx * grid.ny));
  require_ok(rc_surface_rmd(&spec, stage, crop ? 1 : 0, grid.z.data()));
  return grid;
}

Grid self_affine(std::uint64_t seed, std::int64_t n, double hurst, const std::function<void(rc_surface_spectral_spec&)>& change) {
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = spec.ny = n;
  spec.hurst = hurst;
  change(spec);
  Grid grid{spec.nx, spec.ny, spec.hx, spec.hy, true, {}};
  grid.z.resize(static_cast<std::size_t>(grid.nx * grid.ny));
  require_ok(rc_surface_spectral(&spec, grid.z.data()));
  return grid;
}

namespace {
Grid shape(std::int64_t n, const std::function<void(rc_surface_shape_spec&)>& change) {
  rc_surface_shape_spec spec = RC_SURFACE_SHAPE_SPEC_INIT;
  spec.nx = spec.ny = n;
  change(spec);
  Grid grid{n, n, 1, 1, false, std::vector<double>(static_cast<std::size_t>(n * n))};
  require_ok(rc_surface_shape(&spec, grid.z.data()));
  return grid;
}
}  // namespace

Grid pyramids(std::int64_t n, double period) {
  return shape(n, [period](auto& spec) {
    spec.shape = RC_SURFACE_PYRAMIDS;
    spec.period_x = spec.period_y = period;
  });
}

Grid noise(std::uint64_t seed, std::int64_t n) {
  return shape(n, [seed](auto& spec) {
    spec.shape = RC_SURFACE_NOISE;
    spec.seed = seed;
  });
}

rc_surface_statistics statistics(const Grid& grid) {
  const rc_surface_map map = map_of(grid);
  rc_surface_statistics out{};
  out.struct_size = sizeof out;
  require_ok(rc_surface_analyze(&map, &out));
  return out;
}

rc_surface_power_law power_law(const Grid& grid) {
  const rc_surface_map map = map_of(grid);
  rc_surface_power_law out{};
  out.struct_size = sizeof out;
  require_ok(rc_surface_fit(&map, &out));
  return out;
}

rc_surface_cmr advice(const Grid& grid, int levels, double approach) {
  const rc_surface_map map = map_of(grid);
  rc_surface_cmr out{};
  out.struct_size = sizeof out;
  require_ok(rc_surface_cmr_advice(&map, levels, approach, &out));
  return out;
}

Psd psd(const Grid& grid) {
  const rc_surface_map map = map_of(grid);
  std::int64_t count = 0;
  require_ok(rc_surface_psd(&map, nullptr, nullptr, nullptr, &count));
  const auto size = static_cast<std::size_t>(count);
  Psd out{std::vector<double>(size), std::vector<double>(size), std::vector<std::int64_t>(size)};
  require_ok(rc_surface_psd(&map, out.q.data(), out.power.data(), out.modes.data(), &count));
  return out;
}

std::uint64_t hash(const std::vector<double>& values) {
  std::uint64_t h = 14695981039346656037u;
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int k = 0; k < 64; k += 8) h = (h ^ ((bits >> k) & 0xff)) * 1099511628211u;
  }
  return h;
}

}  // namespace surface_tests
