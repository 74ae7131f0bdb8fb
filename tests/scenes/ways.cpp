// Properties of what a step may be given, where it may be solved and how it may end: arrays of floats, the host's floating-point
// modes, stops, absurd magnitudes.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "property.h"
#include "support/host_modes.h"

namespace scenes {

namespace {

using Singles = std::vector<float>;

Singles rounded(const Field& values) { return {values.begin(), values.end()}; }
Field widened(const Singles& values) { return {values.begin(), values.end()}; }

void spoil_bit(Field& values, Random& random) {
  double& value = values[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(values.size())))];
  value = value == 0 ? 1 : value * (1 + 1e-6);
}

// A gap, a start and pressures of floats are worth their values as doubles, and answers are rounded once; each array has its
// type.
class AsSingles final : public Property {
 public:
  std::string ask(const Case& c) override {
    Random random(c.scene().seed, 560);
    const pairs::Settings settings = random.chance(0.2) ? pairs::Settings{{"accuracy", "0.2"}} : pairs::Settings{};
    const Handle single = c.open(settings), wide = c.open(settings);
    std::deque<Singles> gaps;  // some are borrowed until the next step
    for (const Step& asked : c.scene().steps) {
      gaps.push_back(rounded(c.scene().surfaces[asked.surface].gap));
      const Field gap = widened(gaps.back()), start = widened(rounded(asked.p0));
      const Singles start_in_floats = rounded(asked.p0);
      rc_step in_doubles = c.step(asked);
      in_doubles.undeformed_gap.data = gap.data();
      if (!start.empty()) in_doubles.p0.data = start.data();
      rc_step in_floats = in_doubles;
      in_floats.undeformed_gap = {gaps.back().data(), RC_SINGLE, 0, nullptr};
      if (!start.empty()) in_floats.p0 = {start_in_floats.data(), RC_SINGLE, 0, nullptr};
      in_floats.borrow = random.chance(0.5);
      doubles_.push_back(c.solve(wide.get(), in_doubles));
      if (doubles_.back().status < 0) return "refused";
      floats_.push_back(
          answered(c, random.chance(0.3), [&](rc_result* r) { return rc_contact_solve(single.get(), &in_floats, r); }));
      if (!random.chance(0.3)) continue;
      StepAnswer certified = doubles_.back();
      certified.p = floats_.back().p = widened(rounded(certified.p));
      certified.result.p = RC_OUT(certified.p.data());
      certified.result.gap = RC_OUT(certified.gap.data());
      certified.status = rc_contact_certify(wide.get(), &in_doubles, &certified.result);
      if (certified.status < 0) return "not certified";
      doubles_.back() = certified;
      floats_.back() = answered(
          c, false, [&](rc_result* r) { return rc_contact_certify(single.get(), &in_floats, r); }, certified.p);
    }
    return "";
  }
  Verdict judge(const Case&) const override {
    for (std::size_t k = 0; k < floats_.size(); ++k) {
      const StepAnswer &found = floats_[k], &wanted = doubles_[k];
      const std::string step = " in step " + std::to_string(k) + " of floats";
      need(found.status == wanted.status, rc_status_name(found.status) + step);
      pairs::check_same(widened(rounded(found.p)), widened(rounded(wanted.p)), "p" + step);
      pairs::check_same(found.gap, widened(rounded(wanted.gap)), "gap" + step);
      pairs::check_same(numbers(found.result), numbers(wanted.result), "the result" + step);
    }
    return Verdict::held;
  }
  bool spoil(const Case&, Random& random) override {
    spoil_bit(random.chance(0.5) ? floats_.back().p : floats_.back().gap, random);
    return std::ranges::none_of(floats_.back().gap, [](double gap) { return std::isnan(gap); });
  }

 private:
  static Field numbers(const rc_result& r) {
    return {r.load, r.approach, r.energy, r.kkt_dual, r.load_lower, r.load_upper, static_cast<double>(r.products)};
  }
  template <class Call> static StepAnswer answered(const Case& c, bool wide_p, const Call& call, const Field& given = {}) {
    StepAnswer answer;
    Singles p = rounded(given), gap(c.scene().points());
    p.resize(gap.size());
    answer.p.resize(gap.size());
    answer.result = RC_RESULT_INIT;
    answer.result.p = {p.data(), RC_SINGLE, 0, nullptr};
    if (wide_p) answer.result.p = RC_OUT(answer.p.data());
    answer.result.gap = {gap.data(), RC_SINGLE, 0, nullptr};
    answer.status = call(&answer.result);
    if (!wide_p) answer.p = widened(p);
    answer.gap = widened(gap);
    return answer;
  }
  std::vector<StepAnswer> floats_, doubles_;
};

// Traps, rounding and flush to zero of the host change no answer, and stay as they were.
class InHostModes final : public Property {
 public:
  std::string ask(const Case& c) override {
    const support::Mode& mode = support::modes[c.scene().seed / 8 % std::size(support::modes)];
    const Handle contact = c.open();
    const support::InMode in_mode(mode);
    const support::Found given;
    answers_ = c.solve_all(contact.get());
    kept_ = support::Found() == given;
    return "";
  }
  Verdict judge(const Case& c) const override {
    need(kept_, "the call leaves another mode");
    need(answers_.size() == c.answers().size(), "steps are missing");
    for (std::size_t k = 0; k < answers_.size(); ++k) need_same_answer(answers_[k], c.answers()[k], "in the host's mode");
    return Verdict::held;
  }
  bool spoil(const Case&, Random& random) override {
    spoil_bit(answers_.back().p, random);
    return answers_.back().status >= 0;
  }

 private:
  std::vector<StepAnswer> answers_;
  bool kept_ = false;
};

// A step that ends early has a usable answer, and leaves no trace in the next one.
class Stopped final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (c.answers().front().status != RC_OK) return "not certified";
    if (c.scene().control == RC_CONTROL_AREA) return "control by area";
    Random random(c.scene().seed, 570);
    const std::int64_t way = random.below(5);
    const Handle contact = c.open();
    contact_ = contact.get();
    step_ = c.answers().size() > 1 && c.answers()[1].status == RC_OK && random.chance(0.5) ? 1 : 0;
    for (std::size_t k = 0; k < step_; ++k) c.solve(contact_, c.scene().steps[k]);
    const auto set = [&](const pairs::Settings& changed) {
      pairs::check(rc_contact_set_options(contact_, c.options(changed).get()) == RC_OK, rc_last_error());
    };
    if (way == 0) set({{"max_iter", "1"}});
    if (way == 1) set({{"time_limit", "1e-9"}});
    stop_at_ = random.between(1, 4);
    const std::string solver = c.pair().solver;
    if (solver == "gp" || solver == "nnls") least_products_ = 0;  // by the norm of the matrix, and by factors
    if (way == 2 || way == 3)
      pairs::check(rc_contact_on_progress(contact_, way == 2 ? stops : cancels, this, 1) == RC_OK, rc_last_error());
    if (way == 4) rc_contact_cancel(contact_);
    expected_ = way == 0 ? RC_STOP_MAX_ITER : way == 1 ? RC_STOP_TIME : RC_STOP_CANCELLED;
    const Step& step = c.scene().steps[step_];
    stopped_ = c.solve(contact_, step);
    if (stopped_.status == RC_OK) return "ends at once";
    pairs::check(rc_contact_on_progress(contact_, nullptr, nullptr, 1) == RC_OK, rc_last_error());
    if (way < 2) set({});
    next_ = c.solve(contact_, step);
    return "";
  }
  Verdict judge(const Case& c) const override {
    need(stopped_.status == expected_, std::string("instead of ") + rc_status_name(expected_) + ": " + stopped_.message);
    need(stopped_.result.status == stopped_.status && !stopped_.message.empty(), "a stop without words");
    if (!c.scene().large()) judge_residuals(c, c.surface(step_), stopped_, c.scene().steps[step_].target);
    need(next_.status == RC_OK, "the step after a stop: " + next_.message);
    pairs::check_near(next_.p, c.answers()[step_].p, 1e-9, "after a stop: p");  // what the stopped step factored may round anew
    return Verdict::held;
  }
  bool spoil(const Case&, Random&) override {
    *std::ranges::max_element(next_.p) += 1e-6 * pairs::largest(next_.p);
    return pairs::largest(next_.p) > 0;
  }

 private:
  static std::int32_t stops(const rc_progress* progress, void* user) {
    Stopped& own = *static_cast<Stopped*>(user);
    pairs::check(progress->products >= own.least_products_ && progress->seconds >= 0, "the report of progress is empty");
    return ++own.reports_ >= own.stop_at_;
  }
  static std::int32_t cancels(const rc_progress* progress, void* user) {
    if (stops(progress, user)) rc_contact_cancel(static_cast<Stopped*>(user)->contact_);
    return 0;
  }
  StepAnswer stopped_, next_;
  rc_contact* contact_ = nullptr;
  std::size_t step_ = 0;
  std::int64_t stop_at_ = 0, reports_ = 0, least_products_ = 1;
  rc_status expected_ = RC_OK;
};

// Numbers of absurd magnitudes give a finite answer or a documented refusal.
class Extremes final : public Property {
 public:
  std::string ask(const Case& c) override {
    Random random(c.scene().seed, 580);
    constexpr std::array sizes{1e-9, 1e9, 1e-30, 1e30, 1e-150, 1e150, 1e-300, 1e300, 1e308, 5e-324, 2.3e-308};
    const auto size = [&](double chance) { return random.chance(chance) ? random.one_of(sizes) : 1; };
    for (int draw = 0; draw < 4; ++draw) {
      rc_system system = c.system();
      if (c.scene().halfspace()) {
        const double cell = size(0.4);
        system.hx *= cell;
        system.hy *= random.chance(0.8) ? cell : size(1);
        system.modulus *= size(0.4);
        system.hardness *= size(0.3);
      }
      rc_contact* made = nullptr;
      answers_.emplace_back();
      answers_.back().status = rc_contact_create(&system, c.options().get(), &made);
      if (!made) continue;
      const Handle contact(made);
      rc_step step = c.step(c.scene().steps.front());
      const double height = size(0.4), rarely = random.chance(0.3) ? 0.05 : 0;
      Field gap = c.surface(0).gap, start(gap.size());
      for (double& value : gap) value *= height * size(rarely);
      for (double& value : start) value = size(0.8);
      step.undeformed_gap.data = gap.data();
      if (random.chance(0.3)) step.p0.data = start.data();
      step.target *= size(0.4) * (random.chance(0.5) ? height : 1);
      // A gap or target that is not finite any more is refused as well.
      answers_.back() = c.solve(made, step);
    }
    return "";
  }
  Verdict judge(const Case& c) const override {
    for (const StepAnswer& answer : answers_) {
      const rc_status status = answer.status;
      need(status >= 0 || status == RC_ERR_ARGUMENT || status == RC_ERR_INFEASIBLE || status == RC_ERR_NUMERIC ||
               status == RC_ERR_INCOMPATIBLE,
           rc_status_name(status) + (": " + answer.message));
      if (status < 0) continue;
      for (std::size_t i = 0; i < answer.p.size(); ++i)
        need(std::isfinite(answer.p[i]) && (std::isfinite(answer.gap[i]) || !c.surface(0).included(i)),
             "p or gap is not finite at point " + std::to_string(i));
      need(std::isfinite(answer.result.load + answer.result.energy + answer.result.approach),
           "load, energy or approach is not finite");
    }
    return Verdict::held;
  }
  bool spoil(const Case&, Random&) override {
    answers_.back().status = RC_ERR_INTERNAL;
    return true;
  }

 private:
  std::vector<StepAnswer> answers_;
};

constexpr std::array kinds_of_ways{Kind{"singles", 4, 1, 0.5, 0, made<AsSingles>},
                                   Kind{"host_modes", 8, 6, 0.9, 0, made<InHostModes>},
                                   Kind{"stopped", 4, 3, 0.4, 0, made<Stopped>}, Kind{"extremes", 4, 0, 0.9, 0, made<Extremes>}};

}  // namespace

std::span<const Kind> properties_of_ways() { return kinds_of_ways; }

}  // namespace scenes
