// Bad input gives a status and a message that names it. Nothing is written, and GSL's error handler is not called.
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "library.h"
#include "support/cmocka.hpp"

using namespace surface_tests;

namespace {

int gsl_errors = 0;
void count_gsl_error(const char*, const char*, int, int) { ++gsl_errors; }

void require_error(rc_status status, rc_status expected, const char* words) {
  const std::string message = rc_surface_last_error();
  if (status != expected || message.find(words) == std::string::npos)
    fail_msg("status %d, message \"%s\"; expected %d with \"%s\"", static_cast<int>(status), message.c_str(),
             static_cast<int>(expected), words);
  if (message.rfind("rc_surface_", 0) != 0) fail_msg("\"%s\" does not say where", message.c_str());
}

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Spec> struct Row {
  rc_status status;
  const char* words;
  void (*change)(Spec&);
};

template <class Spec, class Call> void refuses(const Spec& good, const Call& call, std::initializer_list<Row<Spec>> rows) {
  for (const Row<Spec>& row : rows) {
    Spec spec = good;
    row.change(spec);
    require_error(call(&spec), row.status, row.words);
  }
}

constexpr rc_status bad = RC_ERR_ARGUMENT, shape = RC_ERR_SHAPE;
const char* const limits = "is not in 1e-60 .. 1e60";  // beyond which heights or ratios would not be finite

void midpoint_displacement(void**) {
  double out[25] = {7};
  using S = rc_surface_rmd_spec;
  const S good = RC_SURFACE_RMD_SPEC_INIT;
  refuses<S>(good, [&out](const S* spec) { return rc_surface_rmd(spec, 2, 0, out); },
             {{bad, "levels = 0", [](S& s) { s.levels = 0; }},
              {bad, "levels = 15", [](S& s) { s.levels = 15; }},
              {bad, "stage = 2", [](S& s) { s.levels = 1; }},
              {bad, "hurst = 0", [](S& s) { s.hurst = 0; }},
              {bad, "hurst", [](S& s) { s.hurst = NAN; }},
              {bad, "sigma", [](S& s) { s.sigma = -1; }},
              {bad, limits, [](S& s) { s.sigma = 5e-324; }},
              {bad, limits, [](S& s) { s.sigma = 1.01e60; }},
              {bad, "rms_height", [](S& s) { s.rms_height = infinite; }},
              {bad, "additions", [](S& s) { s.additions = 2; }}});
  require_error(rc_surface_rmd(&good, 2, 3, out), bad, "crop");
  assert_true(out[0] == 7);
}

void spectral(void**) {
  double out[4] = {7};
  using S = rc_surface_spectral_spec;
  S good = RC_SURFACE_SPECTRAL_SPEC_INIT;
  good.nx = good.ny = 2;
  refuses<S>(good, [&out](const S* spec) { return rc_surface_spectral(spec, out); },
             {{shape, "nx = 0", [](S& s) { s.nx = 0; }},
              {shape, "more than", [](S& s) { s.nx = s.ny = INT64_MAX; }},
              {bad, "hy = 0", [](S& s) { s.hy = 0; }},
              {bad, limits, [](S& s) { s.hx = 0.99e-60; }},
              {bad, limits, [](S& s) { s.hy = 1e300; }},
              {bad, "hurst = 1.5", [](S& s) { s.hurst = 1.5; }},
              {bad, "exactly one", [](S& s) { s.rms_slope = 1; }},
              {bad, "exactly one", [](S& s) { s.rms_height = 0; }},
              {bad, limits, [](S& s) { s.rms_height = 0, s.rms_slope = 1e308; }},
              {bad, "q_low = 2 is above", [](S& s) { s.q_low = 2, s.q_high = 1; }},
              {bad, "no wave", [](S& s) { s.q_low = 100; }},
              {bad, "no wave", [](S& s) { s.nx = s.ny = 1; }},
              {bad, "reserved", [](S& s) { s.reserved = 1; }}});
  assert_true(out[0] == 7);
}

void shapes(void**) {
  double out[4] = {7};
  using S = rc_surface_shape_spec;
  S good = RC_SURFACE_SHAPE_SPEC_INIT;
  good.nx = good.ny = 2;
  good.height = good.period_x = 1;
  refuses<S>(good, [&out](const S* spec) { return rc_surface_shape(spec, out); },
             {{bad, "shape = 9", [](S& s) { s.shape = 9; }},
              {bad, "radius = 0", [](S& s) { s.radius = 0; }},
              {bad, limits, [](S& s) { s.radius = 0.99e-60; }},
              {bad, limits, [](S& s) { s.hx = 9.2e-311; }},
              {bad, limits, [](S& s) { s.hy = 1.01e60; }},
              {bad, "both 0", [](S& s) { s.shape = RC_SURFACE_WAVES, s.period_x = 0; }},
              {bad, limits, [](S& s) { s.shape = RC_SURFACE_WAVES, s.period_y = 1e308; }},
              {bad, "period_x = -1", [](S& s) { s.shape = RC_SURFACE_PYRAMIDS, s.period_x = -1; }},
              {bad, limits, [](S& s) { s.shape = RC_SURFACE_NOISE, s.height = 1.01e60; }},
              {bad, "height", [](S& s) { s.shape = RC_SURFACE_NOISE, s.height = NAN; }}});
  assert_true(out[0] == 7);
}

void maps(void**) {
  static const double z[] = {1, 2, NAN, 4, infinite, 6}, huge[] = {0, 1e100, 0, 0, 0, 0}, good[] = {0, 1, 0, 0, 0, 0};
  using M = rc_surface_map;
  M map = RC_SURFACE_MAP_INIT;
  map.nx = 3;
  map.ny = 2;
  map.heights = good;
  rc_surface_statistics out = RC_SURFACE_STATISTICS_INIT;
  rc_surface_power_law law = RC_SURFACE_POWER_LAW_INIT;
  refuses<M>(map, [&out](const M* each) { return rc_surface_analyze(each, &out); },
             {{bad, "heights is null", [](M& m) { m.heights = nullptr; }},
              {bad, "2 values that are not finite, first at ix=2, iy=0", [](M& m) { m.heights = z; }},
              {bad, "another unit", [](M& m) { m.heights = huge; }},
              {bad, "periodic = 2", [](M& m) { m.periodic = 2; }},
              {bad, "trend = 7", [](M& m) { m.trend = 7; }},
              {bad, "map.hx = ", [](M& m) { m.hx = 0.99e-60; }},
              {shape, "ny = -1", [](M& m) { m.ny = -1; }}});
  refuses<M>(map, [&law](const M* each) { return rc_surface_fit(each, &law); },
             {{bad, limits, [](M& m) { m.hx = 9.2e-311; }}, {bad, "map.hy = ", [](M& m) { m.hy = 1.01e60; }}});
}

void flat_maps_have_nothing_to_judge(void**) {
  for (const std::int64_t n : {1, 20}) {
    const Grid grid{n, n, 1, 1, false, std::vector<double>(static_cast<std::size_t>(n * n), 3.5)};
    const rc_surface_map map = map_of(grid);
    rc_surface_power_law law{};
    law.struct_size = sizeof law;
    require_error(rc_surface_fit(&map, &law), RC_ERR_ARGUMENT, "flat");
    rc_surface_cmr cmr{};
    cmr.struct_size = sizeof cmr;
    require_error(rc_surface_cmr_advice(&map, 1, 0, &cmr), RC_ERR_ARGUMENT, "flat");
    assert_true(statistics(grid).rms_height == 0);
  }
}

void too_many_levels_and_small_arrays(void**) {
  const Grid grid = noise(1, 20);
  const rc_surface_map map = map_of(grid);
  rc_surface_cmr cmr{};
  cmr.struct_size = sizeof cmr;
  require_error(rc_surface_cmr_advice(&map, 4, 0, &cmr), RC_ERR_ARGUMENT, "levels = 4 is not in 1 .. 2");
  require_error(rc_surface_cmr_advice(&map, 0, 0, &cmr), RC_ERR_ARGUMENT, "levels = 0");
  require_error(rc_surface_cmr_advice(&map, 1, -1, &cmr), RC_ERR_ARGUMENT, "approach = -1");
  double q[2], power[2];
  std::int64_t modes[2], count = 2;
  require_error(rc_surface_psd(&map, q, power, modes, &count), RC_ERR_ARGUMENT, "the arrays hold 2 rings");
  require_error(rc_surface_psd(&map, q, nullptr, modes, &count), RC_ERR_ARGUMENT, "all or none");
  require_error(rc_surface_downsample(20, 20, grid.z.data(), nullptr, 0, power, nullptr), RC_ERR_ARGUMENT, "filter = 0");
  require_error(rc_surface_downsample(0, 20, grid.z.data(), nullptr, 1, power, nullptr), RC_ERR_SHAPE, "nx = 0");
}

void pitches_of_different_size(void**) {
  Grid grid = noise(1, 16);
  grid.periodic = true;
  const rc_surface_statistics moments = statistics(grid);
  for (const double hy : {1.0, 1e-2, 1.3e-8, 1e-17}) {
    grid.hy = hy;
    const Psd rings = psd(grid);
    assert_true(rings.q.size() < grid.z.size() && std::ranges::is_sorted(rings.q));
    std::int64_t modes = 0;
    double square = 0;
    for (std::size_t i = 0; i < rings.q.size(); ++i) {
      modes += rings.modes[i];
      square += rings.power[i] * static_cast<double>(rings.modes[i]) / (256 * hy);
    }
    assert_int_equal(modes, 255);
    assert_true(std::abs(square - moments.m0) < 1e-12 * moments.m0);
  }
  rc_surface_map map = map_of(grid);
  std::int64_t count = 0;
  map.hx = 1e60;
  map.hy = 1e-60;
  require_error(rc_surface_psd(&map, nullptr, nullptr, nullptr, &count), RC_ERR_ARGUMENT, "map.hx and map.hy");
  require_error(rc_surface_psd(&map, nullptr, nullptr, nullptr, &count), RC_ERR_ARGUMENT, "limit 9e18");
}

void success_clears_the_message(void**) {
  assert_true(rc_surface_rmd(nullptr, 0, 0, nullptr) == RC_ERR_ARGUMENT);
  statistics(noise(1, 8));
  assert_string_equal(rc_surface_last_error(), "");
}

void newer_callers_are_served(void**) {
  struct Newer {
    rc_surface_statistics known;
    double unknown;
  } newer{};
  newer.known.struct_size = sizeof newer;
  const Grid grid = noise(1, 8);
  const rc_surface_map map = map_of(grid);
  require_ok(rc_surface_analyze(&map, &newer.known));
  assert_true(newer.known.rms_height > 0 && newer.known.struct_size == sizeof newer);
  newer.unknown = 1;
  require_error(rc_surface_analyze(&map, &newer.known), bad, "newer library");
}

// Every size and kind of content through every function that calls GSL.
void gsl_never_reports_an_error(void**) {
  for (const std::int64_t nx : {1, 2, 3, 4, 5, 7, 8, 13, 16, 67}) {
    for (const std::int64_t ny : {1, 2, 3, 8, 31}) {
      for (int kind = 0; kind < 5; ++kind) {
        Grid grid{nx, ny, 1e-9, 3e-9, kind % 2 == 0, std::vector<double>(static_cast<std::size_t>(nx * ny))};
        const Grid rough = noise(7, 80);
        for (std::size_t i = 0; i < grid.z.size(); ++i) {
          const double x = static_cast<double>(i % static_cast<std::size_t>(nx));
          const double kinds[] = {rough.z[i], 1e-300 * rough.z[i], i == 0 ? 1e50 : 0, std::cos(2 * pi * x / 3), std::exp(-x)};
          grid.z[i] = kinds[kind];
        }
        const rc_surface_map map = map_of(grid);
        rc_surface_power_law law{};
        law.struct_size = sizeof law;
        const rc_status status = rc_surface_fit(&map, &law);
        if (status != RC_OK) assert_non_null(std::strstr(rc_surface_last_error(), "flat"));
        psd(grid);
      }
    }
  }
  if (gsl_errors > 0) fail_msg("GSL reported %d errors", gsl_errors);
  gsl_error_handler_t* ours = gsl_set_error_handler(count_gsl_error);
  assert_true(ours == count_gsl_error);
}

}  // namespace

int main() {
  gsl_set_error_handler(count_gsl_error);
  const CMUnitTest tests[] = {cmocka_unit_test(midpoint_displacement),
                              cmocka_unit_test(spectral),
                              cmocka_unit_test(shapes),
                              cmocka_unit_test(maps),
                              cmocka_unit_test(flat_maps_have_nothing_to_judge),
                              cmocka_unit_test(too_many_levels_and_small_arrays),
                              cmocka_unit_test(pitches_of_different_size),
                              cmocka_unit_test(success_clears_the_message),
                              cmocka_unit_test(newer_callers_are_served),
                              cmocka_unit_test(gsl_never_reports_an_error)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
