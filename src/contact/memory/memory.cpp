#include "contact/memory/memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/grid.h"

namespace rc {

namespace {

// suffix: of the names of rc_state's members, for messages.
CertifiedStep certified_step(const double* p, double approach, double load, const StepSurface& surface, std::int64_t points,
                             const char* suffix) {
  if (!p) return {};
  CertifiedStep step{{}, approach, load, true, {}, approach};
  for (const auto& [value, name] : {std::pair{approach, "approach"}, {load, "load"}})
    if (!std::isfinite(value)) fail(RC_ERR_ARGUMENT, "rc_state.", name, suffix, " = ", value, " is not finite");
  const std::int64_t nx = surface.points().nx();
  Pressures& pressures = step.pressures;
  for (std::int64_t i = 0; i < points; ++i) {
    if (!std::isfinite(p[i]))
      fail(RC_ERR_ARGUMENT, "rc_state.p", suffix, "[", i, "] = ", p[i], " is not finite (", place(i, nx), ")");
    if (p[i] == 0) continue;
    if (!surface.included(static_cast<std::size_t>(i)))
      fail(RC_ERR_ARGUMENT, "rc_state.p", suffix, "[", i, "] = ", p[i], " but this point is excluded by the mask (", place(i, nx),
           ")");
    pressures.on.index.push_back(i);
    pressures.p.push_back(p[i]);
  }
  if (pressures.empty()) {  // a step without contact also counts as a step
    pressures.on.index = {0};
    pressures.p = {0};
  }
  pressures.on.n = static_cast<std::int64_t>(pressures.p.size());
  if (pressures.on.n == points) pressures.on.index.clear();
  return step;
}

}  // namespace

void Memory::record(CertifiedStep&& step) {
  before = std::move(last);
  last = std::move(step);
}

void Memory::surface_is(bool same) {
  last.same_gap = last.same_gap && same;
  before.same_gap = before.same_gap && same;
  if (!same) ++surfaces;
}

void Memory::forget() {
  last = before = {};
  indented = false;
  outcome.certified = 0;
}

std::int64_t Memory::contact_points(std::int64_t room, std::int64_t* index, double* p) const {
  const Pressures& pressures = last.pressures;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < pressures.p.size(); ++k) {
    if (!(pressures.p[k] > 0)) continue;
    if (count < room && index) index[count] = pressures.on.point(static_cast<std::int64_t>(k));
    if (count < room && p) p[count] = pressures.p[k];
    ++count;
  }
  return count;
}

Memory memory_of(const rc_state& state, const StepSurface& surface, std::int64_t points) {
  return {
      certified_step(values_of<double>(state.p), state.approach, state.load, surface, points, ""),
      certified_step(values_of<double>(state.p_before), state.approach_before, state.load_before, surface, points, "_before")};
}

}  // namespace rc
