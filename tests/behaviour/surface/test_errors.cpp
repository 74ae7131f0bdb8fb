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

template <class Spec, class Call>
void refuses(Spec spec, void (*change)(Spec&), const Call& call, rc_status expected, const char* words) {
  change(spec);
  require_error(call(&spec), expected, words);
}

void midpoint_displacement(void**) {
  double out[25] = {7};
  using S = rc_surface_rmd_spec;
  const S good = RC_SURFACE_RMD_SPEC_INIT;
  const auto call = [&out](const S* spec) { return rc_surface_rmd(spec, 2, 0, out); };
  refuses<S>(
      good, [](S& s) { s.levels = 0; }, call, RC_ERR_ARGUMENT, "levels = 0");
  refuses<S>(
      good, [](S& s) { s.levels = 15; }, call, RC_ERR_ARGUMENT, "levels = 15");
  refuses<S>(
      good, [](S& s) { s.levels = 1; }, call, RC_ERR_ARGUMENT, "stage = 2");
  refuses<S>(
      good, [](S& s) { s.hurst = 0; }, call, RC_ERR_ARGUMENT, "hurst = 0");
  refuses<S>(
      good, [](S& s) { s.hurst = NAN; }, call, RC_ERR_ARGUMENT, "hurst");
  refuses<S>(
      good, [](S& s) { s.sigma = -1; }, call, RC_ERR_ARGUMENT, "sigma");
  refuses<S>(
      good, [](S& s) { s.rms_height = infinite; }, call, RC_ERR_ARGUMENT, "rms_height");
  refuses<S>(
      good, [](S& s) { s.additions = 2; }, call, RC_ERR_ARGUMENT, "additions");
  refuses<S>(
      good, [](S& s) { s.struct_size = 8; }, call, RC_ERR_ARGUMENT, "struct_size");
  require_error(rc_surface_rmd(&good, 2, 3, out), RC_ERR_ARGUMENT, "crop");
  require_error(rc_surface_rmd(&good, 2, 0, nullptr), RC_ERR_ARGUMENT, "out is null");
  require_error(rc_surface_rmd(nullptr, 2, 0, out), RC_ERR_ARGUMENT, "null");
  assert_true(out[0] == 7);
}

void spectral(void**) {
  double out[4] = {7};
  using S = rc_surface_spectral_spec;
  S good = RC_SURFACE_SPECTRAL_SPEC_INIT;
  good.nx = good.ny = 2;
  const auto call = [&out](const S* spec) { return rc_surface_spectral(spec, out); };
  refuses<S>(
      good, [](S& s) { s.nx = 0; }, call, RC_ERR_SHAPE, "nx = 0");
  refuses<S>(
      good, [](S& s) { s.nx = s.ny = INT64_MAX; }, call, RC_ERR_SHAPE, "more than");
  refuses<S>(
      good, [](S& s) { s.hy = 0; }, call, RC_ERR_ARGUMENT, "hy = 0");
  refuses<S>(
      good, [](S& s) { s.hurst = 1.5; }, call, RC_ERR_ARGUMENT, "hurst = 1.5");
  refuses<S>(
      good, [](S& s) { s.rms_slope = 1; }, call, RC_ERR_ARGUMENT, "exactly one");
  refuses<S>(
      good, [](S& s) { s.rms_height = 0; }, call, RC_ERR_ARGUMENT, "exactly one");
  refuses<S>(
      good,
      [](S& s) {
        s.q_low = 2;
        s.q_high = 1;
      },
      call, RC_ERR_ARGUMENT, "q_low = 2 is above");
  refuses<S>(
      good, [](S& s) { s.q_low = 100; }, call, RC_ERR_ARGUMENT, "no wave");
  refuses<S>(
      good, [](S& s) { s.nx = s.ny = 1; }, call, RC_ERR_ARGUMENT, "no wave");
  refuses<S>(
      good, [](S& s) { s.reserved = 1; }, call, RC_ERR_ARGUMENT, "reserved");
  assert_true(out[0] == 7);
}

void shapes(void**) {
  double out[4] = {7};
  using S = rc_surface_shape_spec;
  S good = RC_SURFACE_SHAPE_SPEC_INIT;
  good.nx = good.ny = 2;
  const auto call = [&out](const S* spec) { return rc_surface_shape(spec, out); };
  refuses<S>(
      good, [](S& s) { s.shape = 9; }, call, RC_ERR_ARGUMENT, "shape = 9");
  refuses<S>(
      good, [](S& s) { s.radius = 0; }, call, RC_ERR_ARGUMENT, "radius = 0");
  refuses<S>(
      good, [](S& s) { s.shape = RC_SURFACE_WAVES; }, call, RC_ERR_ARGUMENT, "both 0");
  refuses<S>(
      good,
      [](S& s) {
        s.shape = RC_SURFACE_PYRAMIDS;
        s.period_x = -1;
      },
      call, RC_ERR_ARGUMENT, "period_x = -1");
  refuses<S>(
      good,
      [](S& s) {
        s.shape = RC_SURFACE_NOISE;
        s.height = NAN;
      },
      call, RC_ERR_ARGUMENT, "height");
  assert_true(out[0] == 7);
}

void maps(void**) {
  const double z[] = {1, 2, NAN, 4, infinite, 6};
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = 3;
  map.ny = 2;
  rc_surface_statistics out{};
  out.struct_size = sizeof out;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_ARGUMENT, "heights is null");
  map.heights = z;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_ARGUMENT, "2 values that are not finite, first at ix=2, iy=0");
  const double huge[] = {0, 1e100, 0, 0, 0, 0};
  map.heights = huge;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_ARGUMENT, "another unit");
  map.periodic = 2;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_ARGUMENT, "periodic = 2");
  map.periodic = 0;
  map.trend = 7;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_ARGUMENT, "trend = 7");
  map.ny = -1;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_SHAPE, "ny = -1");
  require_error(rc_surface_analyze(nullptr, &out), RC_ERR_ARGUMENT, "null");
  require_error(rc_surface_analyze(&map, nullptr), RC_ERR_ARGUMENT, "null");
  out.struct_size = 3;
  require_error(rc_surface_analyze(&map, &out), RC_ERR_ARGUMENT, "struct_size = 3");
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
  require_error(rc_surface_psd(&map, q, power, modes, nullptr), RC_ERR_ARGUMENT, "count is null");
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

// Ratios of wave numbers would not be numbers any more.
void pitches_beyond_the_limits(void**) {
  Grid grid = noise(1, 46);
  grid.nx = 2;
  grid.ny = 23;
  grid.z.resize(46);
  for (const double pitch : {9.2e-311, 0.99e-60, 1.01e60, 1e300}) {
    for (const bool along_x : {true, false}) {
      rc_surface_map map = map_of(grid);
      (along_x ? map.hx : map.hy) = pitch;
      const char* const words = along_x ? "map.hx = " : "map.hy = ";
      rc_surface_power_law law{};
      law.struct_size = sizeof law;
      require_error(rc_surface_fit(&map, &law), RC_ERR_ARGUMENT, words);
      require_error(rc_surface_fit(&map, &law), RC_ERR_ARGUMENT, "is not in 1e-60 .. 1e60");
      rc_surface_statistics found{};
      found.struct_size = sizeof found;
      require_error(rc_surface_analyze(&map, &found), RC_ERR_ARGUMENT, words);
      double out[4] = {};
      rc_surface_spectral_spec waves = RC_SURFACE_SPECTRAL_SPEC_INIT;
      waves.nx = waves.ny = 2;
      waves.rms_height = 1;
      (along_x ? waves.hx : waves.hy) = pitch;
      require_error(rc_surface_spectral(&waves, out), RC_ERR_ARGUMENT, "is not in 1e-60 .. 1e60");
      rc_surface_shape_spec sphere = RC_SURFACE_SHAPE_SPEC_INIT;
      sphere.nx = sphere.ny = 2;
      sphere.radius = 1;
      (along_x ? sphere.hx : sphere.hy) = pitch;
      require_error(rc_surface_shape(&sphere, out), RC_ERR_ARGUMENT, "is not in 1e-60 .. 1e60");
    }
  }
}

// Heights would not be finite.
void lengths_beyond_the_limits(void**) {
  double out[9] = {};
  const auto shape = [&](std::int32_t kind, double rc_surface_shape_spec::*length, double value) {
    rc_surface_shape_spec spec = RC_SURFACE_SHAPE_SPEC_INIT;
    spec.shape = kind;
    spec.nx = spec.ny = 3;
    spec.height = spec.period_x = 1;
    spec.*length = value;
    return rc_surface_shape(&spec, out);
  };
  for (const double value : {5e-324, 0.99e-60, 1.01e60, 1e308}) {
    const char* const words = "is not in 1e-60 .. 1e60";
    require_error(shape(RC_SURFACE_PARABOLOID, &rc_surface_shape_spec::radius, value), RC_ERR_ARGUMENT, words);
    require_error(shape(RC_SURFACE_NOISE, &rc_surface_shape_spec::height, value), RC_ERR_ARGUMENT, words);
    require_error(shape(RC_SURFACE_WAVES, &rc_surface_shape_spec::period_y, value), RC_ERR_ARGUMENT, words);
    rc_surface_rmd_spec fractal = RC_SURFACE_RMD_SPEC_INIT;
    fractal.levels = 1;
    fractal.sigma = value;
    require_error(rc_surface_rmd(&fractal, 1, 0, out), RC_ERR_ARGUMENT, words);
    rc_surface_spectral_spec waves = RC_SURFACE_SPECTRAL_SPEC_INIT;
    waves.nx = waves.ny = 3;
    waves.rms_slope = value;
    require_error(rc_surface_spectral(&waves, out), RC_ERR_ARGUMENT, words);
  }
  for (const double height : out) assert_true(height == 0);
}

void success_clears_the_message(void**) {
  assert_true(rc_surface_rmd(nullptr, 0, 0, nullptr) == RC_ERR_ARGUMENT);
  statistics(noise(1, 8));
  assert_string_equal(rc_surface_last_error(), "");
}

void older_and_newer_callers_are_served(void**) {
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
  require_error(rc_surface_analyze(&map, &newer.known), RC_ERR_ARGUMENT, "newer library");
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
                              cmocka_unit_test(pitches_beyond_the_limits),
                              cmocka_unit_test(lengths_beyond_the_limits),
                              cmocka_unit_test(success_clears_the_message),
                              cmocka_unit_test(older_and_newer_callers_are_served),
                              cmocka_unit_test(gsl_never_reports_an_error)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
