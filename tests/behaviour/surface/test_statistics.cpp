// Roughness parameters and the PSD against sums written out here.
#include <cmath>
#include <complex>
#include <numeric>

#include "library.h"
#include "support/cmocka.hpp"

using namespace surface_tests;

namespace {

void require_near(const char* what, double value, double expected, double tolerance) {
  if (!(std::abs(value - expected) <= tolerance * std::abs(expected)))
    fail_msg("%s: %.15g, expected %.15g", what, value, expected);
}

Grid tilted(const Grid& grid) {
  Grid out = grid;
  for (std::int64_t y = 0; y < grid.ny; ++y)
    for (std::int64_t x = 0; x < grid.nx; ++x)
      out.z[static_cast<std::size_t>(y * grid.nx + x)] += 5 + 0.3 * static_cast<double>(x) - 0.2 * static_cast<double>(y);
  return out;
}

Grid rough(bool periodic) {
  Grid grid = self_affine(8, 37, 0.5, [](auto& spec) {
    spec.ny = 22;
    spec.hx = 1.5;
    spec.hy = 0.7;
    spec.q_high = 100;  // every mode has power
  });
  grid.periodic = periodic;
  return grid;
}

// The surface repeats. A plane that is added to a surface that does not repeat changes no moment.
void moments_are_those_of_the_definitions(void**) {
  const Grid grid = rough(true);
  const double n = static_cast<double>(grid.z.size());
  double m[5] = {}, slope_x = 0, slope_y = 0, zxx2 = 0, zyy2 = 0, curvature = 0;
  const auto z = [&](std::int64_t x, std::int64_t y) { return grid.at((x + grid.nx) % grid.nx, (y + grid.ny) % grid.ny); };
  for (std::int64_t y = 0; y < grid.ny; ++y) {
    for (std::int64_t x = 0; x < grid.nx; ++x) {
      for (int k = 2; k < 5; ++k) m[k] += std::pow(z(x, y), k) / n;
      slope_x += std::pow((z(x + 1, y) - z(x, y)) / 1.5, 2) / n;
      slope_y += std::pow((z(x, y + 1) - z(x, y)) / 0.7, 2) / n;
      const double zxx = (z(x + 1, y) - 2 * z(x, y) + z(x - 1, y)) / (1.5 * 1.5);
      const double zyy = (z(x, y + 1) - 2 * z(x, y) + z(x, y - 1)) / (0.7 * 0.7);
      zxx2 += zxx * zxx / n;
      zyy2 += zyy * zyy / n;
      curvature += std::pow((zxx + zyy) / 2, 2) / n;
    }
  }
  const rc_surface_statistics s = statistics(grid);
  require_near("rms height", s.rms_height, std::sqrt(m[2]), 1e-12);
  require_near("skewness", s.skewness, m[3] / std::pow(m[2], 1.5), 1e-10);
  require_near("kurtosis", s.kurtosis, m[4] / (m[2] * m[2]), 1e-12);
  require_near("slope along x", s.rms_slope_x, std::sqrt(slope_x), 1e-12);
  require_near("slope along y", s.rms_slope_y, std::sqrt(slope_y), 1e-12);
  require_near("slope", s.rms_slope, std::sqrt(slope_x + slope_y), 1e-12);
  require_near("curvature", s.rms_curvature, std::sqrt(curvature), 1e-12);
  require_near("m0", s.m0, m[2], 1e-12);
  require_near("m2", s.m2, (slope_x + slope_y) / 2, 1e-12);
  require_near("m4", s.m4, (zxx2 + zyy2) / 2, 1e-12);
  require_near("Nayak", s.nayak, s.m0 * s.m4 / (s.m2 * s.m2), 1e-14);
  const rc_surface_statistics level = statistics(rough(false)), tilt = statistics(tilted(rough(false)));
  require_near("rms height", tilt.rms_height, level.rms_height, 1e-12);
  require_near("skewness", tilt.skewness, level.skewness, 1e-10);
  require_near("slope", tilt.rms_slope, level.rms_slope, 1e-12);
  assert_true(level.highest > 0 && level.lowest < 0);
}

void edges_are_not_joined_where_the_surface_ends(void**) {
  Grid ramp{4, 1, 0.5, 1, false, {0, 1, 4, 9}};
  rc_surface_map map = map_of(ramp);
  map.trend = RC_SURFACE_TREND_MEAN;
  rc_surface_statistics s{};
  s.struct_size = sizeof s;
  require_ok(rc_surface_analyze(&map, &s));
  require_near("slope", s.rms_slope, std::sqrt((4 + 36 + 100) / 3.0), 1e-14);
  require_near("curvature", s.rms_curvature, 4, 1e-14);  // half of zxx = 8: zyy is 0
  require_near("m4 of a profile", s.m4, 64, 1e-14);
}

void a_tilted_plane_is_flat(void**) {
  Grid grid{30, 20, 1, 1, false, std::vector<double>(600)};
  const rc_surface_statistics s = statistics(tilted(grid));
  assert_true(s.rms_height == 0 && s.rms_slope == 0 && std::isnan(s.skewness) && std::isnan(s.nayak));
}

// The transform, the window and the rings, mode by mode.
void psd_is_that_of_the_definition(void**) {
  for (const bool periodic : {true, false}) {
    Grid grid = rough(periodic);
    const std::int64_t nx = grid.nx, ny = grid.ny;
    const double area = static_cast<double>(nx) * grid.hx * static_cast<double>(ny) * grid.hy;
    rc_surface_map map = map_of(grid);
    map.trend = RC_SURFACE_TREND_MEAN;
    std::int64_t count = 1000;
    std::vector<double> q(1000), power(1000);
    std::vector<std::int64_t> modes(1000);
    require_ok(rc_surface_psd(&map, q.data(), power.data(), modes.data(), &count));

    std::vector<double> w(grid.z.size(), 1.0), z = grid.z;
    for (std::int64_t y = 0; y < ny && !periodic; ++y)
      for (std::int64_t x = 0; x < nx; ++x)
        w[static_cast<std::size_t>(y * nx + x)] =
            (1 - std::cos(2 * pi * (static_cast<double>(x) + 0.5) / static_cast<double>(nx))) *
            (1 - std::cos(2 * pi * (static_cast<double>(y) + 0.5) / static_cast<double>(ny)));
    double mean = 0, weight = 0, square = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      mean += w[i] * z[i];
      weight += w[i];
      square += w[i] * w[i] / static_cast<double>(z.size());
    }
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = (z[i] - mean / weight) * w[i] / std::sqrt(square);

    const double dx = 2 * pi / (static_cast<double>(nx) * grid.hx), dy = 2 * pi / (static_cast<double>(ny) * grid.hy),
                 ring = std::min(dx, dy);
    std::vector<double> sums(200), qs(200);
    std::vector<std::int64_t> n(200);
    for (std::int64_t ky = 0; ky < ny; ++ky) {
      for (std::int64_t kx = 0; kx < nx; ++kx) {
        if (kx == 0 && ky == 0) continue;
        std::complex<double> a = 0;
        for (std::int64_t y = 0; y < ny; ++y)
          for (std::int64_t x = 0; x < nx; ++x)
            a += z[static_cast<std::size_t>(y * nx + x)] *
                 std::polar(1.0, -2 * pi *
                                     (static_cast<double>(kx * x) / static_cast<double>(nx) +
                                      static_cast<double>(ky * y) / static_cast<double>(ny)));
        const double size = std::hypot(dx * static_cast<double>(2 * kx > nx ? kx - nx : kx),
                                       dy * static_cast<double>(2 * ky > ny ? ky - ny : ky));
        const auto k = static_cast<std::size_t>(std::llround(size / ring));
        sums[k] += std::norm(a / static_cast<double>(z.size())) * area;
        qs[k] += size;
        ++n[k];
      }
    }
    std::int64_t at = 0;
    for (std::size_t k = 0; k < n.size(); ++k) {
      if (n[k] == 0) continue;
      const auto i = static_cast<std::size_t>(at++);
      assert_true(modes[i] == n[k]);
      require_near("q", q[i], qs[k] / static_cast<double>(n[k]), 1e-12);
      require_near("C", power[i], sums[k] / static_cast<double>(n[k]), 1e-9);
    }
    assert_true(at == count);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(moments_are_those_of_the_definitions),
                              cmocka_unit_test(edges_are_not_joined_where_the_surface_ends),
                              cmocka_unit_test(a_tilted_plane_is_flat), cmocka_unit_test(psd_is_that_of_the_definition)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
