#include "solvers/gradient_projection.h"

#include <algorithm>
#include <cmath>

#include "core/stall.h"
#include "core/sums.h"
#include "solvers/largest_eigenvalue.h"
#include "solvers/residual.h"

namespace rc::gradient_projection {

namespace {

constexpr double progress = 0.9;         // the residual falls when it is below this share of its value at the last fall
constexpr std::int64_t patience = 1000;  // iterations without such a fall, after which the solver has stalled
constexpr double visible = 1e-6;         // least size of a step, relative to p, whose curvature is above round-off

class Descent {
 public:
  Descent(const Problem& problem, Vector& p, double& d, const Settings& settings)
      : problem_(problem), settings_(settings), n_(p.size()), p_(p), d_(d), hp_(n_, 0.0), s_(n_), hs_(n_) {
    clip(problem_, p_);
    scale_to_load(problem_, p_);
  }

  rc_status run() {
    if (std::any_of(p_.begin(), p_.end(), [](double value) { return value > 0; })) problem_.apply(p_, hp_);
    Vector previous = p_, h_previous = hp_;
    Stall stalls(progress, patience);
    // H s is combined from products with p: the residual of p needs no product of its own.
    for (std::int64_t k = 0, i = 0; k < settings_.steps; ++k, ++i) {
      const Residual residual = residual_of(problem_, p_, hp_);
      d_ = residual.approach;
      if (settings_.polls) problem_.poll(k, residual.worst);
      if (residual.worst <= problem_.tol()) return RC_OK;
      if (stalls(residual.worst)) return RC_STOP_STALLED;

      const double beta = i < 2 ? 0 : (static_cast<double>(i) - 1) / (static_cast<double>(i) + 2);
      for (std::size_t j = 0; j < n_; ++j) {
        s_[j] = p_[j] + beta * (p_[j] - previous[j]);
        hs_[j] = hp_[j] + beta * (hp_[j] - h_previous[j]);
      }
      previous.swap(p_);
      h_previous.swap(hp_);
      for (std::size_t j = 0; j < n_; ++j) p_[j] = s_[j] - (hs_[j] - problem_.u()[j]) / settings_.lipschitz;
      project(problem_, p_);
      problem_.apply(p_, hp_);

      const double uphill = sum_of(n_, [&](std::size_t j) { return (s_[j] - p_[j]) * (p_[j] - previous[j]); });
      if ((settings_.restart && uphill > 0) || raise_lipschitz()) i = -1;
    }
    return RC_STOP_STALLED;
  }

 private:
  // Raises L if the curvature along the last step shows that the estimate was too small. Returns whether it did.
  bool raise_lipschitz() {
    const double size = sum_of(n_, [&](std::size_t j) { return (p_[j] - s_[j]) * (p_[j] - s_[j]); });
    const double curvature = sum_of(n_, [&](std::size_t j) { return (p_[j] - s_[j]) * (hp_[j] - hs_[j]); });
    if (!(size > visible * visible * sum_of(n_, [&](std::size_t j) { return p_[j] * p_[j]; }))) return false;
    if (curvature < -visible * settings_.lipschitz * size)
      problem_.fail("gp: the operator is not positive definite: t'Ht < 0 along a step t");
    if (curvature <= settings_.lipschitz * size) return false;
    settings_.lipschitz = 1.1 * curvature / size;
    return true;
  }

  const Problem& problem_;
  Settings settings_;
  const std::size_t n_;
  Vector& p_;
  double& d_;
  Vector hp_, s_, hs_;  // H p, the extrapolated point, H s
};

constexpr rc_component lipschitz = text_option("gp.lipschitz", "collatz", "collatz|frobenius",
                                               "step length from a tight bound of the largest eigenvalue (collatz) or from the "
                                               "Frobenius norm, as published, where the backend has it");
constexpr rc_component restart =
    int_option("gp.restart", "1", 0, 1, "1: the acceleration starts afresh where it points uphill; 0: never, as published");
const rc_component* const specs[] = {&lipschitz, &restart};

}  // namespace

const Options options = listed(specs);

rc_status descend(const Problem& problem, Vector& p, double& d, Settings settings) {
  return Descent(problem, p, d, settings).run();
}

rc_status solve(const Problem& problem, Vector& p, double& d) {
  Settings settings;
  settings.restart = problem.option_int("gp.restart") != 0;
  const bool frobenius = problem.option_text("gp.lipschitz") == "frobenius";
  if (frobenius && !problem.has_norm()) problem.note("gp: this backend has no Frobenius norm, gp.lipschitz = collatz instead");
  settings.lipschitz = frobenius && problem.has_norm() ? problem.norm() : largest_eigenvalue(problem);
  if (!(settings.lipschitz > 0) || std::isinf(settings.lipschitz))
    problem.fail("gp: the operator is not positive definite, or returned values that are not finite");
  return descend(problem, p, d, settings);
}

}  // namespace rc::gradient_projection
