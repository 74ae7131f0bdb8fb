// Constrained conjugate gradients: Polonsky & Keer (1999), the corrected form of Bemporad & Paggi (2015), Algorithm 2.
//
// Changes to the printed algorithm: directions are restricted to the contact set and conjugate on it; every point (not only those
// of the contact set) is clipped and checked for overlap; and the stop test is the KKT residual. Pressures with a cap are clipped
// there as well, rest while the bodies overlap, and are released where a gap opens.
#include <algorithm>
#include <cmath>

#include "core/limits.h"
#include "core/stall.h"
#include "core/sums.h"
#include "solvers/residual.h"
#include "solvers/solver.h"

namespace rc::polonsky_keer {

namespace {

constexpr int refresh_every = 25;    // updates of H p between products that remove its drift
constexpr double progress = 0.9;     // the residual falls when it is below this share of its value at the last fall
constexpr int patience = 300;        // iterations without such a fall, after which the solver has stalled
constexpr double round_off = 1e-13;  // of a curvature t'Ht, relative to |t|^2 times the largest |H t| / |t| seen
constexpr double same_load = 1e-15;

class Iteration {
 public:
  Iteration(const Problem& problem, Vector& p, double& d)
      : problem_(problem), u_(problem.u()), n_(p.size()), cap_(problem.cap()), p_(p), d_(d), hp_(n_), t_(n_, 0.0), q_(n_) {
    clip(problem_, p_);
  }

  rc_status run() {
    start();
    return iterate();
  }

 private:
  bool is_free(std::size_t i) const { return p_[i] > 0 && p_[i] < cap_; }
  double gap(std::size_t i) const { return hp_[i] - u_[i] - approach_; }

  void refresh() {
    problem_.apply(p_, hp_);
    since_refresh_ = 0;
  }

  void start() {
    const bool warm = std::any_of(p_.begin(), p_.end(), [](double value) { return value > 0; });
    if (warm) refresh();
    if (problem_.load_control()) {
      if (!warm) {
        std::fill(p_.begin(), p_.end(), 1.0);
        refresh();
      }
      return balance();
    }
    // A start may have more energy than zero pressure, for instance after a much heavier step. It is then replaced by its
    // multiple of least energy, or by a multiple of the penetration if that would be zero.
    if (warm && 0.5 * dot(p_, hp_) <= dot_u(p_)) return;
    if (!warm || !(dot_u(p_) > 0)) {
      for (std::size_t i = 0; i < n_; ++i) p_[i] = std::max(u_[i], 0.0);
      refresh();
    }
    const double curvature = dot(p_, hp_);
    if (!(curvature > 0)) not_definite(curvature);
    rescale(dot_u(p_) / curvature);
    if (std::none_of(p_.begin(), p_.end(), [&](double value) { return value > cap_; })) return;
    clip(problem_, p_);
    refresh();
  }

  double dot(const Vector& a, const Vector& b) const {
    return sum_of(n_, [&](std::size_t i) { return a[i] * b[i]; });
  }
  double dot_u(const Vector& a) const {
    return sum_of(n_, [&](std::size_t i) { return a[i] * u_[i]; });
  }

  void rescale(double factor) {
    for (std::size_t i = 0; i < n_; ++i) {
      p_[i] *= factor;
      hp_[i] *= factor;
    }
  }

  // Load control: scales the pressures to the prescribed load.
  void balance() {
    if (!problem_.load_control()) return;
    const double sum = sum_of(n_, [&](std::size_t i) { return p_[i]; }), largest = *std::max_element(p_.begin(), p_.end());
    if (sum > 0 && largest < cap_ && largest * (problem_.load() / sum) <= cap_) return rescale(problem_.load() / sum);
    if (sum > 0 && std::abs(sum - problem_.load()) <= same_load * problem_.load()) return;
    if (!(sum > 0)) p_[static_cast<std::size_t>(std::max_element(u_, u_ + n_) - u_)] = problem_.load();
    scale_to_load(problem_, p_);
    refresh();
  }

  [[noreturn]] void not_definite(double curvature) const {
    if (std::isnan(curvature)) problem_.fail("polonsky-keer: the operator returned values that are not finite");
    problem_.fail("polonsky-keer: the operator is not positive definite: t'Ht <= 0 along a search direction t");
  }

  double residual() {
    const Residual present = residual_of(problem_, p_, hp_);
    approach_ = d_ = present.approach;
    return present.worst;
  }

  // Load control: the mean of a vector over the free points; a change of the approach absorbs it. Approach control: 0.
  double datum(const Vector& v, double count) const {
    return problem_.load_control() ? sum_of(n_, [&](std::size_t i) { return is_free(i) ? v[i] : 0.0; }) / count : 0.0;
  }

  // Makes the new direction conjugate to t: beta = -(g, H t) / (t, H t) on the free points, at least 0. While the set stays the
  // same this equals the paper's ratio of squared norms. After a change of the set it still holds for the part of t that remains.
  double conjugacy(double count) const {
    const double mean = datum(q_, count);
    const double overlap = sum_of(n_, [&](std::size_t i) { return is_free(i) ? gap(i) * (q_[i] - mean) : 0.0; });
    const double curvature = sum_of(n_, [&](std::size_t i) { return is_free(i) ? t_[i] * (q_[i] - mean) : 0.0; });
    return curvature > 0 ? std::max(0.0, -overlap / curvature) : 0;
  }

  // The direction t and the product q = H t; returns the step length along t, 0 if t gives none.
  double direction() {
    double count = 0, largest = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!is_free(i)) continue;
      count += 1;
      largest = std::max(largest, std::abs(gap(i)));
    }
    if (largest == 0) return 0;
    const double beta = conjugate_ ? conjugacy(count) : 0;
    for (std::size_t i = 0; i < n_; ++i) t_[i] = is_free(i) ? gap(i) + beta * t_[i] : 0;
    if (problem_.load_control()) {
      // A direction with sum 0 keeps the load.
      const double mean = datum(t_, count);
      for (std::size_t i = 0; i < n_; ++i)
        if (is_free(i)) t_[i] -= mean;
    }
    problem_.apply(t_, q_);
    const double slope = sum_of(n_, [&](std::size_t i) { return t_[i] * (is_free(i) ? gap(i) : 0.0); });
    const double curvature = dot(q_, t_);
    if (std::isnan(curvature)) not_definite(curvature);
    const double size = dot(t_, t_);
    steepest_ = std::max(steepest_, std::sqrt(dot(q_, q_) / size));
    if (curvature > round_off * steepest_ * size) return slope > 0 ? slope / curvature : 0;
    if (curvature < -round_off * steepest_ * size) not_definite(curvature);
    return first_bound();
  }

  // The step length along a direction without curvature, the mean of a periodic operator: until the first pressure vanishes
  // or meets the cap.
  double first_bound() const {
    double length = infinite;
    for (std::size_t i = 0; i < n_; ++i)
      if (is_free(i) && t_[i] != 0) length = std::min(length, t_[i] > 0 ? p_[i] / t_[i] : (p_[i] - cap_) / t_[i]);
    return length < infinite ? length : 0;
  }

  // Moves along t, clips at the bounds, admits points that overlap and releases those with a gap from the cap. True if the
  // contact set changed: H p must then be computed anew.
  bool step(double length) {
    if (length > 0) last_length_ = length;
    bool bounded = false;
    conjugate_ = length > 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const bool moved = is_free(i);
      if (moved) p_[i] -= length * t_[i];
      if (moved && is_free(i)) continue;
      bounded = bounded || moved;
      const bool at_cap = p_[i] > 0;
      p_[i] = at_cap ? cap_ : 0;
      if (at_cap ? gap(i) > 0 : gap(i) < 0) {
        // Half the cap at most: with more, points could go from bound to bound for ever.
        const double change = std::min(last_length_ * std::abs(gap(i)), 0.5 * cap_);
        p_[i] = at_cap ? cap_ - change : change;
        bounded = true;
      }
    }
    return bounded;
  }

  rc_status iterate() {
    Stall stalls(progress, patience);
    for (std::int64_t iteration = 0;; ++iteration) {
      double r = residual();
      if (r <= problem_.tol() && since_refresh_ > 0) {
        refresh();
        r = residual();
      }
      problem_.poll(iteration, r);
      if (r <= problem_.tol()) return RC_OK;
      if (stalls(r)) return RC_STOP_STALLED;

      const double length = direction();
      if (step(length) || ++since_refresh_ >= refresh_every) {
        refresh();
      } else {
        for (std::size_t i = 0; i < n_; ++i) hp_[i] -= length * q_[i];
      }
      balance();
    }
  }

  const Problem& problem_;
  const double* const u_;
  const std::size_t n_;
  const double cap_;        // 0 <= p <= cap
  Vector& p_;               // pressure
  double& d_;               // load control: the approach, an answer
  Vector hp_, t_, q_;       // H p, direction, H t
  double approach_ = 0;     // the gap is H p - u - approach; 0 in approach control, where u contains it
  double steepest_ = 0;     // largest |H t| / |t| seen
  double last_length_ = 1;  // the last positive step length, which admitted points take
  bool conjugate_ = false;  // the last step had a length, so the next direction is made conjugate to it
  int since_refresh_ = 0;
};

}  // namespace

const Options options{};

rc_status solve(const Problem& problem, Vector& p, double& d) { return Iteration(problem, p, d).run(); }

rc_status score(const rc_facts* facts, rc_estimate* estimate) {
  estimate->seconds = with_the_rest(*facts, iterating(*facts, 250));
  estimate->bytes = 5 * sizeof(double) * static_cast<double>(facts->n);
  return RC_OK;
}

}  // namespace rc::polonsky_keer
