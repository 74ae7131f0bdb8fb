// Alternating direction method of multipliers: Bemporad & Paggi (2015), Algorithm 5, with over-relaxation (Boyd et al.
// 2011, 3.4.3) and residual balancing (the rule of OSQP: Stellato et al. 2020, 5.2).
//
// The pressure is split in two. x solves (H + rho I) x = u + rho (z - v); in load control u + d stands for u, with d such that
// sum x = load. z is the projection of x + v on 0 <= z <= cap, and v is the sum of all x - z. At the solution -rho v is the gap
// w.
//
// Changes to the printed algorithm: the sign of its step 5.1; a penalty rho on the scale of the problem; a stop by the residual
// of z from its own product with H, because a small |x - z| alone does not mean a small residual.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/stall.h"
#include "core/sums.h"
#include "solvers/largest_eigenvalue.h"
#include "solvers/residual.h"
#include "solvers/solver.h"

namespace rc::admm {

namespace {

constexpr double progress = 0.9;                   // the residual falls when it is below this share of its value at the last fall
constexpr std::int64_t patience = 1000;            // iterations without such a fall, after which the solver has stalled
constexpr std::int64_t first_balance = 10;         // iteration; each later balance at twice the last, so that factors are reused
constexpr double imbalance = 2.5;                  // least factor by which rho changes
constexpr double floor_of_smallest = 1e-6;         // the smallest eigenvalue is taken as at least this share of the largest
constexpr double accuracy = 0.05;                  // tolerance of a linear solve, relative to the present residual
constexpr double finest = 1e-15, coarsest = 1e-3;  // limits of that tolerance

class Alternation {
 public:
  Alternation(const Problem& problem, Vector& p, double& d)
      : problem_(problem), u_(problem.u()), n_(p.size()), p_(p), d_(d), hp_(n_, 0.0), x_(n_), z_(n_), v_(n_), right_(n_) {
    clip(problem_, p_);
    scale_to_load(problem_, p_);
  }

  rc_status run() {
    const double relaxation = problem_.option_real("admm.relaxation");
    problem_.apply(p_, hp_);
    rescale();
    Residual residual = residual_of(problem_, p_, hp_);
    choose_penalty();
    x_ = z_ = p_;
    for (std::size_t i = 0; i < n_; ++i) {
      const double gap = hp_[i] - u_[i] - residual.approach;
      v_[i] = -(p_[i] < problem_.cap() ? std::max(0.0, gap) : std::min(0.0, gap)) / rho_;
    }

    Stall stalls(progress, patience);
    std::int64_t balance_at = first_balance;
    for (std::int64_t iteration = 0;; ++iteration) {
      d_ = residual.approach;
      problem_.poll(iteration, residual.worst);
      if (residual.worst <= problem_.tol()) return RC_OK;
      if (stalls(residual.worst)) return RC_STOP_STALLED;

      minimise(residual);
      Vector last = z_;
      for (std::size_t i = 0; i < n_; ++i) {
        const double relaxed = relaxation * x_[i] + (1 - relaxation) * z_[i];
        z_[i] = std::min(std::max(0.0, relaxed + v_[i]), problem_.cap());
        v_[i] += relaxed - z_[i];
      }
      if (std::any_of(z_.begin(), z_.end(), [](double value) { return value > 0; }) || !problem_.load_control()) {
        p_ = z_;
        scale_to_load(problem_, p_);
      }
      problem_.apply(p_, hp_);
      residual = residual_of(problem_, p_, hp_);
      if (iteration + 1 == balance_at) {
        balance_at *= 2;
        if (automatic_) balance(last, residual.approach);
      }
    }
  }

 private:
  // Replaces a warm start, which may belong to another approach, by its multiple of least energy.
  void rescale() {
    if (problem_.load_control()) return;
    const double work = sum_of(n_, [&](std::size_t i) { return u_[i] * p_[i]; });
    const double curvature = sum_of(n_, [&](std::size_t i) { return p_[i] * hp_[i]; });
    if (!(curvature > 0)) return;
    const double factor = std::max(work / curvature, 0.0);
    for (std::size_t i = 0; i < n_; ++i) {
      p_[i] *= factor;
      hp_[i] *= factor;
    }
    if (std::none_of(p_.begin(), p_.end(), [&](double value) { return value > problem_.cap(); })) return;
    clip(problem_, p_);
    problem_.apply(p_, hp_);
  }

  // The geometric mean of the extreme eigenvalues is the best penalty for a quadratic (Ghadimi et al. 2015).
  void choose_penalty() {
    rho_ = problem_.option_real("admm.rho");
    automatic_ = rho_ == 0;
    if (!automatic_) return;
    const double largest = largest_eigenvalue(problem_);
    if (!(largest > 0) || std::isinf(largest))
      problem_.fail("admm: the operator is not positive definite, or returned values that are not finite");
    const double smallest = problem_.lambda_min() > 0 ? problem_.lambda_min() : smallest_eigenvalue(problem_, largest);
    rho_ = std::sqrt(std::max(smallest, floor_of_smallest * largest) * largest);
  }

  void minimise(const Residual& residual) {
    double size = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      right_[i] = u_[i] + rho_ * (z_[i] - v_[i]) + (problem_.load_control() ? residual.approach : 0.0);
      size += right_[i] * right_[i];
    }
    double tol = coarsest;
    if (std::isfinite(residual.worst) && size > 0)
      tol = std::clamp(accuracy * residual.worst * residual.scale / std::sqrt(size), finest, coarsest);
    problem_.shifted(rho_, tol, right_, x_);
    if (!problem_.load_control()) return;
    // A change of the approach adds a multiple of (H + rho I)^-1 1 to x.
    if (rate_.empty()) {
      rate_.assign(n_, 1 / rho_);
      problem_.shifted(rho_, finest, Vector(n_, 1.0), rate_);
      rate_sum_ = sum_of(n_, [&](std::size_t i) { return rate_[i]; });
    }
    const double missing = problem_.load() - sum_of(n_, [&](std::size_t i) { return x_[i]; });
    for (std::size_t i = 0; i < n_; ++i) x_[i] += missing / rate_sum_ * rate_[i];
  }

  void balance(const Vector& last, double approach) {
    double primal = 0, dual = 0, size_p = 0, size_w = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      primal = std::max(primal, std::abs(x_[i] - z_[i]));
      dual = std::max(dual, rho_ * std::abs(z_[i] - last[i]));
      size_p = std::max({size_p, std::abs(x_[i]), z_[i]});
      size_w = std::max({size_w, std::abs(hp_[i]), rho_ * std::abs(v_[i]), std::abs(u_[i] + approach)});
    }
    if (!(primal > 0 && dual > 0 && size_p > 0 && size_w > 0)) return;
    const double ratio = std::sqrt((primal / size_p) / (dual / size_w));
    if (ratio < imbalance && ratio > 1 / imbalance) return;
    rho_ *= ratio;
    for (double& value : v_) value /= ratio;
    rate_.clear();
  }

  const Problem& problem_;
  const double* const u_;
  const std::size_t n_;
  Vector& p_;  // z; in load control of that load
  double& d_;
  Vector hp_, x_, z_, v_;  // H p; the unconstrained pressure; the one between its bounds; the sum of x - z
  Vector right_, rate_;    // right hand side; (H + rho I)^-1 1
  double rho_ = 0, rate_sum_ = 0;
  bool automatic_ = true;
};

constexpr rc_component relaxation = real_option("admm.relaxation", "1.7", 1, 1.95, "over-relaxation; 1: none");
constexpr rc_component rho = real_option(
    "admm.rho", "0", 0, 1e12, "penalty, relative to the contact modulus and the cell size; 0: from the eigenvalues of H");
const rc_component* const specs[] = {&relaxation, &rho};

}  // namespace

const Options options = listed(specs);

rc_status solve(const Problem& problem, Vector& p, double& d) { return Alternation(problem, p, d).run(); }

}  // namespace rc::admm
