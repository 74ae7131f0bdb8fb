// Generators: the same numbers everywhere, coarse stages inside fine ones, the spectrum that was asked for.
#include <algorithm>
#include <cmath>
#include <complex>
#include <thread>

#include "library.h"
#include "support/cmocka.hpp"

using namespace surface_tests;

namespace {

void require_hash(const char* name, const std::vector<double>& z, std::uint64_t golden) {
  if (hash(z) != golden)
    fail_msg("%s: hash %llx, golden %llx", name, static_cast<unsigned long long>(hash(z)),
             static_cast<unsigned long long>(golden));
}

// Bit for bit on every machine, compiler and optimisation.
void midpoint_displacement_and_noise_have_golden_bits(void**) {
  require_hash("rmd", midpoint(1, 7, 0.7, -1, false).z, 0x2e1e669770ef5299u);
  require_hash("rmd, cropped", midpoint(20261, 6, 0.3).z, 0x77888bc1ff17ca9au);
  require_hash("rmd with additions", midpoint(7, 6, 0.5, -1, false, true).z, 0x96773429e0cf9ff6u);
  require_hash("noise", noise(3, 50).z, 0xf377e42e556783f3u);
}

void spectral_surfaces_have_golden_values(void**) {
  const Grid grid = self_affine(5, 48, 0.8, [](auto& spec) {
    spec.ny = 30;
    spec.hy = 1.5;
    spec.q_rolloff = 0.5;
  });
  const double golden[] = {0.82205423104224962, -0.35923567976986104, 0.27382606886256555, 0.75814312066960576};
  const std::size_t at[] = {0, 17, 700, 1439};
  for (int k = 0; k < 4; ++k) {
    if (!(std::abs(grid.z[at[k]] - golden[k]) <= 1e-12))
      fail_msg("z[%zu] = %.17g, golden %.17g", at[k], grid.z[at[k]], golden[k]);
  }
}

void threads_do_not_matter(void**) {
  const std::uint64_t alone = hash(self_affine(9, 60, 0.5).z) ^ hash(midpoint(9, 6, 0.5).z);
  std::uint64_t together[4] = {};
  std::vector<std::thread> threads;
  for (auto& h : together) threads.emplace_back([&h] { h = hash(self_affine(9, 60, 0.5).z) ^ hash(midpoint(9, 6, 0.5).z); });
  for (auto& thread : threads) thread.join();
  for (const auto h : together) assert_true(h == alone);
}

void coarse_stages_are_subsamples_of_fine_ones(void**) {
  const Grid fine = midpoint(11, 7, 0.6, 7, false);
  for (int stage = 0; stage < 7; ++stage) {
    const std::int64_t step = std::int64_t{1} << (7 - stage);
    for (const bool crop : {false, true}) {
      const Grid coarse = midpoint(11, 7, 0.6, stage, crop);
      for (std::int64_t y = 0; y < coarse.ny; ++y)
        for (std::int64_t x = 0; x < coarse.nx; ++x) assert_true(coarse.at(x, y) == fine.at(step * x, step * y));
    }
  }
}

void every_stage_shares_the_scale_of_the_finest(void**) {
  rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
  spec.levels = 6;
  spec.rms_height = 2.5;
  std::vector<double> fine(65 * 65), coarse(33 * 33);
  require_ok(rc_surface_rmd(&spec, 6, 0, fine.data()));
  require_ok(rc_surface_rmd(&spec, 5, 0, coarse.data()));
  double mean = 0, square = 0;
  for (const double z : fine) mean += z / 4225;
  for (const double z : fine) square += (z - mean) * (z - mean) / 4225;
  assert_true(std::abs(std::sqrt(square) / 2.5 - 1) < 1e-12);
  for (std::size_t y = 0; y < 33; ++y)
    for (std::size_t x = 0; x < 33; ++x) assert_true(coarse[y * 33 + x] == fine[2 * y * 65 + 2 * x]);
}

// New points' displacements shrink by 2^-H a stage: their squares tell the Hurst exponent that went in.
void displacements_shrink_by_the_hurst_exponent(void**) {
  for (const double hurst : {0.3, 0.7, 1.0}) {
    double squares[2] = {};
    for (int k = 0; k < 2; ++k) {
      const int stage = 6 + k;
      const Grid grid = midpoint(4, 7, hurst, stage, false);
      for (std::int64_t y = 1; y < grid.ny; y += 2)
        for (std::int64_t x = 1; x < grid.nx; x += 2) {
          const double d = grid.at(x, y) -
                           0.25 * (grid.at(x - 1, y - 1) + grid.at(x + 1, y - 1) + grid.at(x - 1, y + 1) + grid.at(x + 1, y + 1));
          squares[k] += d * d / std::pow(4.0, stage - 1);
        }
    }
    assert_true(std::abs(0.5 * std::log2(squares[0] / squares[1]) - hurst) < 0.08);
  }
}

void noise_is_gaussian(void**) {
  const rc_surface_statistics s = statistics(noise(1, 400));
  const double n = 400 * 400;
  assert_true(std::abs(s.rms_height - 1) < 4 / std::sqrt(2 * n));
  assert_true(std::abs(s.skewness) < 4 * std::sqrt(6 / n));
  assert_true(std::abs(s.kurtosis - 3) < 4 * std::sqrt(24 / n));
}

// With fixed amplitudes |a|^2 is what was asked for, up to one factor, in every ring.
void spectrum_is_the_one_asked_for(void**) {
  for (const int ny : {1, 45}) {
    const Grid grid = self_affine(2, 64, 0.6, [ny](auto& spec) {
      spec.ny = ny;
      spec.hx = 2;
      spec.hy = 1.5;
      spec.q_low = 0.15;
      spec.q_rolloff = 0.4;
      spec.q_high = 1.2;
      spec.fixed_amplitudes = 1;
    });
    const double exponent = ny == 1 ? -1 - 2 * 0.6 : -2 - 2 * 0.6;
    const double dx = 2 * pi / (64 * 2), dy = 2 * pi / (ny * 1.5);
    std::vector<double> found, wanted;
    for (std::int64_t ky = 0; ky < ny; ++ky) {
      for (std::int64_t kx = 0; kx < 64; ++kx) {
        std::complex<double> a = 0;
        for (std::int64_t y = 0; y < ny; ++y)
          for (std::int64_t x = 0; x < 64; ++x)
            a += grid.at(x, y) * std::polar(1.0, -2 * pi * (static_cast<double>(kx * x) / 64 + static_cast<double>(ky * y) / ny));
        const double q =
            std::hypot(dx * static_cast<double>(kx > 32 ? kx - 64 : kx), dy * static_cast<double>(ky > ny / 2 ? ky - ny : ky));
        found.push_back(std::norm(a));
        wanted.push_back(q < 0.15 || q > 1.2 ? 0 : std::pow(std::max(q, 0.4) / 0.4, exponent));
      }
    }
    const double factor = *std::ranges::max_element(found);
    double largest = 0;
    for (std::size_t k = 0; k < found.size(); ++k) largest = std::max(largest, std::abs(found[k] / factor - wanted[k]));
    if (!(largest < 1e-11)) fail_msg("ny = %d: the spectrum is off by %.3g", ny, largest);
  }
}

void heights_and_slopes_have_the_rms_asked_for(void**) {
  const Grid by_height = self_affine(3, 50, 0.8, [](auto& spec) { spec.rms_height = 0.3; });
  assert_true(std::abs(statistics(by_height).rms_height / 0.3 - 1) < 1e-12);
  // Waves of at least 20 pitches: differences are derivatives up to 1 %.
  const Grid by_slope = self_affine(3, 200, 0.8, [](auto& spec) {
    spec.q_high = 2 * pi / 20;
    spec.rms_height = 0;
    spec.rms_slope = 0.07;
  });
  assert_true(std::abs(statistics(by_slope).rms_slope / 0.07 - 1) < 0.01);
}

void shapes_are_where_they_should_be(void**) {
  rc_surface_shape_spec spec = RC_SURFACE_SHAPE_SPEC_INIT;
  spec.nx = 5;
  spec.ny = 3;
  spec.hx = 2;
  spec.radius = 3;
  double z[15];
  require_ok(rc_surface_shape(&spec, z));
  assert_true(z[7] == 0);
  assert_true(std::abs(z[0] + (16 + 1) / 6.0) < 1e-15);
  spec.shape = RC_SURFACE_SPHERE;
  require_ok(rc_surface_shape(&spec, z));
  assert_true(std::abs(z[1 * 5 + 3] - (std::sqrt(9.0 - 4) - 3)) < 1e-15);
  assert_true(z[5] == -3);  // 4 from the axis, beyond the radius
  spec.shape = RC_SURFACE_WAVES;
  spec.height = 2;
  spec.period_x = 8;
  spec.period_y = 0;
  require_ok(rc_surface_shape(&spec, z));
  assert_true(z[0] == 2 && std::abs(z[1]) < 1e-15 && std::abs(z[2] + 2) < 1e-15 && z[5] == 2);
  spec.shape = RC_SURFACE_PYRAMIDS;
  spec.period_y = 4;
  require_ok(rc_surface_shape(&spec, z));
  assert_true(z[0] == 2 && z[1] == 1 && z[2] == 0 && z[5] == 1 && z[10] == 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(midpoint_displacement_and_noise_have_golden_bits),
                              cmocka_unit_test(spectral_surfaces_have_golden_values),
                              cmocka_unit_test(threads_do_not_matter),
                              cmocka_unit_test(coarse_stages_are_subsamples_of_fine_ones),
                              cmocka_unit_test(every_stage_shares_the_scale_of_the_finest),
                              cmocka_unit_test(displacements_shrink_by_the_hurst_exponent),
                              cmocka_unit_test(noise_is_gaussian),
                              cmocka_unit_test(spectrum_is_the_one_asked_for),
                              cmocka_unit_test(heights_and_slopes_have_the_rms_asked_for),
                              cmocka_unit_test(shapes_are_where_they_should_be)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
