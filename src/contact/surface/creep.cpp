#include "contact/surface/creep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/chunks.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr double short_step = 0.01;  // over a term's time, below which 1 - (1 - exp(-x))/x is summed up

CreepStep::Shares shares_of(double x) {
  if (x == 0) return {};
  const double lost = -std::expm1(-x);
  const double now = x < short_step ? x * (1 / 2. - x * (1 / 6. - x * (1 / 24. - x * (1 / 120. - x / 720)))) : 1 - lost / x;
  return {1 - lost, lost - now, now};
}

// act(i) for each point.
template <class Act> void each_point(std::size_t n, const rc_team& team, const Act& act) {
  each_chunk(static_cast<std::int64_t>(n), team, [&](std::int64_t begin, std::int64_t count) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i) act(i);
  });
}

}  // namespace

Creep::Creep(const std::vector<PronyTerm>& terms, std::span<const double> values, double time) : terms_(terms) {
  if (std::isnan(time)) return;
  if (!std::isfinite(time)) fail(RC_ERR_ARGUMENT, "rc_state.time = ", time, " is not finite");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) fail(RC_ERR_ARGUMENT, "rc_state.creep[", i, "] = ", values[i], " is not finite");
  begun_ = true;
  time_ = time;
  const std::size_t n = values.size() / (terms.size() + 1);
  elastic_.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::size_t k = 1; k <= terms.size(); ++k) {
    const std::span<const double> of = values.subspan(k * n, n);
    delayed_.emplace_back(of.begin(), of.end());
  }
}

CreepStep Creep::step_to(double time) const {
  if (none()) return {};
  if (!std::isfinite(time)) fail(RC_ERR_ARGUMENT, "rc_step.time = ", time, " is not finite");
  CreepStep step{.time = time};
  if (!begun_) {
    step.shares.resize(terms_.size());
    return step;
  }
  if (time < time_)
    fail(RC_ERR_ARGUMENT, "rc_step.time = ", time, " is before ", time_,
         ", the time of the last certified step; bodies that creep have no way back: restore or reset the contact");
  for (const PronyTerm& term : terms_) {
    step.shares.push_back(shares_of((time - time_) / term.time));
    step.compliance += term.ratio * step.shares.back().now;
  }
  return step;
}

void Creep::put_into(std::span<double> gap, const CreepStep& step, const rc_team& team) const {
  if (!begun_) return;
  double of_elastic = 0;
  for (std::size_t k = 0; k < terms_.size(); ++k) of_elastic += terms_[k].ratio * step.shares[k].before;
  each_point(gap.size(), team, [&](std::size_t i) {
    double left = of_elastic * elastic_[i];
    for (std::size_t k = 0; k < terms_.size(); ++k) left += terms_[k].ratio * step.shares[k].kept * delayed_[k][i];
    gap[i] = (gap[i] + left) / step.compliance;
  });
}

void Creep::settle(const rc_team& team) {
  if (!ended_) return;
  if (!begun_) {
    delayed_.assign(terms_.size(), std::vector<double>(next_.size(), 0.0));
  } else {
    each_point(next_.size(), team, [&](std::size_t i) {
      for (std::size_t k = 0; k < terms_.size(); ++k) {
        const CreepStep::Shares& of = step_.shares[k];
        delayed_[k][i] = of.kept * delayed_[k][i] + of.before * elastic_[i] + of.now * next_[i];
      }
    });
  }
  elastic_ = std::move(next_);
  next_ = {};
  time_ = step_.time;
  begun_ = true;
  ended_ = false;
}

void Creep::write(std::span<double> to, const rc_team& team) const {
  if (empty()) {
    std::ranges::fill(to, 0.0);
    return;
  }
  Creep settled = *this;
  settled.settle(team);
  auto at = std::ranges::copy(settled.elastic_, to.begin()).out;
  for (const std::vector<double>& each : settled.delayed_) at = std::ranges::copy(each, at).out;
}

}  // namespace rc
