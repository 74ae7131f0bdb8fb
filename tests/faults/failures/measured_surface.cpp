#include "measured_surface.h"

#include <roughcontact/surface.h>

#include <stdexcept>

#include "formats/surface.h"
#include "rough_surface.h"

namespace failures {

Problem measured_problem(const std::string& file) {
  const rc::formats::Surface surface = rc::formats::read_surface(file, {});
  Problem problem;
  problem.system.nx = surface.nx;
  problem.system.ny = surface.ny;
  problem.system.hx = surface.hx.value_or(1);
  problem.system.hy = surface.hy.value_or(1);
  problem.gap = gap_below_highest(surface.heights);
  problem.target = mean_of(problem.gap) / 2;
  return problem;
}

CmrVerdict cmr_verdict(const Problem& problem, std::int32_t halvings) {
  Field heights;
  heights.reserve(problem.gap.size());
  for (const double value : problem.gap) heights.push_back(-value);
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = problem.system.nx;
  map.ny = problem.system.ny;
  map.hx = problem.system.hx;
  map.hy = problem.system.hy;
  map.heights = heights.data();
  rc_surface_cmr advice{};
  advice.struct_size = sizeof advice;
  if (rc_surface_cmr_advice(&map, halvings, problem.target, &advice) != RC_OK) throw std::runtime_error(rc_surface_last_error());
  return {advice.trustworthy != 0, advice.unresolved};
}

}  // namespace failures
