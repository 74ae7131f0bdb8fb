// Properties of bodies that creep: the scene's first step, held for a while and changed, has the whole convolution over its past.
#include <algorithm>
#include <array>
#include <cmath>

#include "property.h"

namespace scenes {

namespace {

class Creeps final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (scene.large()) return "many points";
    if (scene.control == RC_CONTROL_AREA) return "control by area";
    Random random(scene.seed, 700);
    for (std::int64_t k = random.between(1, 3); k > 0; --k) {
      ratio_.push_back(random.decades(-1, 1));
      tau_.push_back(random.decades(-2, 2));
    }
    rc_system system = c.system();
    system.creep_terms = static_cast<std::int32_t>(ratio_.size());
    system.creep_ratio = RC_IN(ratio_.data());
    system.creep_time = RC_IN(tau_.data());
    rc_contact* made = nullptr;
    if (rc_contact_create(&system, c.options().get(), &made) == RC_ERR_INCOMPATIBLE) return "refused";
    need(made != nullptr, std::string("rc_contact_create: ") + rc_last_error());
    const Handle contact(made);
    rc_step step = c.step(scene.steps.front());
    for (int k = 0; k < 4; ++k) {
      step.time = k == 0 ? random.uniform(-1, 1) : step.time + random.decades(-1, 1);
      if (k > 0 && scene.by_load()) step.target = scene.steps.front().target * random.uniform(0.3, 1);
      const StepAnswer answer = c.solve(contact.get(), step);
      if (answer.status == RC_ERR_INCOMPATIBLE) return "refused";
      if (answer.status != RC_OK) break;
      time_.push_back(static_cast<Real>(step.time));
      target_.push_back(step.target);
      kept_.push_back(answer);
      step.p0 = {};
      step.warm_start = 1;
    }
    return kept_.size() < 2 ? "not certified" : "";
  }
  Verdict judge(const Case& c) const override {
    for (std::size_t k = 0; k < kept_.size(); ++k) judge_step(c, k);
    return Verdict::held;
  }
  // A first step that lasted longer, or an approach that is off.
  bool spoil(const Case& c, Random& random) override {
    const StepAnswer& first = kept_.front();
    const double size = static_cast<double>(c.h()(0, 0)) * first.result.max_pressure;
    if (!(size > 1e6 * static_cast<double>(noise(c)))) return false;
    if (random.chance(0.5))
      time_.front() -= 0.1L * (time_[1] - time_[0]) + 0.1L * static_cast<Real>(*std::ranges::max_element(tau_));
    else
      kept_.back().result.approach += 1e-3 * size;
    return true;
  }

 private:
  Real creep(Real t) const {  // J/J0 - 1
    Real sum = 0;
    for (std::size_t k = 0; k < tau_.size(); ++k)
      sum -= static_cast<Real>(ratio_[k]) * std::expm1(-t / static_cast<Real>(tau_[k]));
    return sum;
  }
  // The mean of that over t - to .. t - from.
  Real mean_creep(Real t, Real from, Real to) const {
    Real sum = 0;
    for (std::size_t k = 0; k < tau_.size(); ++k) {
      const Real tau = static_cast<Real>(tau_[k]), x = (to - from) / tau;
      sum += static_cast<Real>(ratio_[k]) * (1 + std::exp((to - t) / tau) * std::expm1(-x) / x);
    }
    return sum;
  }
  Real noise(const Case& c) const {
    Real most = 0;
    for (const StepAnswer& answer : kept_) most = std::max(most, product_noise(c, c.surface(0), answer));
    return 4 * (1 + creep(HUGE_VALL)) * most;
  }
  void judge_step(const Case& c, std::size_t k) const {
    const StepAnswer& answer = kept_[k];
    const std::size_t n = answer.p.size();
    Reals past(n);  // pressures whose elastic deflection is what creep adds
    for (std::size_t i = 0; i < n; ++i) {
      past[i] = creep(time_[k] - time_[0]) * static_cast<Real>(kept_[0].p[i]);
      for (std::size_t m = 1; m <= k; ++m)
        past[i] += mean_creep(time_[k], time_[m - 1], time_[m]) *
                   (static_cast<Real>(kept_[m].p[i]) - static_cast<Real>(kept_[m - 1].p[i]));
      past[i] += static_cast<Real>(answer.p[i]);
    }
    const Reals deflected = c.h().times(past);
    const Surface& surface = c.surface(0);
    const Real rounding = noise(c), tol = (1 + 1e-6L) * static_cast<Real>(answer.result.tolerance);
    Surface left = surface;
    const Reals own = c.h().times(Reals(answer.p.begin(), answer.p.end()));
    const Real now = 1 + (k == 0 ? 0 : mean_creep(time_[k], time_[k - 1], time_[k]));
    for (std::size_t i = 0; i < n; ++i) left.gap[i] += static_cast<double>(deflected[i] - now * own[i]);
    const Real allowed = tol * now * residual_scale(c.scene(), left, answer, target_[k]) + rounding;
    const Real most = *std::ranges::max_element(answer.p);
    for (std::size_t i = 0; i < n; ++i) {
      if (!surface.included(i)) continue;
      const Real gap = static_cast<Real>(surface.gap[i]) - static_cast<Real>(answer.result.approach) + deflected[i] +
                       (answer.indentation.empty() ? 0 : static_cast<Real>(answer.indentation[i]));
      const std::string where = " at point " + std::to_string(i) + " of step " + std::to_string(k);
      need(std::abs(gap - static_cast<Real>(answer.gap[i])) <= rounding,
           "the gap is off by " + number(gap - static_cast<Real>(answer.gap[i])) + where);
      const Real p = answer.p[i];
      need(gap >= -allowed || p >= c.cap() * (1 - tol), "overlap " + number(gap) + where);
      need(p <= tol * most || gap <= allowed, "pressure across the gap " + number(gap) + where);
    }
  }

  Field ratio_, tau_, target_;
  Reals time_;
  std::vector<StepAnswer> kept_;
};

constexpr std::array kinds_of_creep{Kind{"creep", 4, 2, 0.7, 0, made<Creeps>}};

}  // namespace

std::span<const Kind> properties_of_creep() { return kinds_of_creep; }

}  // namespace scenes
