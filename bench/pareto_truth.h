// What a scene's contact is: the approach for a share of cells in contact, and the solutions that others are measured against.
#pragma once

#include "pareto_scene.h"
#include "truth.h"

namespace bench {

// One contact of a scene.
struct ParetoCase {
  const ParetoScene& scene;
  double contact;  // wanted share of the cells
  double target;   // approach, or load in load control
};

// The approach at which a share of the cells of the scene's grid is in contact, to 2 %, by loose solves.
double search_approach(const ParetoScene& scene, double contact, std::int64_t threads);

// The certified solution on n x n cells.
struct CertifiedTruth {
  Truth truth;
  rc_result result{};
  double residual() const;
};
CertifiedTruth solve_certified(const ParetoCase& of, std::int64_t n, double tol, std::int64_t threads);

// What theory knows of the contact, completed by the solution on the finest grid, with pressures on as many cells as asked for.
class GridTruth {
 public:
  GridTruth(const ParetoCase& of, std::int64_t threads);
  Truth on(std::int64_t n) const;
  const char* source() const { return source_; }  // "analytic", "analytic load" or "finest grid"

 private:
  std::int64_t finest_;
  const char* source_;
  Truth truth_;  // pressures on the finest grid
};

}  // namespace bench
