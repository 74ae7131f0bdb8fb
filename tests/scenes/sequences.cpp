// Properties of calls that repeat, interrupt or refuse steps.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "columns.h"
#include "property.h"

namespace scenes {

namespace {

// As histories and batches have them: one surface, and no start given.
bool one_history(const Scene& scene) {
  return std::ranges::all_of(scene.steps, [](const Step& step) { return step.surface == 0 && step.p0.empty(); });
}

bool all_certified(const Case& c) { return c.answers().size() == c.scene().steps.size() && c.answers().back().status == RC_OK; }

Field targets_of(const Scene& scene, std::size_t first) {
  Field targets;
  for (std::size_t k = 0; k < scene.steps.size(); ++k) targets.push_back(scene.steps[(first + k) % scene.steps.size()].target);
  return targets;
}

void need_same_pressures(const std::vector<Field>& wanted, const std::vector<Field>& found, const std::string& what) {
  need(wanted.size() == found.size(), what + ": " + std::to_string(found.size()) + " steps");
  for (std::size_t k = 0; k < wanted.size(); ++k)
    pairs::check_same(found[k], wanted[k], what + ", step " + std::to_string(k) + ", p");
}

std::vector<Field> pressures_of(const std::vector<StepAnswer>& answers) {
  std::vector<Field> all;
  for (const StepAnswer& answer : answers) all.push_back(answer.p);
  return all;
}

// One bit of one pressure.
bool spoil_pressure(std::vector<Field>& steps, Random& random) {
  Field& p = steps[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(steps.size())))];
  double& value = p[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(p.size())))];
  value = std::nextafter(value, 1e300);
  return true;
}

bool spoil_column(Columns& columns, std::size_t from, std::size_t count, Random& random) {
  const std::size_t k = from + static_cast<std::size_t>(random.below(static_cast<std::int64_t>(count)));
  std::size_t column = 0;
  do column = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(columns.reals.size())));
  while (!columns.wanted[column] && random.chance(0.9));
  double& value = columns.reals[column][k];
  if (std::isfinite(value))
    value = std::nextafter(value, std::numeric_limits<double>::infinity());
  else
    value = 0;
  return true;
}

class AsHistory final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (!one_history(c.scene())) return "no history";
    if (!all_certified(c)) return "not certified";
    const std::size_t n = c.scene().steps.size();
    by_steps_ = by_history_ = Columns(n);
    const Handle contact = c.open();
    kept_.points = c.scene().points();
    Random random(c.scene().seed, 550);
    if (random.chance(0.5)) by_history_.leave_out(random);
    const Handle steps = c.open(by_history_.options(c.scene()));
    answers_ = c.solve_all(steps.get());
    for (std::size_t k = 0; k < answers_.size(); ++k) by_steps_.take(k, answers_[k]);
    rc_history none = RC_HISTORY_INIT;
    none.control = c.scene().control;
    need(rc_contact_solve_history(contact.get(), &none) == RC_OK, "a history of no steps");
    const auto cut = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(n)));
    status_ = follow(c, contact.get(), targets_of(c.scene(), 0), c.scene().surfaces.front(), by_history_, kept_, cut);
    return "";
  }
  Verdict judge(const Case&) const override {
    need(status_ == RC_OK, std::string("the history ends with ") + rc_status_name(status_));
    by_steps_.need_same(by_history_, 0, "history");
    need_same_pressures(pressures_of(answers_), kept_.steps, "history");
    for (std::size_t k = 0; k < answers_.size(); ++k) {
      const rc_result &seen = kept_.results[k], &wanted = answers_[k].result;
      pairs::check_same(kept_.gaps[k], answers_[k].gap, "the gap that fn sees in step " + std::to_string(k));
      need(seen.load == wanted.load && seen.approach == wanted.approach && seen.contacts == wanted.contacts &&
               seen.status == answers_[k].status,
           "fn sees another result of step " + std::to_string(k));
      need(seen.points == wanted.contacts, "fn gets other points in contact of step " + std::to_string(k));
    }
    return Verdict::held;
  }
  bool spoil(const Case&, Random& random) override {
    return random.chance(0.3) ? spoil_pressure(kept_.steps, random)
                              : spoil_column(by_history_, 0, by_history_.status.size(), random);
  }

 private:
  Columns by_steps_{0}, by_history_{0};
  Pressures kept_{};
  std::vector<StepAnswer> answers_;
  rc_status status_ = RC_ERR_INTERNAL;
};

// Contacts on the scene's surfaces, each with the targets in another order; its arrays in doubles or floats, with or without room
// between contacts, or one for all of them.
class AsBatch final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (!all_certified(c)) return "not certified";
    Random random(scene.seed, 560);
    const std::size_t n = scene.points(), steps = scene.steps.size();
    const bool masks = std::ranges::any_of(scene.surfaces, [](const Surface& s) { return !s.mask.empty(); });
    const bool virgin = scene.hard() && random.chance(0.5);
    all_ = Columns(contacts * steps);
    if (!virgin && random.chance(0.3) && steps == 1) all_.leave_out(random);
    all_.wanted[Columns::mean_gap] = true;  // so that the gap is computed at all points, as in a step that wants it
    const bool one_surface = scene.surfaces.size() == 1 && random.chance(0.5), floats = random.chance(0.25);
    const std::size_t room = random.chance(0.5) ? static_cast<std::size_t>(random.between(1, 9)) : 0;
    const auto put = [room](auto& all, const auto& values, auto between) {
      all.insert(all.end(), values.begin(), values.end());
      all.insert(all.end(), room, between);
    };
    Field gaps, targets;
    std::vector<std::uint8_t> mask;
    for (std::size_t i = 0; i < contacts; ++i) {
      Surface surface = scene.surfaces[i % scene.surfaces.size()];
      if (masks && surface.mask.empty()) surface.mask.assign(n, 1);
      for (double& gap : surface.gap) gap = floats ? static_cast<double>(static_cast<float>(gap)) : gap;
      put(gaps, surface.gap, std::numeric_limits<double>::quiet_NaN());
      put(mask, surface.mask, std::uint8_t{0});
      const Field own = targets_of(scene, i);
      put(targets, own, std::numeric_limits<double>::quiet_NaN());
      single_.emplace_back(steps);
      if (virgin) {
        Pressures kept{n, {}, {}, {}};
        const Handle contact = c.open();
        if (follow(c, contact.get(), own, surface, single_.back(), kept, 0, true) != RC_OK) return "not certified if virgin";
        p_single_.push_back(kept.steps.back());
        continue;
      }
      const Handle contact = c.open(all_.options(scene));
      StepAnswer answer;
      for (std::size_t k = 0; k < steps; ++k) {
        rc_step step = c.step({own[k], i % scene.surfaces.size(), scene.steps.front().warm, {}});
        step.undeformed_gap = RC_IN(surface.gap.data());
        if (masks) step.mask = RC_IN(surface.mask.data());
        answer = c.solve(contact.get(), step);
        if (answer.status != RC_OK) return "the steps in another order are not certified";
        single_.back().take(k, answer);
      }
      p_single_.push_back(answer.p);
    }
    const std::vector<float> in_floats(gaps.begin(), gaps.end());
    Field p(contacts * n);
    rc_batch batch = RC_BATCH_INIT;
    batch.control = scene.control;
    batch.warm_start = scene.steps.front().warm;
    batch.virgin = virgin;
    batch.n = contacts;
    batch.steps = static_cast<std::int64_t>(steps);
    batch.targets = RC_IN(targets.data());
    batch.target_stride = one_surface && steps == 1 ? std::int64_t{RC_BATCH_SHARED} : static_cast<std::int64_t>(steps + room);
    batch.undeformed_gap = RC_IN(gaps.data());
    if (floats) batch.undeformed_gap = {in_floats.data(), RC_SINGLE, 0, nullptr};
    batch.mask = RC_IN(masks ? mask.data() : nullptr);
    batch.undeformed_gap_stride = batch.mask_stride =
        one_surface ? std::int64_t{RC_BATCH_SHARED} : static_cast<std::int64_t>(n + room);
    batch.p = RC_OUT(p.data());
    batch.columns = all_.request();
    const pairs::Settings threads{{"threads", std::to_string(random.between(1, 5))}};
    status_ = rc_batch_solve(&c.system(), c.options(threads).get(), &batch);
    message_ = rc_last_error();
    for (std::size_t i = 0; i < contacts; ++i)
      p_.emplace_back(p.begin() + static_cast<std::ptrdiff_t>(i * n), p.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
    return "";
  }
  Verdict judge(const Case& c) const override {
    need(status_ == RC_OK, std::string("the batch ends with ") + rc_status_name(status_) + ": " + message_);
    for (std::size_t i = 0; i < contacts; ++i)
      single_[i].need_same(all_, i * c.scene().steps.size(), "contact " + std::to_string(i) + " of the batch");
    need_same_pressures(p_single_, p_, "batch");
    return Verdict::held;
  }
  bool spoil(const Case&, Random& random) override {
    return random.chance(0.3) ? spoil_pressure(p_, random) : spoil_column(all_, 0, all_.status.size(), random);
  }

 private:
  static constexpr std::size_t contacts = 3;
  std::vector<Columns> single_;
  std::vector<Field> p_single_, p_;
  Columns all_{0};
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
};

// As a contact compares the surface of a step with that of the step before.
bool same_surface(const Surface& a, const Surface& b) {
  if (a.mask != b.mask) return false;
  for (std::size_t i = 0; i < a.gap.size(); ++i)
    if (a.included(i) && a.gap[i] != b.gap[i]) return false;
  return true;
}

// A contact that is restored after a step goes on as the one that solved it.
class AsRestored final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (scene.steps.size() < 2) return "one step";
    if (!all_certified(c)) return "not certified";
    const pairs::Settings resumable{{"resumable", "1"}};
    const Handle solver = c.open(resumable), restored = c.open(resumable);
    const auto answers = c.solve_all(solver.get());
    if (answers.back().status != RC_OK) return "not certified if resumable";
    Random random(scene.seed, 500);
    const auto k = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scene.steps.size()) - 1));
    const Surface& surface = c.surface(k);
    const rc_state state = state_after(answers, k, surface, k > 0 && same_surface(c.surface(k - 1), surface));
    pairs::check(rc_contact_restore(restored.get(), &state) == RC_OK, std::string("rc_contact_restore: ") + rc_last_error());
    next_ = answers[k + 1];
    after_ = c.solve(restored.get(), scene.steps[k + 1]);
    return "";
  }
  Verdict judge(const Case&) const override {
    need(after_.status == next_.status, std::string("the restored contact ends with ") + rc_status_name(after_.status));
    pairs::check_same(after_.p, next_.p, "restored: p");
    pairs::check_same(after_.gap, next_.gap, "restored: gap");
    pairs::check_same({after_.result.load, after_.result.approach, after_.result.energy},
                      {next_.result.load, next_.result.approach, next_.result.energy}, "restored: load, approach, energy");
    return Verdict::held;
  }
  bool spoil(const Case&, Random& random) override {
    double& value = random.chance(0.5) ? after_.result.approach : after_.p.front();
    value = std::nextafter(value, 1e300);
    return true;
  }

 private:
  StepAnswer next_, after_;
};

// Neither the number of threads nor what a contact solved before a reset changes a bit.
class AsAgain final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (!all_certified(c)) return "not certified";
    const Handle contact = c.open({{"threads", std::to_string(1 + c.scene().seed % 4)}});
    threads_ = c.solve_all(contact.get());
    if (rc_contact_reset(contact.get()) != RC_OK) return "refused";
    reset_ = c.solve_all(contact.get());
    return "";
  }
  Verdict judge(const Case& c) const override {
    const std::size_t steps = c.answers().size();
    need(threads_.size() == steps && reset_.size() == steps, "steps are missing");
    for (std::size_t k = 0; k < steps; ++k) {
      need_same_answer(threads_[k], c.answers()[k], "other threads");
      need_same_answer(reset_[k], c.answers()[k], "after a reset");
    }
    return Verdict::held;
  }
  bool spoil(const Case&, Random& random) override {
    StepAnswer& answer = random.chance(0.5) ? threads_.back() : reset_.back();
    random.chance(0.5) ? ++answer.result.left_out : answer.p.front() += 1;
    return true;
  }

 private:
  std::vector<StepAnswer> threads_, reset_;
};

// A step that has no answer is refused, writes nothing, and leaves the contact as it was.
class Refused final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (!all_certified(c)) return "not certified";
    Random random(scene.seed, 600);
    const Handle contact = c.open();
    const Step& last = scene.steps.front();
    const StepAnswer before = c.solve(contact.get(), last);
    const Surface& surface = scene.surfaces[last.surface];
    Field gap = surface.gap;
    rc_step step = c.step(last);
    expected_ = RC_ERR_ARGUMENT;
    double included = 0;
    for (std::size_t i = 0; i < scene.points(); ++i) included += surface.included(i);
    const std::int64_t kind = random.below(4);
    if (kind == 0) {
      for (std::size_t i = 0; i < gap.size(); ++i)
        if (surface.included(i)) gap[i] = std::numeric_limits<double>::quiet_NaN();
      step.undeformed_gap = RC_IN(gap.data());
    } else if (kind == 1) {
      step.target = std::numeric_limits<double>::quiet_NaN();
    } else if (kind == 2 && scene.control != RC_CONTROL_APPROACH) {
      step.target = -1;
      expected_ = RC_ERR_INFEASIBLE;
    } else if (scene.by_load() && scene.hard()) {
      step.target = 1.001 * scene.system.hardness * scene.cell_area() * included;
      if (scene.control == RC_CONTROL_PRESSURE) step.target /= static_cast<double>(scene.points()) * scene.cell_area();
      expected_ = RC_ERR_INFEASIBLE;
    } else {
      step.control = 3;
    }
    answer_ = c.solve(contact.get(), step);
    if (before.status != RC_OK) return "not certified";
    const Handle undisturbed = c.open();
    rc_step again = c.step(last);
    c.solve(undisturbed.get(), again);
    again.undeformed_gap.data = again.mask.data = nullptr;  // those of the step before, not of the refused one
    next_ = c.solve(contact.get(), again);
    wanted_ = c.solve(undisturbed.get(), again);
    return "";
  }
  Verdict judge(const Case& c) const override {
    need(answer_.status == expected_,
         std::string(rc_status_name(answer_.status)) + " instead of " + rc_status_name(expected_) + ": " + answer_.message);
    need(!answer_.message.empty(), "a refusal without words");
    const auto untouched = [](double value) { return value == -7; };
    need(std::ranges::all_of(answer_.p, untouched) && std::ranges::all_of(answer_.gap, untouched), "a refused step writes");
    need(!c.scene().hard() || answer_.indentation == answer_.indentation_after, "a refused step leaves an indentation");
    need_same_answer(next_, wanted_, "after a refused step");
    return Verdict::held;
  }
  bool spoil(const Case&, Random&) override {
    answer_.p.front() = 0;
    return true;
  }

 private:
  StepAnswer answer_, next_, wanted_;
  rc_status expected_ = RC_ERR_INTERNAL;
};

// An infinite hardness changes no bit of an elastic answer, and no count; another one that is never reached, no answer.
class NeverReached final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (c.scene().hard()) return "a hardness";
    if (c.scene().semi_periodic()) return "semi-periodic";
    if (!infinite(c) && c.scene().control == RC_CONTROL_AREA) return "control by area";  // which more than one load may have
    if (c.answers().front().status != RC_OK) return "not certified";
    elastic_ = c.answers().front();
    rc_system hard = c.system();
    hard.hardness = infinite(c) ? HUGE_VAL : 1e4 * elastic_.result.max_pressure + 1e-30;
    rc_contact* made = nullptr;
    if (rc_contact_create(&hard, c.options().get(), &made) != RC_OK) return "refused";
    const Handle contact(made);
    hard_ = c.solve(contact.get(), c.scene().steps.front());
    const auto by = [](const rc_result& r) { return std::string(r.solver) + r.backend; };
    return by(hard_.result) == by(elastic_.result) ? "" : "auto takes another pair";
  }
  Verdict judge(const Case& c) const override {
    need(hard_.status == RC_OK, std::string("with a hardness: ") + rc_status_name(hard_.status) + ": " + hard_.message);
    const rc_result& r = hard_.result;
    need(r.capped == 0 && r.plastic_volume == 0 && r.proven_capped <= 0, "points are at a hardness that is never reached");
    if (infinite(c)) {  // none: the same bits
      pairs::check_same(hard_.p, elastic_.p, "p");
      pairs::check_same(hard_.gap, elastic_.gap, "gap");
      Columns elastic(1), hard(1);
      elastic.take(0, elastic_);
      hard.take(0, hard_);
      elastic.need_same(hard, 0, "with a hardness");
    } else if (c.scene().halfspace())  // iterates may reach it
      pairs::check_near(hard_.p, elastic_.p, 1e3 * r.tolerance + 1e-9, "p");
    return Verdict::held;
  }
  bool spoil(const Case& c, Random&) override {
    hard_.p.front() += infinite(c) ? elastic_.result.max_pressure * 1e-15 + 1e-300 : elastic_.result.max_pressure;
    return infinite(c) || c.scene().halfspace() || ++hard_.result.capped > 0;
  }

 private:
  static bool infinite(const Case& c) { return c.scene().seed % 2 == 0; }

  StepAnswer elastic_, hard_;
};

constexpr std::array kinds_of_sequences{
    Kind{"history", 2, 0, 0.6, 0, made<AsHistory>},   Kind{"batch", 3, 1, 0.8, 0, made<AsBatch>},
    Kind{"restored", 3, 2, 0.4, 0, made<AsRestored>}, Kind{"again", 4, 1, 0.9, 0, made<AsAgain>},
    Kind{"refused", 4, 3, 0.9, 0, made<Refused>},     Kind{"never_reached", 3, 0, 0.3, 0, made<NeverReached>},
};

}  // namespace

std::span<const Kind> properties_of_sequences() { return kinds_of_sequences; }

}  // namespace scenes
