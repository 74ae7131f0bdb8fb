// Random patches of few points, and their exact laws by a method of their own.
#pragma once

#include <random>
#include <vector>

#include "patches.h"

namespace laws {

// Free, periodic, semi-periodic and a caller's matrix; single asperities and roughness with ties; masks; strips; every bulk.
// Plateaus where all points in contact carry the hardness.
struct SmallPatch {
  Patch patch;
  pairs::Field matrix;  // H
  double slack = 1e-9;  // relative error of H's own formula
};
SmallPatch small_patch(std::mt19937& generator, bool hard);
// 1 x 15 cells with two asperities, the second lower by `step`: one carries the hardness while the other touches.
SmallPatch two_asperities(double step, double tolerance);

// The answer at an approach, by an active set of its own on the dense matrix.
struct Exact {
  double x, p, slope;  // slope: with x = approach only
};
class ExactLaw {
 public:
  ExactLaw(const SmallPatch& small, const rc_law_info& info) : small_(small), info_(info) {}
  Exact at(double approach);

 private:
  const SmallPatch& small_;
  rc_law_info info_;
  std::vector<int> state_;  // 0 open, 1 in contact, 2 at the hardness; of the last answer
};

}  // namespace laws
