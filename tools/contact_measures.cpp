#include "contact_measures.h"

#include <roughcontact/analysis.h>

#include <algorithm>
#include <cmath>

#include "library.h"
#include "problem.h"

namespace cli {

ContactMeasures measure(const Problem& problem, const Fields& fields) {
  const std::uint8_t* const mask = problem.input.mask.empty() ? nullptr : problem.input.mask.data();
  ContactMeasures found;
  found.max_pressure = *std::ranges::max_element(fields.pressure);

  double sum = 0, count = 0;
  for (const double gap : fields.gap) {
    if (std::isnan(gap)) continue;
    sum += problem.system.hardness > 0 ? std::max(gap, 0.0) : gap;  // where the bodies yield, the overlap is closed
    ++count;
  }
  found.mean_gap = sum / count;

  rc_area area = RC_AREA_INIT;
  check(rc_area_measure(&problem.system, fields.pressure.data(), mask, &area), "");
  found.corrected_area = area.corrected_area;

  rc_patches patches = RC_PATCHES_INIT;
  check(rc_patches_find(&problem.system, fields.pressure.data(), mask, &patches), "");
  std::vector<double> areas(static_cast<std::size_t>(patches.count));
  patches.room = patches.count;
  patches.area = areas.data();
  check(rc_patches_find(&problem.system, fields.pressure.data(), mask, &patches), "");
  found.patches = patches.count;
  found.largest_patch = areas.empty() ? 0 : *std::ranges::max_element(areas);

  found.contact = find_crossing(problem, fields.pressure, true);
  found.gap = find_crossing(problem, fields.pressure, false);
  return found;
}

}  // namespace cli
