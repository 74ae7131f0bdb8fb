// The backend split through its vtable.
#include "scene.h"
#include "support/cmocka.hpp"

int main() {
  using namespace split;
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_kernel_is_accurate),
      cmocka_unit_test(every_spacing_is_accurate),
      cmocka_unit_test(cells_need_not_be_square),
      cmocka_unit_test(any_domain_is_accurate),
      cmocka_unit_test(a_growing_domain_equals_a_fresh_operator),
      cmocka_unit_test(pressure_far_from_the_domain_s_middle_counts),
      cmocka_unit_test(results_do_not_depend_on_threads),
      cmocka_unit_test(long_cells_and_periodic_grids_are_refused),
      cmocka_unit_test(modelled_points_follow_the_domain),
      cmocka_unit_test(screen_finds_what_overlaps),
      cmocka_unit_test(screen_proves_no_more_than_holds),
      cmocka_unit_test(screen_counts_beyond_its_room),
      cmocka_unit_test(screen_of_nothing_finds_all_below_the_approach),
      cmocka_unit_test(parts_of_a_screen_and_known_lowest_gaps_change_nothing),
      cmocka_unit_test(tiles_known_to_lie_apart_are_not_looked_at),
  };
  return cmocka_run_group_tests_name("split", tests, nullptr, nullptr);
}
