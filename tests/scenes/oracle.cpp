#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace scenes {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

constexpr std::size_t few = 40;  // points

enum class At : char { zero, loose, cap };

struct State {
  std::vector<At> at;
  std::vector<std::size_t> set;
  Reals p;
};

// p of the set, for the states of the other points.
std::optional<Factor> settle(const Influence& h, const Reals& u, Real cap, Real datum, State& state) {
  const std::size_t n = u.size();
  state.set.clear();
  state.p.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (state.at[i] == At::loose) state.set.push_back(i);
    if (state.at[i] == At::cap) state.p[i] = cap;
  }
  auto factor = Factor::of(h, state.set, datum);
  if (!factor) return factor;
  for (int round = 0; round < 3; ++round) {  // a solve and two refinements
    const Real mean = datum * std::accumulate(state.p.begin(), state.p.end(), Real{0});
    Reals right;
    for (const std::size_t i : state.set) {
      Real rest = u[i] - mean;
      for (std::size_t j = 0; j < n; ++j)
        if (state.p[j] != 0) rest -= h(i, j) * state.p[j];
      right.push_back(rest);
    }
    const Reals change = factor->solve(right);
    for (std::size_t k = 0; k < change.size(); ++k) state.p[state.set[k]] += change[k];
  }
  return factor;
}

// Which points contradict their states.
std::vector<std::size_t> contradicting(const Influence& h, const Reals& u, const std::vector<bool>& open, Real cap, Real datum,
                                       const State& state, Reals& w) {
  const std::size_t n = u.size();
  const Real most = *std::ranges::max_element(state.p), mean = datum * std::accumulate(state.p.begin(), state.p.end(), Real{0});
  std::vector<std::size_t> wrong;
  w.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    Real size = std::abs(u[i]) + std::abs(mean);
    w[i] = mean - u[i];
    for (std::size_t j = 0; j < n; ++j)
      if (state.p[j] != 0) {
        w[i] += h(i, j) * state.p[j];
        size += std::abs(h(i, j) * state.p[j]);
      }
    if (!open[i]) continue;
    const Real slack = 1e3L * epsilon;
    if (state.at[i] == At::loose ? state.p[i] < -slack * most || state.p[i] > cap + slack * most
                                 : (state.at[i] == At::zero ? -w[i] : w[i]) > slack * size)
      wrong.push_back(i);
  }
  return wrong;
}

void judge(const Influence& h, const std::vector<bool>& open, Real cap, Real noise, const Factor& factor, const State& state,
           Exact& exact) {
  const std::size_t n = state.p.size();
  exact.p = state.p;
  exact.loose = state.set;
  exact.inverse = state.set.empty() ? 0 : factor.inverse_norm();
  const Real most = std::max<Real>(0, *std::ranges::max_element(exact.p));
  noise += double_product * h.largest_row() * most;
  exact.error = exact.inverse * noise + 1e3L * epsilon * most;
  bool tie = false;
  for (std::size_t i = 0; i < n; ++i) {
    exact.p[i] = std::min(std::max<Real>(exact.p[i], 0), cap);
    if (!open[i]) continue;
    const bool loose = state.at[i] == At::loose;
    const bool free_of_zero = loose && exact.p[i] > exact.error, free_of_cap = loose && exact.p[i] < cap - exact.error;
    const bool surely_open = state.at[i] == At::zero && exact.w[i] > 4 * noise;
    const bool surely_capped = state.at[i] == At::cap && exact.w[i] < -4 * noise;
    tie = tie || !((free_of_zero && free_of_cap) || surely_open || surely_capped);
    exact.contacts += free_of_zero || (state.at[i] == At::cap && cap > exact.error);
    exact.contacts_possible += !surely_open;
    exact.capped += surely_capped;
    exact.capped_possible += state.at[i] == At::cap || (loose && !free_of_cap);
  }
  exact.worth = exact.error > 1e-6L * most && most > 0 ? Worth::soft : tie ? Worth::ties : Worth::exact;
}

}  // namespace

std::optional<Factor> Factor::of(const Influence& h, const std::vector<std::size_t>& set, Real datum) {
  Factor made;
  made.m_ = set.size();
  made.factor_.resize(made.m_ * made.m_);
  auto& f = made.factor_;
  const std::size_t m = made.m_;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = h(set[i], set[j]) + datum;
      for (std::size_t k = 0; k < j; ++k) sum -= f[i * m + k] * f[j * m + k];
      if (i == j) {
        if (!(sum > 1e3L * epsilon * static_cast<Real>(m) * (h(set[i], set[i]) + datum))) return {};
        f[i * m + i] = std::sqrt(sum);
      } else {
        f[i * m + j] = sum / f[j * m + j];
      }
    }
  return made;
}

Reals Factor::solve(Reals x) const {
  for (std::size_t i = 0; i < m_; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= factor_[i * m_ + k] * x[k];
    x[i] /= factor_[i * m_ + i];
  }
  for (std::size_t i = m_; i-- > 0;) {
    for (std::size_t k = i + 1; k < m_; ++k) x[i] -= factor_[k * m_ + i] * x[k];
    x[i] /= factor_[i * m_ + i];
  }
  return x;
}

Real Factor::inverse_norm() const {
  const auto norm = [](const Reals& v) {
    return std::accumulate(v.begin(), v.end(), Real{0}, [](Real sum, Real x) { return sum + std::abs(x); });
  };
  Real best = 0;
  const auto column = [&](std::size_t at) {
    Reals unit(m_, 0);
    unit[at] = 1;
    return solve(unit);
  };
  if (m_ <= few) {
    for (std::size_t k = 0; k < m_; ++k) best = std::max(best, norm(column(k)));
    return best;
  }
  Reals y = solve(Reals(m_, 1 / static_cast<Real>(m_)));
  for (int round = 0; round < 5 && norm(y) > best; ++round) {
    best = norm(y);
    Reals sign(m_);
    std::ranges::transform(y, sign.begin(), [](Real v) { return v < 0 ? Real{-1} : Real{1}; });
    const Reals z = solve(sign);
    y = column(static_cast<std::size_t>(std::ranges::max_element(z, {}, [](Real v) { return std::abs(v); }) - z.begin()));
  }
  return 3 * best;
}

// Principal pivoting in blocks, by Murty's rule where these do not end (Portugal, Judice & Vicente 1994).
Exact solve_exactly(const Influence& h, const Reals& u, const std::vector<bool>& open, Real cap, Real noise, Real datum) {
  const std::size_t n = u.size();
  Exact exact;
  State state, before;
  state.at.assign(n, At::zero);
  for (std::size_t i = 0; i < n; ++i)
    if (open[i] && u[i] > 0) state.at[i] = At::loose;
  std::vector<std::size_t> wrong;
  std::size_t fewest = n + 1;
  int blocks_left = 8;
  for (std::size_t pass = 0; pass < 200 + 4 * n; ++pass) {
    const auto factor = settle(h, u, cap, datum, state);
    if (!factor) {
      if (wrong.size() < 2) return exact;
      state = before;
      blocks_left = 0;
    } else {
      wrong = contradicting(h, u, open, cap, datum, state, exact.w);
      if (wrong.empty()) {
        judge(h, open, cap, noise, *factor, state, exact);
        for (std::size_t i = 0; i < n; ++i) {
          exact.sum += exact.p[i];
          exact.functional += exact.p[i] * (exact.w[i] - u[i]) / 2;
        }
        for (const Real x : factor->solve(Reals(state.set.size(), 1))) exact.stiffness += x;
        return exact;
      }
      blocks_left = wrong.size() < fewest ? 8 : blocks_left - 1;
      fewest = std::min(fewest, wrong.size());
    }
    if (blocks_left <= 0) wrong = {wrong.back()};
    before = state;
    for (const std::size_t i : wrong) state.at[i] = state.at[i] != At::loose ? At::loose : state.p[i] > 0 ? At::cap : At::zero;
  }
  return exact;
}

Exact exact_at(const Scene& scene, const Influence& h, const Surface& surface, const Field& indentation, double approach,
               std::optional<double> load) {
  const std::size_t n = scene.points();
  std::vector<bool> open(n);
  Reals u(n, 0);
  const bool tied = load && scene.periodic();
  const Real datum = tied ? h(0, 0) : 0, cell = static_cast<Real>(scene.system.hx) * static_cast<Real>(scene.system.hy);
  Real size = std::abs(static_cast<Real>(approach));
  for (std::size_t i = 0; i < n; ++i) {
    open[i] = surface.included(i);
    if (!open[i]) continue;
    const Real gap = static_cast<Real>(surface.gap[i]) + (indentation.empty() ? 0 : static_cast<Real>(indentation[i]));
    u[i] = static_cast<Real>(approach) - gap + (tied ? datum * static_cast<Real>(*load) / cell : 0);
    size = std::max({size, std::abs(gap), std::abs(u[i])});
  }
  const Real cap = scene.hard() ? static_cast<Real>(scene.system.hardness) : std::numeric_limits<Real>::infinity();
  return solve_exactly(h, u, open, cap, 1e-14L * size, datum);
}

}  // namespace scenes
