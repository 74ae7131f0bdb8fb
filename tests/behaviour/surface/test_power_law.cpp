// Power laws and textures found in surfaces whose spectrum is known, and the advice on cascade multi-resolution.
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "library.h"
#include "support/cmocka.hpp"

using namespace surface_tests;

namespace {

const bool quick = std::getenv("RC_TEST_QUICK") != nullptr;

// How many of the seeds have the Hurst exponent within the error that is reported.
template <class Make> void require_coverage(const char* name, int seeds, double widest, const Make& make) {
  int within = 0, all = 0;
  double bias = 0, error = 0;
  for (const double hurst : {0.3, 0.5, 0.7, 0.9}) {
    for (int seed = 1; seed <= seeds; ++seed) {
      const rc_surface_power_law law = power_law(make(static_cast<std::uint64_t>(100 * hurst + 1000 * seed), hurst));
      if (std::isnan(law.hurst)) fail_msg("%s: no power law, H = %g, seed %d", name, hurst, seed);
      ++all;
      within += std::abs(law.hurst - hurst) <= law.hurst_error ? 1 : 0;
      bias += law.hurst - hurst;
      error = std::max(error, law.hurst_error);
    }
  }
  print_message("%s: %d of %d within the 95 %% interval, mean deviation %.4f, widest interval +- %.3f\n", name, within, all,
                bias / all, error);
  // A 95 % interval holds less than 86 % of 80, or 65 % of 12, with a probability below 1e-3.
  if (within < (quick ? 0.65 : 0.86) * all) fail_msg("%s: only %d of %d within the 95 %% interval", name, within, all);
  if (!(error < widest)) fail_msg("%s: an interval of +- %g, limit %g", name, error, widest);
}

void hurst_exponent_is_within_its_error(void**) {
  const int seeds = quick ? 3 : 20;
  const std::int64_t n = 256;
  require_coverage("spectral, periodic", seeds, 0.03, [n](auto seed, double hurst) { return self_affine(seed, n, hurst); });
  require_coverage("spectral, windowed", seeds, 0.06, [n](auto seed, double hurst) {
    Grid grid = self_affine(seed, n, hurst);
    grid.periodic = false;
    return grid;
  });
  require_coverage("midpoint displacement", seeds, 0.5, [](auto seed, double hurst) { return midpoint(seed, 8, hurst); });
}

void profiles_have_their_own_exponent(void**) {
  const rc_surface_power_law law = power_law(self_affine(3, 8192, 0.6, [](auto& spec) { spec.ny = 1; }));
  assert_true(std::abs(law.hurst - 0.6) < law.hurst_error && law.hurst_error < 0.1);
  assert_true(std::abs(law.slope + 1 + 2 * law.hurst) < 1e-12);
}

void lengths_have_units(void**) {
  Grid grid = self_affine(3, 128, 0.6, [](auto& spec) { spec.q_rolloff = 0.4; });
  const rc_surface_power_law a = power_law(grid);
  grid.hx = grid.hy = 1e-9;
  for (double& z : grid.z) z *= 1e-9;
  const rc_surface_power_law b = power_law(grid);
  assert_true(std::abs(b.hurst - a.hurst) < 1e-9 && std::abs(b.q_rolloff / a.q_rolloff - 1e9) < 1);
  // The line through the spectrum, at one wave number.
  const double q = 1;
  assert_true(std::abs(b.prefactor * std::pow(q * 1e9, b.slope) / (a.prefactor * std::pow(q, a.slope)) / 1e-36 - 1) < 1e-6);
}

void roll_off_and_cut_off_are_found(void**) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const bool periodic : {true, false}) {
      const double roll_off = 2 * pi / 32, cut_off = 2 * pi / 4;
      Grid grid = self_affine(seed, 512, 0.8, [&](auto& spec) {
        spec.q_rolloff = roll_off;
        spec.q_high = cut_off;
      });
      grid.periodic = periodic;
      const rc_surface_power_law law = power_law(grid);
      if (!(std::abs(law.q_rolloff / roll_off - 1) < 0.15))
        fail_msg("roll-off at %g, found %g, seed %llu", roll_off, law.q_rolloff, static_cast<unsigned long long>(seed));
      if (!(std::abs(law.q_cutoff / cut_off - 1) < 0.15)) fail_msg("cut-off at %g, found %g", cut_off, law.q_cutoff);
      assert_true(std::abs(law.hurst - 0.8) < 1.5 * law.hurst_error);
      assert_true(law.q_min > 0.8 * roll_off && law.q_max < 1.2 * cut_off && law.peaks == 0);
    }
  }
}

void what_is_not_there_is_not_found(void**) {
  int rolled = 0, cut = 0, peaks = 0;
  const int seeds = quick ? 5 : 20;
  for (int seed = 1; seed <= seeds; ++seed) {
    const rc_surface_power_law law = power_law(self_affine(static_cast<std::uint64_t>(seed), 128, 0.7));
    rolled += std::isnan(law.q_rolloff) ? 0 : 1;
    cut += std::isnan(law.q_cutoff) ? 0 : 1;
    peaks += law.peaks > 0 ? 1 : 0;
  }
  print_message("of %d pure power laws: %d with a roll-off, %d with a cut-off, %d with a texture\n", seeds, rolled, cut, peaks);
  assert_true(rolled <= 1 && cut == 0 && peaks == 0);
  assert_true(std::isnan(power_law(noise(1, 128)).hurst));
}

void textures_are_found(void**) {
  const rc_surface_power_law tips = power_law(pyramids(256, 21.3));
  assert_true(tips.peaks >= 2);
  for (int k = 0; k < 2; ++k) assert_true(std::abs(std::hypot(tips.peak_qx[k], tips.peak_qy[k]) * 21.3 / (2 * pi) - 1) < 0.01);

  // A wave of 15 % of the variance in a rough surface, at 30 degrees.
  Grid grid = self_affine(6, 256, 0.7);
  const double q = 2 * pi / 12, qx = q * std::cos(pi / 6), qy = q * std::sin(pi / 6);
  for (std::int64_t i = 0; i < 256 * 256; ++i)
    grid.z[static_cast<std::size_t>(i)] += 0.6 * std::cos(qx * static_cast<double>(i % 256) + qy * static_cast<double>(i / 256));
  grid.periodic = false;
  const rc_surface_power_law law = power_law(grid);
  print_message("texture: %lld found, (%g, %g) for (%g, %g), share %g, H %g\n", static_cast<long long>(law.peaks), law.peak_qx[0],
                law.peak_qy[0], qx, qy, law.peak_share[0], law.hurst);
  assert_true(law.peaks == 1);
  assert_true(std::abs(law.peak_qx[0] - qx) < 0.01 * q && std::abs(law.peak_qy[0] - qy) < 0.01 * q);
  assert_true(law.peak_share[0] > 0.08 && law.peak_share[0] < 0.35);
  assert_true(std::abs(law.hurst - 0.7) < 0.1);
}

void require_advice(const char* name, const Grid& grid, bool trustworthy) {
  const rc_surface_cmr cmr = advice(grid, 2);
  print_message("%s: %s\n", name, cmr.reason);
  if ((cmr.trustworthy == 1) != trustworthy) fail_msg("%s: %s", name, cmr.reason);
  assert_true((cmr.safe_levels == 2) == trustworthy);
  assert_true(std::strncmp(cmr.reason, trustworthy ? "trustworthy" : "not", trustworthy ? 11 : 3) == 0);
}

// The classes on which plain cascade multi-resolution from 64 to 256 points a side was tried: it is within 1 % on the first and
// the resolved pyramids, and 8 to 90 % off on the others.
void advice_knows_where_the_cascade_fails(void**) {
  const auto rolled = [](double waves) { return [waves](auto& spec) { spec.q_rolloff = waves * 2 * pi / 256; }; };
  for (const std::uint64_t seed : {1, 2, 3}) {
    require_advice("power law", self_affine(seed, 256, 0.7), true);
    require_advice("midpoint displacement", midpoint(seed, 8, 0.7), true);
    require_advice("roll-off at 16 waves", self_affine(seed, 256, 0.7, rolled(16)), false);
    require_advice("roll-off at 48 waves", self_affine(seed, 256, 0.7, rolled(48)), false);
    require_advice("band of 40 to 80 waves",
                   self_affine(seed, 256, 0.7,
                               [](auto& spec) {
                                 spec.q_low = 40 * 2 * pi / 256;
                                 spec.q_high = 80 * 2 * pi / 256;
                               }),
                   false);
    require_advice("white noise", noise(seed, 256), false);
  }
  require_advice("pyramids of 5.3 cells", pyramids(256, 5.3), false);
  require_advice("pyramids of 21.3 cells", pyramids(256, 21.3), true);
}

// Smooth where it is deep, rough on top: of all heights the roughness is a small part, of those in reach it is all.
void advice_looks_at_the_part_within_reach(void**) {
  Grid grid = noise(1, 256);
  for (std::int64_t i = 0; i < 256 * 256; ++i) {
    const double groove = std::sin(2 * pi * static_cast<double>(i % 256) / 64);
    double& z = grid.z[static_cast<std::size_t>(i)];
    z = 0.02 * z + std::min(0.0, 3 * groove);
  }
  const rc_surface_cmr cmr = advice(grid, 2, 0.05);
  print_message("%s; %g overall\n", cmr.reason, cmr.unresolved_overall);
  assert_true(cmr.unresolved_overall < 0.01 && cmr.unresolved > 0.5 && cmr.trustworthy == 0);
  assert_non_null(std::strstr(cmr.reason, "finer scales than the surface as a whole"));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(hurst_exponent_is_within_its_error),
                              cmocka_unit_test(profiles_have_their_own_exponent),
                              cmocka_unit_test(lengths_have_units),
                              cmocka_unit_test(roll_off_and_cut_off_are_found),
                              cmocka_unit_test(what_is_not_there_is_not_found),
                              cmocka_unit_test(textures_are_found),
                              cmocka_unit_test(advice_knows_where_the_cascade_fails),
                              cmocka_unit_test(advice_looks_at_the_part_within_reach)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
