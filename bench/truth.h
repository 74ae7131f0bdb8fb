// What is known of a contact, and errors against it.
#pragma once

#include "child.h"
#include "scene.h"

namespace bench {

struct Truth {
  double load = 0, area = 0;
  Field pressure;
};

// Relative errors: of load and contact area, and of the pressures in the L2 norm. The truth has pressures on the same grid.
struct RelativeErrors {
  double load = 0, area = 0, pressure = 0;
};
RelativeErrors errors_against(const Truth& truth, const Field& pressure, double load, double area);

// Means over blocks of cells: from fine x fine to n x n, fine a multiple of n.
Field block_means(const Field& values, std::int64_t fine, std::int64_t n);

}  // namespace bench
