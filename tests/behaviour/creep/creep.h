// Tables of bodies that creep, and the memory of their steps once more, by a full matrix.
#pragma once

#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/naive.h"
#include "support/surfaces.h"

namespace pairs {

inline constexpr double pi = std::numbers::pi;
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Table {
  Field ratio, time;
  std::int32_t by = RC_CREEP_COMPLIANCES;

  void give(rc_system& system) const {
    system.creep_by = by;
    system.creep_terms = static_cast<std::int32_t>(ratio.size());
    system.creep_ratio = RC_IN(ratio.data());
    system.creep_time = RC_IN(time.data());
  }
  double compliance(double t) const {
    double sum = 1;
    for (std::size_t k = 0; k < ratio.size(); ++k) sum += ratio[k] * (1 - std::exp(-t / time[k]));
    return sum;
  }
};

inline const Table one{{3}, {1}};
inline const Table two{{0.7, 2}, {0.3, 5}};

struct Step {
  double time, target;
};

// The memory of creep once more: H p and the delayed deflections, from a full matrix.
class Recursion {
 public:
  Recursion(const Problem& elastic, const Table& table)
      : elastic_(elastic), table_(table), matrix_(influence_matrix(elastic)), w_(elastic.points(), 0.0) {
    v_.assign(table.ratio.size(), w_);
  }

  // The elastic problem of the step: its modulus and its undeformed gap.
  Problem problem(const Step& step) const {
    Problem now = elastic_;
    double compliance = 1;
    for (std::size_t k = 0; k < v_.size(); ++k) {
      const auto [kept, before, part] = shares(step.time, k);
      compliance += table_.ratio[k] * part;
      for (std::size_t i = 0; i < w_.size(); ++i) now.gap[i] += table_.ratio[k] * (kept * v_[k][i] + before * w_[i]);
    }
    now.system.modulus /= compliance;
    now.target = step.target;
    return now;
  }
  void end(const Step& step, const Field& p) {
    const Field w = product(matrix_, p);
    for (std::size_t k = 0; k < v_.size(); ++k) {
      const auto [kept, before, part] = shares(step.time, k);
      for (std::size_t i = 0; i < w.size(); ++i) v_[k][i] = kept * v_[k][i] + before * w_[i] + part * w[i];
    }
    w_ = w;
    time_ = step.time;
  }
  const Field& elastic_deflection() const { return w_; }
  const std::vector<Field>& delayed() const { return v_; }

 private:
  struct Shares {
    double kept, before, now;
  };
  Shares shares(double time, std::size_t k) const {
    const double x = std::isnan(time_) ? 0 : (time - time_) / table_.time[k];
    if (x == 0) return {1, 0, 0};
    const double now = 1 - (1 - std::exp(-x)) / x;
    return {std::exp(-x), 1 - std::exp(-x) - now, now};
  }

  const Problem elastic_;
  const Table table_;
  const Field matrix_;
  Field w_;
  std::vector<Field> v_;
  double time_ = nan;
};

inline rc_step at(const Problem& problem, const Step& step) {
  rc_step asked = problem.step();
  asked.target = step.target;
  asked.time = step.time;
  return asked;
}

inline Problem creeping(Problem problem, const Table& table) {
  table.give(problem.system);
  return problem;
}

inline const Settings sharp = {{RC_OPT_TOL, "1e-11"}};

// Times of all sizes, pauses and jumps: an approach or load that rises, falls and rests.
inline std::vector<Step> path(double target) {
  return {{1, 0.6 * target}, {1, target},         {1.001, target}, {1.3, target},       {2, 0.8 * target},
          {2, 0.5 * target}, {2.5, 0.7 * target}, {9, target},     {500, 1.1 * target}, {500, 0.3 * target}};
}

inline Field creep_of(const Contact& contact, std::size_t values, double* time = nullptr) {
  Field said(values, -7);
  check(rc_contact_creep(contact.handle(), RC_OUT(said.data()), time) == RC_OK, rc_last_error());
  return said;
}

inline rc_state state_of(const Problem& problem, const Answer& answer, const Field& creep, double time) {
  rc_state state = RC_STATE_INIT;
  state.undeformed_gap = RC_IN(problem.gap.data());
  state.p = RC_IN(answer.p.data());
  state.approach = answer.result.approach;
  state.load = answer.result.load;
  state.creep = RC_IN(creep.data());
  state.time = time;
  return state;
}

inline rc_history history_of(const Problem& problem, const Field& targets, const Field& times, Field& loads) {
  rc_history history = RC_HISTORY_INIT;
  history.control = problem.control;
  history.n = static_cast<std::int64_t>(targets.size());
  history.targets = RC_IN(targets.data());
  history.times = RC_IN(times.data());
  history.undeformed_gap = RC_IN(problem.gap.data());
  history.columns.load = RC_OUT(loads.data());
  return history;
}

void bad_tables_are_refused();
void bad_calls_are_refused();

}  // namespace pairs
