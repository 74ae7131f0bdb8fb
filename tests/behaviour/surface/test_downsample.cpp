// Halving a grid, written out.
#include <cmath>

#include "library.h"
#include "support/cmocka.hpp"

using namespace surface_tests;

namespace {

const double heights[] = {1,  2, 3,  4,  5,    //
                          6,  7, 8,  9,  10,   //
                          11, 0, 13, 14, 15};  // 5 x 3

void require_values(std::int32_t filter, const std::uint8_t* mask, const double (&expected)[6],
                    const std::uint8_t (&expected_mask)[6]) {
  double z[15], out[6];
  std::uint8_t out_mask[6];
  for (int k = 0; k < 15; ++k) z[k] = mask && mask[k] == 0 ? (k % 2 ? NAN : INFINITY) : heights[k];  // not read
  require_ok(rc_surface_downsample(5, 3, z, mask, filter, out, out_mask));
  for (int k = 0; k < 6; ++k) {
    const bool same = std::isnan(expected[k]) ? std::isnan(out[k]) : out[k] == expected[k];
    if (!same || out_mask[k] != expected_mask[k]) fail_msg("filter %d, point %d: %g, mask %d", filter, k, out[k], out_mask[k]);
  }
}

void blocks_of_odd_sizes_are_smaller(void**) {
  const std::uint8_t all[] = {1, 1, 1, 1, 1, 1};
  require_values(RC_SURFACE_SUBSAMPLE, nullptr, {1, 3, 5, 11, 13, 15}, all);
  require_values(RC_SURFACE_MEAN, nullptr, {4, 6, 7.5, 5.5, 13.5, 15}, all);
  require_values(RC_SURFACE_MAX, nullptr, {7, 9, 10, 11, 14, 15}, all);
}

void masked_points_do_not_count(void**) {
  const std::uint8_t mask[] = {0, 1, 0, 0, 1,  //
                               1, 0, 0, 0, 0,  //
                               1, 0, 0, 1, 0};
  const std::uint8_t coarse[] = {1, 0, 1, 1, 1, 0};
  const double none = NAN;
  require_values(RC_SURFACE_SUBSAMPLE, mask, {2, none, 5, 11, 14, none}, coarse);
  require_values(RC_SURFACE_MEAN, mask, {4, none, 5, 11, 14, none}, coarse);
  require_values(RC_SURFACE_MAX, mask, {6, none, 5, 11, 14, none}, coarse);
}

void subsampling_gives_the_stages_of_midpoint_displacement(void**) {
  const Grid fine = midpoint(2, 6, 0.7, 6, false), coarse = midpoint(2, 6, 0.7, 5, false);
  std::vector<double> out(coarse.z.size());
  require_ok(rc_surface_downsample(65, 65, fine.z.data(), nullptr, RC_SURFACE_SUBSAMPLE, out.data(), nullptr));
  assert_true(out == coarse.z);
}

void a_line_is_halved_along_itself(void**) {
  const double z[] = {1, 5, 2};
  double out[2];
  require_ok(rc_surface_downsample(1, 3, z, nullptr, RC_SURFACE_MAX, out, nullptr));
  assert_true(out[0] == 5 && out[1] == 2);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(blocks_of_odd_sizes_are_smaller), cmocka_unit_test(masked_points_do_not_count),
                              cmocka_unit_test(subsampling_gives_the_stages_of_midpoint_displacement),
                              cmocka_unit_test(a_line_is_halved_along_itself)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
