// The host program's floating-point mode changes no surface, statistics or file that is read, and stays as it was.
#include <roughcontact/formats.h>

#include <string>

#include "library.h"
#include "support/cmocka.hpp"
#include "support/host_modes.h"

using namespace surface_tests;

namespace {

using Values = std::vector<double>;

void append(Values& all, const Values& more) { all.insert(all.end(), more.begin(), more.end()); }

// Heights without a gap, less their plane.
Values read() {
  const std::string text = "# Width: 6 um\n# Height: 4 um\n# Value units: nm\n1 2 3\n4 5 9\n";
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  assert_int_equal(rc_surface_read_memory(text.data(), text.size(), "a.txt", nullptr, &file), RC_OK);
  Values heights(file.heights, file.heights + file.nx * file.ny);
  assert_int_equal(rc_surface_remove_form(file.nx, file.ny, 1, heights.data()), RC_OK);
  rc_surface_file_free(&file);
  return heights;
}

Values all_of_it() {
  const Grid waves = self_affine(1, 32, 0.8);
  const rc_surface_statistics found = statistics(waves);
  Values all = waves.z;
  append(all, midpoint(1, 5, 0.8).z);
  append(all, {found.rms_height, found.rms_slope, power_law(waves).hurst});
  append(all, read());
  return all;
}

void host_modes_change_nothing(void**) {
  const Values wanted = all_of_it();
  for (const support::Mode& mode : support::modes) {
    Values found;
    bool kept = false;
    {
      const support::InMode in_mode(mode);
      const support::Found given;
      found = all_of_it();
      kept = support::Found() == given;
    }
    if (!kept) fail_msg("a call leaves another mode than %s", mode.name);
    if (found != wanted) fail_msg("%s changes a value", mode.name);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(host_modes_change_nothing)};
  return cmocka_run_group_tests_name("surface.host_modes", tests, nullptr, nullptr);
}
