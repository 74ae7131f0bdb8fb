// The analysis of measured surfaces whose character is known, within stated tolerances.
#include <roughcontact/formats.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "library.h"
#include "support/cmocka.hpp"

using namespace surface_tests;

namespace {

const std::string data = std::string(RC_MEASURED_DIR) + "/";

Grid read(const std::string& name) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  if (rc_surface_read((data + name + ".gsf").c_str(), nullptr, &file) != RC_OK) fail_msg("%s", rc_surface_read_last_error());
  Grid grid{file.nx, file.ny, file.hx, file.hy, false, {file.heights, file.heights + file.nx * file.ny}};
  rc_surface_file_free(&file);
  return grid;
}

void require_within(const std::string& what, double value, double expected, double tolerance) {
  print_message("%s: %.4g, known %.4g\n", what.c_str(), value, expected);
  if (!(std::abs(value / expected - 1) <= tolerance))
    fail_msg("%s: %g, expected %g within %g", what.c_str(), value, expected, tolerance);
}

double wavelength(double q) { return 2 * pi / q; }
double texture(const rc_surface_power_law& law) {
  return law.peaks > 0 ? wavelength(std::hypot(law.peak_qx[0], law.peak_qy[0])) : NAN;
}

void heights_and_slopes(void**) {
  struct Known {
    const char* name;
    double rms_height, rms_slope, tolerance;
  };
  for (const Known& known :
       {Known{"measured/afm_film_10um", 14.32e-9, 0.223, 0.01}, Known{"measured/afm_selfaffine_10um", 35.22e-9, 0.192, 0.01},
        Known{"measured/afm_patch_10um", 79.42e-9, 0.179, 0.01}, Known{"measured/confocal_lay_1275um", 18.28e-9, 0.0046, 0.01},
        Known{"measured/x3p_rectpix_83x204um", 77.19e-9, 0.062, 0.01},
        Known{"measured-lgpl/fv_rubber_2mm", 3.394e-6, 0.144, 0.01},
        Known{"measured-lgpl/fv_skibase_4mm", 18.13e-6, 0.390, 0.01}}) {
    const rc_surface_statistics s = statistics(read(known.name));
    require_within(std::string(known.name) + ", rms height", s.rms_height, known.rms_height, known.tolerance);
    require_within(std::string(known.name) + ", rms slope", s.rms_slope, known.rms_slope, known.tolerance);
  }
}

// Hurst exponents within 0.06, roll-offs within 25 %, periods within 8 %.
void self_affine_to_the_pixel(void**) {
  const Grid grid = read("measured/afm_selfaffine_10um");
  const rc_surface_power_law law = power_law(grid);
  require_within("afm_selfaffine, H", law.hurst, 0.79, 0.06 / 0.79);
  assert_true(law.hurst_error < 0.06 && law.peaks == 0 && std::isnan(law.q_cutoff));
  assert_true(wavelength(law.q_max) < 2.1 * grid.hx && std::log10(law.q_max / law.q_min) > 1.1);
}

void film_with_a_roll_off_is_not_fractal(void**) {
  const rc_surface_power_law law = power_law(read("measured/afm_film_10um"));
  require_within("afm_film, roll-off", wavelength(law.q_rolloff), 0.54e-6, 0.25);
  require_within("afm_film, exponent", law.slope, -4.86, 0.03);
  assert_true(law.hurst - law.hurst_error > 1);
}

void rubber_has_roll_off_and_power_law(void**) {
  const rc_surface_power_law law = power_law(read("measured-lgpl/fv_rubber_2mm"));
  require_within("fv_rubber, roll-off", wavelength(law.q_rolloff), 0.30e-3, 0.25);
  require_within("fv_rubber, H", law.hurst, 0.87, 0.06 / 0.87);
  assert_true(std::abs(law.hurst - 0.87) < law.hurst_error && law.peaks == 0);
}

void patch_is_uncertain(void**) {
  const rc_surface_power_law law = power_law(read("measured/afm_patch_10um"));
  print_message("afm_patch: H %.3f +- %.3f, known 0.61\n", law.hurst, law.hurst_error);
  assert_true(std::abs(law.hurst - 0.61) < law.hurst_error && law.hurst_error < 0.2 && std::isnan(law.q_rolloff));
}

void line_texture_of_rectangular_pixels(void**) {
  const rc_surface_power_law law = power_law(read("measured/x3p_rectpix_83x204um"));
  require_within("x3p_rectpix, period", texture(law), 9.2e-6, 0.02);
  assert_true(law.peak_share[0] > 0.5);
}

void grooves_of_the_ski_base(void**) {
  const Grid grid = read("measured-lgpl/fv_skibase_4mm");
  require_within("fv_skibase, period", texture(power_law(grid)), 745e-6, 0.08);
  const rc_surface_cmr cmr = advice(grid, 4);
  print_message("%s\n", cmr.reason);
  assert_true(cmr.trustworthy == 0 && cmr.unresolved > 0.8 && cmr.unresolved_overall < 0.1);
}

}  // namespace

int main() {
  if (!std::ifstream{data + "measured/afm_film_10um.gsf"}) {
    std::printf("skipped: no measured surfaces in %s\n", data.c_str());
    return 77;
  }
  const CMUnitTest tests[] = {cmocka_unit_test(heights_and_slopes),
                              cmocka_unit_test(self_affine_to_the_pixel),
                              cmocka_unit_test(film_with_a_roll_off_is_not_fractal),
                              cmocka_unit_test(rubber_has_roll_off_and_power_law),
                              cmocka_unit_test(patch_is_uncertain),
                              cmocka_unit_test(line_texture_of_rectangular_pixels),
                              cmocka_unit_test(grooves_of_the_ski_base)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
