// Properties of the scene's own steps.
#include <algorithm>
#include <array>
#include <cmath>

#include "property.h"

namespace scenes {

namespace {

// Keeps a copy of the scene's answers.
class OfSteps : public Property {
 public:
  std::string ask(const Case& c) override {
    kept_ = c.answers();
    if (kept_.back().status == RC_OK) return "";
    kept_.pop_back();
    return kept_.empty() ? "not certified" : "";
  }

 protected:
  StepAnswer& any(Random& random) { return random_of(kept_, random); }
  static StepAnswer& random_of(std::vector<StepAnswer>& list, Random& random) {
    return list[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(list.size())))];
  }
  // The point with the largest pressure; nothing without contact.
  static std::optional<std::size_t> strongest(const StepAnswer& answer) {
    const auto most = std::ranges::max_element(answer.p);
    if (!(*most > 0)) return {};
    return static_cast<std::size_t>(most - answer.p.begin());
  }
  std::vector<StepAnswer> kept_;
};

// Steps end certified, or stalled in rounding; a named solver may fail as well, rarely, and the library says so.
class Ends final : public Property {
 public:
  std::string ask(const Case& c) override {
    last_ = c.answers().back();
    return "";
  }
  Verdict judge(const Case& c) const override {
    if (last_.status == RC_OK) return Verdict::held;
    const bool named = c.pair().solver != "auto", stopped = last_.status == RC_STOP_STALLED;
    const bool failed = last_.status == RC_STOP_MAX_ITER || last_.status == RC_UNCERTIFIED || last_.status == RC_ERR_NUMERIC;
    need(stopped || (named && failed) || (last_.status == RC_ERR_INFEASIBLE && may_be_infeasible(c)),
         std::string(rc_status_name(last_.status)) + ": " + last_.message + " " + last_.result.note);
    return Verdict::undecidable;
  }
  bool spoil(const Case&, Random&) override {
    last_.status = RC_ERR_INTERNAL;
    return true;
  }

 private:
  // Loads that are the hardness times all points, in rounding.
  static bool may_be_infeasible(const Case& c) {
    const Scene& scene = c.scene();
    const Step& step = scene.steps[c.answers().size() - 1];
    double included = 0;
    for (std::size_t i = 0; i < scene.points(); ++i) included += scene.surfaces[step.surface].included(i);
    return scene.by_load() && scene.hard() &&
           load_of(scene, step.target) >= scene.system.hardness * scene.cell_area() * included * (1 - 1e-12);
  }
  StepAnswer last_;
};

class Certified final : public OfSteps {
 public:
  Verdict judge(const Case& c) const override {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      if (c.scene().large()) continue;
      judge_certified(c, c.surface(k), kept_[k], c.scene().steps[k].target);
    }
    return Verdict::held;
  }
  // A pressure that moves its point by twenty times the tolerance; a gap, a sum, a count that is off.
  bool spoil(const Case& c, Random& random) override {
    const auto k = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(kept_.size())));
    StepAnswer& answer = kept_[k];
    const auto i = strongest(answer);
    if (!i || c.scene().large()) return false;
    const Real noise = product_noise(c, c.surface(k), answer);
    switch (random.below(5)) {
      case 0: {
        const Real scale = residual_scale(c.scene(), c.surface(k), answer, c.scene().steps[k].target);
        const Real by = 20 * (static_cast<Real>(c.scene().tol) * scale + noise) / c.h()(*i, *i);
        answer.p[*i] -= static_cast<double>(std::min(by, static_cast<Real>(answer.p[*i]) / 2));
        return true;
      }
      case 1:
        answer.gap[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(answer.gap.size())))] +=
            static_cast<double>(4 * noise) + 1e-300;
        return c.surface(k).mask.empty();
      case 2:
        answer.result.load *= 1 + 4e-12;
        return true;
      case 3:
        ++answer.result.contacts;
        return true;
      default:
        answer.result.energy *= 1.001;
        return answer.result.energy != 0 &&
               std::abs(static_cast<Real>(answer.result.energy)) > 1e4L * noise * static_cast<Real>(answer.result.load);
    }
  }
};

class AsOracle final : public OfSteps {
 public:
  std::string ask(const Case& c) override {
    if (c.scene().large()) return "many points";
    return OfSteps::ask(c);
  }
  Verdict judge(const Case& c) const override {
    Verdict all = Verdict::undecidable;
    for (std::size_t k = 0; k < kept_.size(); ++k)
      if (judge_exact(c, c.surface(k), kept_[k], c.exact(k, true), c.scene().steps[k].target) == Verdict::held)
        all = Verdict::held;
    return all;
  }
  bool spoil(const Case& c, Random& random) override {
    const auto k = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(kept_.size())));
    StepAnswer& answer = kept_[k];
    const auto i = strongest(answer);
    const Exact& exact = c.exact(k, true);
    if (!i || !exact.usable() || c.scene().tol > 1e-6) return false;
    // Enough that the error's energy tells: the bound is of first order in tol, the energy of second in the error.
    const double by = 0.5 * answer.p[*i];
    answer.p[*i] -= by;
    return true;
  }
};

// Plain sums over all pressures, at points that are drawn after the answer exists; the gap is certified at these points as well.
class Gap final : public OfSteps {
 public:
  Verdict judge(const Case& c) const override {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const StepAnswer& answer = kept_[k];
      const Surface& surface = c.surface(k);
      Random random(c.scene().seed, 200 + k);
      const Real noise = product_noise(c, surface, answer), tol = (1 + 1e-6L) * static_cast<Real>(answer.result.tolerance);
      const Real allowed = tol * residual_scale(c.scene(), surface, answer, c.scene().steps[k].target) + noise;
      const Real most = *std::ranges::max_element(answer.p);
      const std::size_t n = answer.p.size();
      for (int tried = 0; tried < 64; ++tried) {
        const auto i = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(n)));
        if (!surface.included(i)) continue;
        Real gap = static_cast<Real>(surface.gap[i]) - static_cast<Real>(answer.result.approach) +
                   (answer.indentation.empty() ? 0 : static_cast<Real>(answer.indentation[i]));
        for (std::size_t j = 0; j < n; ++j)
          if (answer.p[j] != 0) gap += c.h()(i, j) * static_cast<Real>(answer.p[j]);
        need(std::abs(gap - static_cast<Real>(answer.gap[i])) <= noise,
             "the gap is off by " + number(gap - static_cast<Real>(answer.gap[i])) + " at point " + std::to_string(i));
        const Real p = answer.p[i];
        need(gap >= -allowed || p >= c.cap() * (1 - tol), "overlap " + number(gap) + " at point " + std::to_string(i));
        need(p <= tol * most || gap <= allowed, "pressure across the gap " + number(gap) + " at point " + std::to_string(i));
      }
    }
    return Verdict::held;
  }
  // The approach of a semi-periodic answer for another datum, as that of any other answer, is off by what its load deflects.
  bool spoil(const Case& c, Random& random) override {
    const auto k = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(kept_.size())));
    StepAnswer& answer = kept_[k];
    const double by = 1e-9 * static_cast<double>(c.h()(0, 0)) * answer.result.max_pressure +
                      static_cast<double>(4 * product_noise(c, c.surface(k), answer));
    answer.result.approach += by;
    return by > 0;
  }
};

class InBounds final : public OfSteps {
 public:
  std::string ask(const Case& c) override {
    if (c.scene().large()) return "many points";
    const std::string reason = OfSteps::ask(c);
    if (!reason.empty()) return reason;
    return std::isnan(kept_.front().result.load_lower) ? "nothing is proven" : "";
  }
  Verdict judge(const Case& c) const override {
    Verdict all = Verdict::undecidable;
    for (std::size_t k = 0; k < kept_.size(); ++k)
      if (judge_intervals(c, c.surface(k), kept_[k], c.exact(k)) == Verdict::held) all = Verdict::held;
    return all;
  }
  // An interval next to the truth, on either side; a count too many.
  bool spoil(const Case& c, Random& random) override {
    const auto k = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(kept_.size())));
    rc_result& r = kept_[k].result;
    const Exact& exact = c.exact(k);
    if (!exact.usable() || exact.sum == 0) return false;
    const Real load = exact.sum * static_cast<Real>(c.scene().cell_area());
    if (exact.error * static_cast<Real>(exact.p.size()) > 1e-8L * exact.sum) return false;
    switch (random.below(4)) {
      case 3:
        for (double& gap : kept_[k].gap) gap += 2.1 * r.gap_error + 1e-9 * std::abs(r.approach);
        return !std::isnan(r.gap_error) && exact.worth == Worth::exact;
      case 0:
        r.load_lower = static_cast<double>(load * (1 + 1e-9L));
        return true;
      case 1:
        r.load_upper = static_cast<double>(load * (1 - 1e-9L));
        return true;
      default:
        r.proven_open += r.undecided + 1;
        r.undecided = 0;
        r.proven_contacts = r.points - r.proven_open;
        r.area_lower = static_cast<double>(r.proven_contacts) * c.scene().cell_area();
        r.area_upper = r.area_lower;
        return exact.worth == Worth::exact && exact.contacts > r.proven_contacts;
    }
  }
};

// The overlap at points with the hardness is added, and nothing else.
class Indentation final : public OfSteps {
 public:
  std::string ask(const Case& c) override {
    if (!c.scene().hard()) return "no hardness";
    return OfSteps::ask(c);
  }
  Verdict judge(const Case& c) const override {
    const double cap = c.scene().system.hardness;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const StepAnswer& answer = kept_[k];
      if (k > 0) need(answer.indentation == kept_[k - 1].indentation_after, "the indentation changes between steps");
      for (std::size_t i = 0; i < answer.p.size(); ++i) {
        const double overlap = c.surface(k).included(i) && answer.p[i] == cap ? std::max(0.0, -answer.gap[i]) : 0;
        const double wanted = answer.indentation[i] + overlap;
        need(
            std::abs(answer.indentation_after[i] - wanted) <= 4e-16 * (wanted + std::abs(answer.result.approach) * (overlap > 0)),
            "the indentation is " + number(answer.indentation_after[i]) + " instead of " + number(wanted) + " at point " +
                std::to_string(i));
      }
    }
    return Verdict::held;
  }
  bool spoil(const Case& c, Random& random) override {
    StepAnswer& answer = any(random);
    const auto i = strongest(answer);
    if (!i) return false;
    answer.indentation_after[*i] += 1e-12 * std::abs(answer.result.approach) + 1e-9 * answer.indentation_after[*i] + 1e-300;
    return std::abs(answer.result.approach) > 0 && c.scene().hard();
  }
};

// Residuals and intervals of pressures that are known to be wrong, also in tension; of every eighth scene they are right.
class OfWrong final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (c.scene().large()) return "many points";
    if (c.answers().front().status != RC_OK) return "not certified";
    const StepAnswer& first = c.answers().front();
    Random random(c.scene().seed, 300);
    const double share = random.decades(-8, -1), size = share * first.result.max_pressure;
    digits_ = static_cast<int>(std::round(-std::log10(share)));
    way_ = random.below(8);
    Field p = first.p;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (!c.surface(0).included(i)) continue;
      const bool changed = way_ == 0 || (way_ == 1 && p[i] > 0) || (way_ == 2 && random.chance(0.1)) || way_ == 3;
      if (changed) p[i] += size * (way_ == 3 ? std::cos(0.5 * static_cast<double>(i)) : random.normal());
      if (way_ == 4 && (p[i] == first.result.max_pressure || random.chance(0.05))) p[i] = 0;
      if (way_ == 5) p[i] = 0;
      p[i] = std::min(std::max(p[i], 0.0), c.scene().hard() ? c.scene().system.hardness : HUGE_VAL);
      if (way_ == 6 && random.chance(0.1)) p[i] = -size;
    }
    const Handle contact = c.open();
    rc_step step = c.step(c.scene().steps.front());
    if (way_ == 3 && c.scene().by_load()) step.target *= 1 + share;
    target_ = step.target;
    if (c.scene().control == RC_CONTROL_AREA) return "control by area";
    answer_ = first;
    answer_.p = p;
    answer_.result = RC_RESULT_INIT;
    answer_.result.p = RC_OUT(answer_.p.data());
    answer_.result.gap = RC_OUT(answer_.gap.data());
    answer_.status = rc_contact_certify(contact.get(), &step, &answer_.result);
    answer_.message = rc_last_error();
    answer_.result.p = answer_.result.gap = rc_array{};
    if (answer_.status < 0) return "refused";
    exact_ = c.exact_of(answer_, c.surface(0), false);
    exact_load_ = exact_.sum * static_cast<Real>(c.scene().cell_area());
    return "";
  }
  Verdict judge(const Case& c) const override {
    judge_residuals(c, c.surface(0), answer_, target_);
    const rc_result& r = answer_.result;
    need(way_ < 7 || std::max(r.kkt_dual, r.kkt_complementarity) <= 2 * r.tolerance, "the certified answer is not certified");
    need(r.iterations == 0, "a certificate iterates");
    return std::isnan(r.load_lower) ? Verdict::held : judge_intervals(c, c.surface(0), answer_, exact_);
  }
  bool spoil(const Case& c, Random& random) override {
    if (!exact_.usable() || exact_.sum == 0) return false;
    rc_result& r = answer_.result;
    const Real load = exact_.sum * static_cast<Real>(c.scene().cell_area());
    if (exact_.error * static_cast<Real>(exact_.p.size()) > 1e-8L * exact_.sum) return false;
    if (std::isnan(r.load_lower) || random.chance(0.3))
      r.kkt_complementarity += 0.01;
    else if (random.chance(0.5))
      r.load_lower = static_cast<double>(load * (1 + 1e-9L));
    else
      r.load_upper = static_cast<double>(load * (1 - 1e-9L));
    return true;
  }

  void measure(std::map<std::string, Field>& numbers) const override {
    const rc_result& r = answer_.result;
    if (!exact_.usable() || !(exact_.sum > 0) || !std::isfinite(r.load_upper)) return;
    const double error = std::max(static_cast<double>(std::abs(static_cast<Real>(r.load) - exact_load_)), 1e-16 * r.load);
    numbers["half-width over error of the load, pressures off by 1e-" + std::to_string(digits_)].push_back(
        (r.load_upper - r.load_lower) / 2 / error);
  }

 private:
  StepAnswer answer_;
  Exact exact_;
  Real exact_load_ = 0;
  double target_ = 0;
  std::int64_t way_ = 0;
  int digits_ = 0;
};

constexpr std::array kinds{
    Kind{"ends", 1, 0, 1.0, 0.01, made<Ends>},
    Kind{"certified", 1, 0, 0.95, 0, made<Certified>},
    Kind{"oracle", 1, 0, 0.9, 0.03, made<AsOracle>},
    Kind{"gap", 1, 0, 0.95, 0, made<Gap>},
    Kind{"in_bounds", 1, 0, 0.6, 0.03, made<InBounds>},
    Kind{"in_bounds_of_wrong", 1, 0, 0.5, 0.05, made<OfWrong>},
    Kind{"indentation", 1, 0, 0.4, 0, made<Indentation>},
};

}  // namespace

std::span<const Kind> properties_of_steps() { return kinds; }

}  // namespace scenes
