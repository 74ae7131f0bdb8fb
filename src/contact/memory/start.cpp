#include "contact/memory/start.h"

#include <algorithm>
#include <utility>

#include "core/array.h"
#include "core/large_memory.h"

namespace rc {

namespace {

double ahead_of(const Target& target, const CertifiedStep& last, const CertifiedStep& before) {
  if (!last.same_gap || !before.same_gap) return 0;
  const bool by_load = target.by_load();
  const double newest = by_load ? last.load : last.approach, older = by_load ? before.load : before.approach;
  const double part = (target.value - newest) / (newest - older);
  // Pressures are not linear in the target: far ahead, or back beyond the older step, the line is a poor guess.
  return part >= -1 && part <= 2 ? part : 0;
}

std::vector<double> scaled(std::vector<double> p, const AnswerUnits& units) {
  for (double& value : p) value = std::min(std::max(0.0, value / units.pressure), units.cap());
  return p;
}

}  // namespace

Start::Start(const Memory& memory, const Step& step)
    : memory_(&memory),
      given_(step.p0),
      warm_(step.warm),
      ahead_(given() || !warm_ ? 0 : ahead_of(step.target, memory.last, memory.before)) {}

Start Start::cold() const {
  Start start = *this;
  start.warm_ = false;
  start.ahead_ = 0;
  return start;
}

Start Start::from(const Memory& copies) const {
  Start start = *this;
  start.memory_ = &copies;
  if (!copies.last.same_gap || !copies.before.same_gap) start.ahead_ = 0;
  return start;
}

std::vector<double> Start::extrapolated(const TrialSet& trial) const {
  std::vector<double> p = last().pressures.at(trial);
  if (ahead_ == 0) return p;
  const std::vector<double> older = before().pressures.at(trial);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] += ahead_ * (p[i] - older[i]);
  return p;
}

std::vector<double> Start::pressures(const TrialSet& trial, const AnswerUnits& units, const rc_team& team) const {
  if (!given())
    return last().pressures.empty() ? large_vector<double>(static_cast<std::size_t>(trial.n), team)
                                    : scaled(extrapolated(trial), units);
  auto p = large_vector<double>(static_cast<std::size_t>(trial.n));
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = value_at(given_, static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i))));
  return scaled(std::move(p), units);
}

KeptSteps Start::kept() const {
  const bool from_last = !given() && !last().pressures.empty();
  return {from_last ? last().kept : KeptAnswer{}, memory_ ? memory_->before.kept : KeptAnswer{}, ahead_, {}};
}

std::vector<double> Start::earlier(const TrialSet& trial) const {
  if (!given()) return last().pressures.empty() ? std::vector<double>() : last().pressures.at(trial);
  std::vector<double> p;
  for (std::int64_t i = 0; i < trial.n; ++i)
    p.push_back(std::max(0.0, value_at(given_, static_cast<std::size_t>(trial.point(i)))));
  return p;
}

std::vector<double> dimensionless(const Pressures& estimate, const TrialSet& trial, const AnswerUnits& units) {
  return scaled(estimate.at(trial), units);
}

}  // namespace rc
