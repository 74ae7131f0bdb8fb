#include "contact/memory/memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/grid.h"
#include "core/large_memory.h"

namespace rc {

namespace {

// suffix: of the names of rc_state's members, for messages.
CertifiedStep certified_step(const double* p, double approach, double load, const StepSurface& surface, std::int64_t points,
                             const char* suffix) {
  if (!p) return {};
  CertifiedStep step{{}, approach, load, true};
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

double Memory::ahead(const Step& step) const {
  if (step.p0.data || !step.warm || !last.same_gap || !before.same_gap) return 0;
  const bool by_load = step.target.by_load();
  const double newest = by_load ? last.load : last.approach, older = by_load ? before.load : before.approach;
  const double part = (step.target.value - newest) / (newest - older);
  // Pressures are not linear in the target: far ahead, or back beyond the older step, the line is a poor guess.
  return part >= -1 && part <= 2 ? part : 0;
}

std::vector<double> Memory::start(const Step& step, const TrialSet& trial, double pressure_unit, double cap,
                                  const Pressures* nearer, const rc_team& team) const {
  std::vector<double> p;
  if (nearer) {
    p = nearer->at(trial);
  } else if (step.p0.data) {
    p = large_vector<double>(static_cast<std::size_t>(trial.n));
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = value_at(step.p0, static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i))));
  } else if (step.warm && !last.pressures.empty()) {
    p = last.pressures.at(trial);
    if (const double part = ahead(step); part != 0) {
      const std::vector<double> older = before.pressures.at(trial);
      for (std::size_t i = 0; i < p.size(); ++i) p[i] += part * (p[i] - older[i]);
    }
  } else {
    return large_vector<double>(static_cast<std::size_t>(trial.n), team);
  }
  for (double& value : p) value = std::min(std::max(0.0, value / pressure_unit), cap);
  return p;
}

KeptSteps Memory::history(const Step& step) const {
  const bool from_last = !step.p0.data && step.warm && !last.pressures.empty();
  return {from_last ? last.kept : KeptAnswer{}, before.kept, ahead(step), {}};
}

std::vector<double> Memory::earlier(const Step& step, const TrialSet& trial) const {
  std::vector<double> p;
  for (std::int64_t i = 0; step.p0.data && i < trial.n; ++i)
    p.push_back(std::max(0.0, value_at(step.p0, static_cast<std::size_t>(trial.point(i)))));
  if (!step.p0.data && step.warm && !last.pressures.empty()) p = last.pressures.at(trial);
  return p;
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
