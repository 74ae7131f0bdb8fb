// H of a scene in extended precision, by sums that share nothing with the backends.
#pragma once

#include <optional>
#include <vector>

#include "scene.h"

namespace fuzz {

using Real = long double;

/** [n*n] deflection of point i for unit pressure at j. Free boundaries: from the kernel's table. Periodic ones: by summing the
 *  waves, without their mean. Nothing where the kernel is not known or not for these cells. */
std::optional<std::vector<Real>> influence(const Scene& scene);

}  // namespace fuzz
