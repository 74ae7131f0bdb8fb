// The machine in its simplest form: plain loops on one thread. It defines what the passes in threads/ compute; tests compare the
// two.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "solvers/haar_cg/iteration/machine.h"
#include "solvers/haar_cg/plain/tree.h"

namespace rc {

template <class R> class PlainMachine {
 public:
  using Real = R;
  using Vector = std::vector<R>*;
  using Wide = std::vector<double>*;
  using Multiply = std::function<void(const std::vector<double>& x, std::vector<double>& y)>;  // y = H x

  // p: the pressures to start from. The trees cut the grid at different places.
  PlainMachine(std::vector<double> u, std::vector<double> p, double cap, Multiply multiply, PlainTree first, PlainTree second)
      : n_(u.size()),
        cap_(cap),
        u_(std::move(u)),
        p_(std::move(p)),
        wide_(n_),
        w_(n_),
        t_(n_),
        q_(n_),
        z_(n_),
        y_(n_),
        active_(n_, 1),
        multiply_(std::move(multiply)),
        trees_{std::move(first), std::move(second)} {}

  const std::vector<double>& pressures() const { return p_; }

  Vector w() { return &w_; }
  Vector t() { return &t_; }
  Vector q() { return &q_; }
  Vector z() { return &z_; }
  Vector y() { return &y_; }
  Wide p() { return &p_; }
  Wide wide_spare() { return &wide_; }

  // The product is computed in double precision and rounded to that of the vectors.
  template <class Value> void product(const std::vector<Value>* from, std::vector<Value>* to) {
    std::vector<double> y(n_);
    multiply_(std::vector<double>(from->begin(), from->end()), y);
    for (std::size_t i = 0; i < n_; ++i) (*to)[i] = static_cast<Value>(y[i]);
  }
  template <class Value> void raise(std::vector<Value>* x, double by) {
    for (Value& value : *x) value += static_cast<Value>(by);
  }
  template <class Value> double total(const std::vector<Value>* x) {
    double sum = 0;
    for (const Value value : *x) sum += static_cast<double>(value);
    return sum;
  }
  double inner(Vector a, Vector b) {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) sum += static_cast<double>((*a)[i]) * static_cast<double>((*b)[i]);
    return sum;
  }

  void set_up_trees(double surplus) {
    for (PlainTree& tree : trees_) tree.set_up(active_, surplus);
  }
  double apply_trees(Vector g, Vector q, double* level) {
    std::vector<double> loads(n_, 1.0), sum(n_, 0.0);
    if (g) std::copy(g->begin(), g->end(), loads.begin());
    if (level) {
      *level = total_of(loads) / total_of(std::vector<double>(n_, 1.0));
      for (double& load : loads) load -= *level;
    }
    for (const PlainTree& tree : trees_) tree.add(loads, 0.5, sum);
    for (std::size_t i = 0; i < n_; ++i) z_[i] = active_[i] ? static_cast<Real>(sum[i]) : 0;
    return q ? inner(&z_, q) : 0;
  }

  HaarStart begin() {
    HaarStart start{-std::numeric_limits<double>::infinity(), false};
    for (std::size_t i = 0; i < n_; ++i) {
      p_[i] = p_[i] >= nearly * cap_ ? cap_ : std::max(p_[i], 0.0);
      t_[i] = 0;
      active_[i] = 1;
      start.highest = std::max(start.highest, u_[i]);
      start.warm = start.warm || p_[i] > 0;
    }
    return start;
  }

  void multiply(double factor, bool free) {
    for (double& value : p_) value = !free ? value * factor : value < cap_ ? std::min(value * factor, cap_) : cap_;
  }

  void scale(double factor, bool after_cut) {
    for (std::size_t i = 0; i < n_; ++i) {
      const double next = p_[i] < cap_ ? std::min(factor * p_[i], cap_) : cap_;
      z_[i] = (after_cut ? z_[i] : 0) + static_cast<Real>(next - p_[i]);
      p_[i] = next;
    }
  }

  double turn(double beta) {
    for (std::size_t i = 0; i < n_; ++i) t_[i] = active_[i] ? z_[i] + static_cast<Real>(beta) * t_[i] : 0;
    return inner(&w_, &t_);
  }

  bool advance(double length, bool cut, bool keep) {
    bool any = false;
    for (std::size_t i = 0; i < n_; ++i) {
      const double next = p_[i] - length * static_cast<double>(t_[i]);
      w_[i] -= static_cast<Real>(length) * q_[i];
      p_[i] = cut ? std::clamp(next, 0.0, cap_) : next;
      if (!cut) continue;
      z_[i] = static_cast<Real>(p_[i] - next);
      any = any || z_[i] != 0;
    }
    for (std::size_t i = 0; keep && any && i < n_; i += haar_strip) keep_load(i, std::min(i + haar_strip, n_));
    return any;
  }
  void keep_load(std::size_t begin, std::size_t end) {
    double load = 0, added = 0, highest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      load += p_[i];
      added += static_cast<double>(z_[i]);
      highest = std::max(highest, p_[i]);
    }
    if (!(added > 0) || highest >= cap_) return;
    const double factor = std::max(1 - added / load, least_kept_share);
    for (std::size_t i = begin; i < end; ++i) {
      z_[i] += static_cast<Real>(factor * p_[i] - p_[i]);
      p_[i] *= factor;
    }
  }

  HaarMeasure add_and_measure(Vector change, double shift) {
    for (std::size_t i = 0; i < n_; ++i) w_[i] += (change ? (*change)[i] : 0) - static_cast<Real>(shift);
    return measure();
  }
  HaarMeasure grow_and_measure(double share) {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto w = static_cast<double>(w_[i]);
      w_[i] = static_cast<Real>(w + share * (w + u_[i]));
    }
    return measure();
  }
  HaarMeasure replace_and_measure(Wide product, double shift) {
    for (std::size_t i = 0; i < n_; ++i) w_[i] = static_cast<Real>((product ? (*product)[i] : 0) - u_[i] - shift);
    return measure();
  }

  bool choose_set(double threshold) {
    bool changed = false;
    for (std::size_t i = 0; i < n_; ++i) {
      const Real limit = static_cast<Real>(threshold);
      const std::uint8_t in = p_[i] >= cap_ ? w_[i] > limit : p_[i] > 0 || w_[i] < -limit;
      changed = changed || in != active_[i];
      active_[i] = in;
    }
    return changed;
  }

  double nearest(bool unpressed) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n_; ++i)
      if (unpressed ? p_[i] <= 0 : p_[i] >= cap_) least = std::min(least, std::abs(static_cast<double>(w_[i])));
    return least;
  }

 private:
  static constexpr double nearly = 1 - 1e-9;

  // 1'M g
  double total_of(const std::vector<double>& g) const {
    std::vector<double> sum(n_, 0.0);
    for (const PlainTree& tree : trees_) tree.add(g, 0.5, sum);
    double all = 0;
    for (std::size_t i = 0; i < n_; ++i) all += active_[i] ? sum[i] : 0;
    return all;
  }

  HaarMeasure measure() const {
    HaarMeasure sum;
    for (std::size_t i = 0; i < n_; ++i) {
      const auto w = static_cast<double>(w_[i]);
      const bool capped = p_[i] >= cap_;
      sum.largest = std::max(sum.largest, capped || (p_[i] > 0 && w > 0) ? w : -w);
      sum.load += p_[i];
      sum.merit += 0.5 * p_[i] * (w - u_[i]);
      sum.moment += p_[i] * w;
      sum.free_load += capped ? 0 : p_[i];
      sum.free_moment += capped ? 0 : p_[i] * w;
    }
    return sum;
  }

  const std::size_t n_;
  const double cap_;  // the largest pressure
  const std::vector<double> u_;
  std::vector<double> p_, wide_;
  std::vector<Real> w_, t_, q_, z_, y_;
  std::vector<std::uint8_t> active_;  // 1: in the free set
  const Multiply multiply_;
  PlainTree trees_[2];
};

}  // namespace rc
