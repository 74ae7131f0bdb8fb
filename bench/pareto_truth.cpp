#include "pareto_truth.h"

#include <algorithm>
#include <cmath>

#include "rough_surface.h"

namespace bench {

namespace {

constexpr double finest_tol = 1e-10;

rc_step step_of(const ParetoCase& of, const Field& gap) {
  rc_step step = RC_STEP_INIT;
  step.control = of.scene.control;
  step.target = of.target;
  step.gap = gap.data();
  step.borrow = 1;
  return step;
}

}  // namespace

double search_approach(const ParetoScene& scene, double contact, std::int64_t threads) {
  constexpr double loose = 1e-3, near_enough = 0.02;
  constexpr int most_halvings = 30;
  const Field gap = scene.gap(scene.n);
  Options options;
  options.set(RC_OPT_TOL, loose).set(RC_OPT_THREADS, static_cast<double>(threads));
  Contact solver(scene.system(scene.n), options);
  rc_step step = step_of({scene, contact, 0}, gap);
  const auto share_at = [&](double approach) {
    step.target = approach;
    const rc_result result = solver.solve(step);
    return static_cast<double>(result.contacts) / static_cast<double>(result.points);
  };
  double low = *std::min_element(gap.begin(), gap.end()), high = mean_of(gap);
  while (share_at(high) < contact) {
    const double width = high - low;
    low = high;
    high += 2 * width;
  }
  for (int k = 0; k < most_halvings; ++k) {
    const double middle = (low + high) / 2, share = share_at(middle);
    if (std::abs(share / contact - 1) < near_enough) return middle;
    (share < contact ? low : high) = middle;
  }
  return (low + high) / 2;
}

double CertifiedTruth::residual() const {
  return std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
}

CertifiedTruth solve_certified(const ParetoCase& of, std::int64_t n, double tol, std::int64_t threads) {
  Options options;
  options.set(RC_OPT_TOL, tol).set(RC_OPT_THREADS, static_cast<double>(threads));
  const Field gap = of.scene.gap(n);
  CertifiedTruth found;
  found.truth.pressure.resize(gap.size());
  found.result = Contact(of.scene.system(n), options).solve(step_of(of, gap), found.truth.pressure.data());
  found.truth.load = found.result.load;
  found.truth.area = found.result.contact_area;
  return found;
}

GridTruth::GridTruth(const ParetoCase& of, std::int64_t threads) : finest_(4 * of.scene.n), source_("finest grid") {
  if (of.scene.known) {
    const KnownContact known = of.scene.known(of.contact);
    source_ = known.pressure ? "analytic" : "analytic load";
    truth_ = {known.load, known.area, known.pressure ? known.pressure(finest_) : Field()};
    if (known.pressure) return;
  }
  CertifiedTruth solved = solve_certified(of, finest_, finest_tol, threads);
  if (of.scene.known)
    truth_.pressure = std::move(solved.truth.pressure);
  else
    truth_ = std::move(solved.truth);
}

Truth GridTruth::on(std::int64_t n) const { return {truth_.load, truth_.area, block_means(truth_.pressure, finest_, n)}; }

}  // namespace bench
