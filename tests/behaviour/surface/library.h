// Short forms of the surface library's calls for tests: each fails the test if the call does.
#pragma once

#include <roughcontact/surface.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace surface_tests {

constexpr double pi = 3.14159265358979323846;

struct Grid {
  std::int64_t nx = 1, ny = 1;
  double hx = 1, hy = 1;
  bool periodic = false;
  std::vector<double> z;

  double at(std::int64_t x, std::int64_t y) const { return z[static_cast<std::size_t>(y * nx + x)]; }
};

rc_surface_map map_of(const Grid& grid);
void require_ok(rc_status status);

Grid midpoint(std::uint64_t seed, int levels, double hurst, int stage = -1, bool crop = true, bool additions = false);
// A periodic surface of n x n points; the settings may be changed before it is made.
Grid self_affine(
    std::uint64_t seed, std::int64_t n, double hurst,
    const std::function<void(rc_surface_spectral_spec&)>& change = [](auto&) {});
Grid pyramids(std::int64_t n, double period);
Grid noise(std::uint64_t seed, std::int64_t n);

rc_surface_statistics statistics(const Grid& grid);
rc_surface_power_law power_law(const Grid& grid);
rc_surface_cmr advice(const Grid& grid, int levels, double approach = 0);

struct Psd {
  std::vector<double> q, power;
  std::vector<std::int64_t> modes;
};
Psd psd(const Grid& grid);

// FNV-1a over the bits of all values.
std::uint64_t hash(const std::vector<double>& values);

}  // namespace surface_tests
