#include "solve/contact_measures.h"

#include <algorithm>

#include "library.h"
#include "solve/problem.h"

namespace cli {

ContactMeasures measure(const Problem& problem, const std::vector<double>& pressure) {
  const std::uint8_t* const mask = problem.input.mask;
  ContactMeasures found;
  rc_area area = RC_AREA_INIT;
  check(rc_area_measure(&problem.system, RC_IN(pressure.data()), RC_IN(mask), &area), "");
  found.corrected_area = area.corrected_area;

  rc_patches patches = RC_PATCHES_INIT;
  check(rc_patches_find(&problem.system, RC_IN(pressure.data()), RC_IN(mask), &patches), "");
  std::vector<double> areas(static_cast<std::size_t>(patches.count));
  patches.room = patches.count;
  patches.area = RC_OUT(areas.data());
  check(rc_patches_find(&problem.system, RC_IN(pressure.data()), RC_IN(mask), &patches), "");
  found.patches = patches.count;
  found.largest_patch = areas.empty() ? 0 : *std::ranges::max_element(areas);

  check(rc_crossing_find(&problem.system, RC_IN(pressure.data()), RC_IN(mask), &found.contact_crosses, &found.gap_crosses), "");
  return found;
}

}  // namespace cli
