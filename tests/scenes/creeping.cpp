// Properties of bodies that creep: the scene's first step, held for a while and changed, has the whole convolution over its past.
// A history, a batch and a contact that is restored on the way give the same steps.
#include <roughcontact/history.h>

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
    Random random(scene.seed, 700);
    for (std::int64_t k = random.between(1, 3); k > 0; --k) {
      ratio_.push_back(random.chance(0.1) ? 0 : random.decades(-1, 1));
      tau_.push_back(random.decades(-2, 2));
    }
    rc_system system = c.system();
    system.creep_terms = static_cast<std::int32_t>(ratio_.size());
    system.creep_ratio = RC_IN(ratio_.data());
    system.creep_time = RC_IN(tau_.data());
    const pairs::Options options = c.options({{"resumable", "1"}});
    rc_contact* made = nullptr;
    const auto opened = [&] {
      made = nullptr;
      const rc_status status = rc_contact_create(&system, options.get(), &made);
      need(made || status == RC_ERR_INCOMPATIBLE, std::string("rc_contact_create: ") + rc_last_error());
      return Handle(made);
    };
    const Handle contact = opened();
    if (!contact) return "refused";
    const Step& first = scene.steps.front();
    rc_step step = c.step(first);
    double lowest = HUGE_VAL;
    for (std::size_t i = 0; i < scene.points(); ++i)
      if (c.surface(0).included(i)) lowest = std::min(lowest, c.surface(0).gap[i]);
    for (int k = 0; k < 4; ++k) {
      step.time = k == 0 ? random.uniform(-1, 1) : step.time + (random.chance(0.1) ? 0 : random.decades(-1, 1));
      const double datum = scene.control == RC_CONTROL_APPROACH ? lowest : 0;
      if (k > 0) step.target = datum + (first.target - datum) * random.uniform(0.3, 1);
      const StepAnswer answer = c.solve(contact.get(), step);
      if (answer.status == RC_ERR_INCOMPATIBLE) return "refused";
      if (answer.status != RC_OK) break;
      time_.push_back(static_cast<Real>(step.time));
      target_.push_back(step.target);
      kept_.push_back(answer);
      left_.push_back(memory(c, contact.get(), step.time));
      step.p0 = {};
      step.warm_start = 1;
    }
    if (kept_.size() < 2) return "not certified";
    if (first.p0.empty()) follow(c, opened().get(), system, options.get());
    const Handle restored = opened();
    const std::size_t k = kept_.size() - 2;
    rc_state state = state_after(kept_, k, c.surface(0), k > 0);
    state.creep = RC_IN(left_[k].data());
    state.time = static_cast<double>(time_[k]);
    need(rc_contact_restore(restored.get(), &state) == RC_OK, std::string("rc_contact_restore: ") + rc_last_error());
    step.target = target_.back();
    step.time = static_cast<double>(time_.back());
    restored_ = c.solve(restored.get(), step);
    return "";
  }
  Verdict judge(const Case& c) const override {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      judge_step(c, k);
      judge_memory(c, k);
    }
    for (std::size_t k = 0; k < loads_.size(); ++k)
      need(loads_[k] == kept_[k % kept_.size()].result.load, "a history or batch that creeps has another load");
    need(loads_.empty() || p_ == kept_.back().p, "a batch that creeps ends with other pressures");
    need(restored_.p == kept_.back().p && restored_.result.approach == kept_.back().result.approach &&
             restored_.result.energy == kept_.back().result.energy,
         "a restored contact that creeps goes on elsewhere");
    return Verdict::held;
  }
  // A first step that lasted longer, or an approach that is off.
  bool spoil(const Case& c, Random& random) override {
    const StepAnswer& first = kept_.front();
    const double size = static_cast<double>(c.h()(0, 0)) * first.result.max_pressure;
    if (!(size > 1e6 * static_cast<double>(noise(c))) || creep(HUGE_VALL) == 0 || time_[1] == time_[0]) return false;
    if (random.chance(0.2))
      restored_.p.front() = std::nextafter(restored_.p.front(), HUGE_VAL);
    else if (random.chance(0.2))
      left_.back().back() += 1e-3 * size;
    else if (random.chance(0.5))
      time_.front() -= 0.1L * (time_[1] - time_[0]) + 0.1L * static_cast<Real>(*std::ranges::max_element(tau_));
    else
      kept_.back().result.approach += 1e-3 * size;
    return true;
  }

 private:
  // H p and the delayed deflections of each term.
  Field memory(const Case& c, rc_contact* contact, double time) const {
    Field said((tau_.size() + 1) * c.scene().points());
    double at = HUGE_VAL;
    need(rc_contact_creep(contact, RC_OUT(said.data()), &at) == RC_OK && at == time, "the time of the memory");
    return said;
  }

  void follow(const Case& c, rc_contact* contact, const rc_system& system, const rc_options* options) {
    const std::size_t steps = kept_.size();
    const Field times(time_.begin(), time_.end());
    const Surface& surface = c.surface(0);
    loads_.assign(2 * steps, -7);
    p_.resize(c.scene().points());
    rc_history history = RC_HISTORY_INIT;
    history.control = c.scene().control;
    history.n = static_cast<std::int64_t>(steps);
    history.targets = RC_IN(target_.data());
    history.times = RC_IN(times.data());
    history.undeformed_gap = RC_IN(surface.gap.data());
    history.mask = RC_IN(surface.mask.empty() ? nullptr : surface.mask.data());
    history.columns.load = RC_OUT(loads_.data());
    need(rc_contact_solve_history(contact, &history) == RC_OK, std::string("rc_contact_solve_history: ") + rc_last_error());
    need(memory(c, contact, times.back()) == left_.back(), "a history leaves another memory");
    rc_batch batch = RC_BATCH_INIT;
    batch.control = history.control;
    batch.n = 1;
    batch.steps = history.n;
    batch.targets = history.targets;
    batch.times = history.times;
    batch.undeformed_gap = history.undeformed_gap;
    batch.mask = history.mask;
    batch.p = RC_OUT(p_.data());
    batch.columns.load = RC_OUT(loads_.data() + steps);
    need(rc_batch_solve(&system, options, &batch) == RC_OK, std::string("rc_batch_solve: ") + rc_last_error());
  }

  void judge_memory(const Case& c, std::size_t k) const {
    const std::size_t n = c.scene().points();
    Reals elastic(kept_[k].p.begin(), kept_[k].p.end());
    for (std::size_t term = 0; term <= tau_.size(); ++term) {
      if (term > 0) {
        elastic.assign(n, 0);
        for (std::size_t m = 0; m <= k; ++m) {
          const Real t = time_[k] - time_[m], tau = static_cast<Real>(tau_[term - 1]);
          const Real share = m == 0 ? -std::expm1(-t / tau) : delayed(t, time_[m] - time_[m - 1], tau);
          for (std::size_t i = 0; i < n; ++i)
            elastic[i] += share * (static_cast<Real>(kept_[m].p[i]) - (m == 0 ? 0 : static_cast<Real>(kept_[m - 1].p[i])));
        }
      }
      const Reals w = c.h().times(elastic);
      for (std::size_t i = 0; i < n; ++i)
        need(std::abs(static_cast<Real>(left_[k][term * n + i]) - w[i]) <= noise(c),
             "the memory of term " + std::to_string(term) + " is off by " +
                 number(static_cast<Real>(left_[k][term * n + i]) - w[i]) + " after step " + std::to_string(k));
    }
  }

  // The mean of 1 - exp(-s/tau) over s = t .. t + length.
  static Real delayed(Real t, Real length, Real tau) {
    const Real x = length / tau;
    return x == 0 ? -std::expm1(-t / tau) : 1 + std::exp(-t / tau) * std::expm1(-x) / x;
  }
  Real creep(Real t) const {  // J/J0 - 1
    Real sum = 0;
    for (std::size_t k = 0; k < tau_.size(); ++k)
      sum -= static_cast<Real>(ratio_[k]) * std::expm1(-t / static_cast<Real>(tau_[k]));
    return sum;
  }
  // The mean of that over t - to .. t - from.
  Real mean_creep(Real t, Real from, Real to) const {
    Real sum = 0;
    for (std::size_t k = 0; k < tau_.size(); ++k)
      sum += static_cast<Real>(ratio_[k]) * delayed(t - to, to - from, static_cast<Real>(tau_[k]));
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
  std::vector<Field> left_;  // the memory after each step
  Field loads_, p_;          // of a history, then of a batch; the batch's last pressures
  StepAnswer restored_;
};

constexpr std::array kinds_of_creep{Kind{"creep", 4, 2, 0.7, 0, made<Creeps>}};

}  // namespace

std::span<const Kind> properties_of_creep() { return kinds_of_creep; }

}  // namespace scenes
