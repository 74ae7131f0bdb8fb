// Histories that end early, that are continued on larger grids, and what fn may ask for. That histories and batches have the bits
// of steps, whatever outputs are wanted and wherever fn ends them, is a property of scenes; refused input is in the table of
// errors.
#include <roughcontact/history.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/contact.h"
#include "support/surfaces.h"

namespace paths {

namespace {

using namespace pairs;

rc_history history_of(const Problem& problem, const Field& targets) {
  rc_history history = RC_HISTORY_INIT;
  history.control = problem.control;
  history.n = static_cast<std::int64_t>(targets.size());
  history.targets = RC_IN(targets.data());
  history.undeformed_gap = RC_IN(problem.gap.data());
  return history;
}

// The end of a history, and the answers that fn saw.
struct Outcome {
  rc_status status = RC_ERR_INTERNAL;
  std::string message;
  std::vector<Answer> seen;
};

constexpr double blank = -7;  // in columns that no step has written

// A step counts as completed exactly where its columns are written and fn saw it.
Outcome follow(
    const Contact& contact, const Problem& problem, const Field& targets, bool with_gap = true,
    const std::function<void(std::int64_t)>& after = [](std::int64_t) {}) {
  Outcome outcome;
  const auto watch = [&](std::int64_t step, const rc_result& result) {
    const auto *const p = static_cast<const double*>(result.p.data), *const gap = static_cast<const double*>(result.gap.data);
    outcome.seen.push_back({result.status, result, Field(p, p + problem.points()), Field(gap, gap + problem.points()), {}});
    after(step);
  };
  rc_history history = history_of(problem, targets);
  if (!with_gap) history.undeformed_gap = {};
  Field load(targets.size(), blank);
  history.columns.load = RC_OUT(load.data());
  history.fn = [](std::int64_t step, const rc_result* result, void* user) {
    (*static_cast<decltype(watch)*>(user))(step, *result);
    return std::int32_t{0};
  };
  history.user = const_cast<void*>(static_cast<const void*>(&watch));
  history.completed = -1;
  outcome.status = rc_contact_solve_history(contact.handle(), &history);
  outcome.message = rc_last_error();
  check_equal(history.completed, static_cast<std::int64_t>(outcome.seen.size()), "completed steps are those that fn saw");
  for (std::size_t i = 0; i < load.size(); ++i)
    check_near(load[i], i < outcome.seen.size() ? outcome.seen[i].result.load : blank, 0, "load of step " + std::to_string(i));
  return outcome;
}

// Its steps are those of `whole` from step `from` on, bit for bit.
void check_same(const Outcome& part, const Outcome& whole, std::size_t from) {
  for (std::size_t i = 0; i < part.seen.size(); ++i) {
    const Answer &a = part.seen[i], &b = whole.seen.at(from + i);
    pairs::check_same(a.p, b.p, "p");
    pairs::check_same(a.gap, b.gap, "gap");
    check_near(a.result.approach, b.result.approach, 0, "approach");
    check_equal(a.result.products, b.result.products, "products");
  }
}

struct End {
  const char* name;
  rc_status status;
  std::size_t completed;
  std::string says;
  std::int32_t control = RC_CONTROL_APPROACH;
  Field shares = {0.5, 1, 0.7, 0.8};  // of the largest target
  void (*before)(rc_contact*) = [](rc_contact*) {};
  std::int64_t cancels_after = -1;  // fn cancels the contact after this step
  Settings settings = {};
};

void cancel(rc_contact* contact) { rc_contact_cancel(contact); }
void stop_at_once(rc_contact* contact) {
  check(rc_contact_on_progress(
            contact, [](const rc_progress*, void*) { return std::int32_t{1}; }, nullptr, 1) == RC_OK,
        "progress");
}

const End all_ends[] = {
    {"negative_load", RC_ERR_INFEASIBLE, 2, "step 2, targets[2] = -", RC_CONTROL_LOAD, {0.5, 1, -1, 0.8}},
    {"beyond_the_mean_plane", RC_ERR_INFEASIBLE, 2, "reaches the mean plane", RC_CONTROL_APPROACH, {0.5, 1, 1e3, 0.8}},
    {.name = "uncertified",
     .status = RC_STOP_MAX_ITER,
     .completed = 1,
     .says = "step 1, targets[1] = ",
     .shares = {0, 1, 0},
     .settings = {{RC_OPT_MAX_ITER, "2"}, {RC_OPT_SOLVER, "polonsky-keer"}}},
    {.name = "cancelled_between_steps", .status = RC_STOP_CANCELLED, .completed = 2, .says = "step 2", .cancels_after = 1},
    {.name = "cancelled_after_the_last_step", .status = RC_OK, .completed = 4, .says = "", .cancels_after = 3},
    {.name = "cancelled_before", .status = RC_STOP_CANCELLED, .completed = 0, .says = "step 0", .before = cancel},
    {.name = "ended_by_progress",
     .status = RC_STOP_CANCELLED,
     .completed = 1,
     .says = "step 1",
     .shares = {0, 1},
     .before = stop_at_once},
};

// Completed steps stay. The contact goes on after them with the bits of a contact that was not interrupted.
void ends(const End& end) {
  Problem problem = rough_problem(18, 14, RC_BOUNDARY_PERIODIC, 0.5, 0.75);
  const double top = end.control == RC_CONTROL_LOAD ? solved(problem, automatic).result.load : problem.target;
  problem.control = end.control;
  const Contact contact(problem, automatic, end.settings);
  Field targets, good, rest;
  for (std::size_t k = 0; k < end.shares.size(); ++k) {
    targets.push_back(end.shares[k] * top);
    if (end.shares[k] < 0 || end.shares[k] > 2) continue;
    good.push_back(targets.back());
    if (k >= end.completed) rest.push_back(targets.back());
  }
  end.before(contact.handle());
  const Outcome broken = follow(contact, problem, targets, true, [&](std::int64_t step) {
    if (step == end.cancels_after) rc_contact_cancel(contact.handle());
  });
  check_equal(broken.status, end.status, broken.message);
  check_equal(broken.seen.size(), end.completed, "completed steps");
  check(broken.message.find(end.says) != std::string::npos, broken.message);
  if (!end.settings.empty()) return;  // it would end there again
  check(rc_contact_on_progress(contact.handle(), nullptr, nullptr, 1) == RC_OK, rc_last_error());
  const Outcome whole = follow(Contact(problem, automatic), problem, good);
  check_same(broken, whole, 0);
  const Outcome on = follow(contact, problem, rest, end.completed == 0);
  check_equal(whole.seen.size(), good.size(), "steps of one that is not interrupted");
  check_equal(on.seen.size(), rest.size(), "steps afterwards");
  check_same(on, whole, end.completed);
}

// Continued in another contact where contacts of coarser grids, screening and goals take part.
void larger_grids_give_the_same_bits(std::int64_t side, const Pair& pair, const Settings& more) {
  Settings settings{{RC_OPT_RESUMABLE, "1"}, {RC_OPT_TOL, "1e-6"}};
  settings.insert(settings.end(), more.begin(), more.end());
  const Problem problem = rough_problem(side, side, RC_BOUNDARY_FREE, 1, 1);
  const Contact whole(problem, pair, settings);
  std::vector<Answer> answers;
  std::unique_ptr<Contact> restored;
  for (const double share : {0.3, 0.6, 0.62, 0.0, 1.0, 0.5}) {
    rc_step step = problem.step();
    step.target = 0.1 * share * problem.target;
    if (!answers.empty()) step.undeformed_gap.data = nullptr;
    const auto pressed = [&](const Contact& contact) {  // without a gap: only points that matter are looked at
      Answer answer;
      answer.p.assign(problem.points(), 0);
      answer.result = RC_RESULT_INIT;
      answer.result.p.data = answer.p.data();
      answer.status = rc_contact_solve(contact.handle(), &step, &answer.result);
      check(answer.status == RC_OK || answer.status == RC_WITHIN_GOAL, rc_last_error());
      return answer;
    };
    answers.push_back(pressed(whole));
    const Answer& last = answers.back();
    if (restored) {
      const Answer again = pressed(*restored);
      pairs::check_same(again.p, last.p, "p");
      check_near(again.result.load, last.result.load, 0, "load");
      check_equal(again.result.products, last.result.products, "products");
    }
    if (answers.size() % 2 == 0) continue;
    restored = std::make_unique<Contact>(problem, pair, settings);
    rc_state state = RC_STATE_INIT;
    state.undeformed_gap = RC_IN(problem.gap.data());
    state.p = RC_IN(last.p.data());
    state.approach = last.result.approach;
    state.load = last.result.load;
    if (answers.size() > 1) {
      const Answer& before = answers[answers.size() - 2];
      state.p_before = RC_IN(before.p.data());
      state.approach_before = before.result.approach;
      state.load_before = before.result.load;
    }
    check(rc_contact_restore(restored->handle(), &state) == RC_OK, rc_last_error());
  }
}

// The gap stays hidden from fn where it is not wanted, and the points are those of the step that fn sees, also on a coarser grid.
void fn_may_ask_for_its_points() {
  const Problem problem = rough_problem(72, 60, RC_BOUNDARY_PERIODIC);
  const Field targets = {0.3 * problem.target, 0.7 * problem.target, problem.target};
  const Contact contact(problem, automatic, {{RC_OPT_ACCURACY, "0.05"}});
  Field mean_gap(targets.size());
  rc_history history = history_of(problem, targets);
  history.fn = [](std::int64_t, const rc_result* result, void* user) {
    std::int64_t n = -1;
    const rc_status status = rc_contact_points(static_cast<const Contact*>(user)->handle(), 0, {}, {}, &n);
    return static_cast<std::int32_t>(status != RC_OK || n != result->contacts || result->gap.data);
  };
  history.user = const_cast<Contact*>(&contact);
  history.want_gap = 0;
  history.columns.mean_gap = RC_OUT(mean_gap.data());
  check(rc_contact_solve_history(contact.handle(), &history) >= 0, rc_last_error());
  check_equal(history.completed, history.n, "completed steps");
  for (const double value : mean_gap) check(value > 0, "mean gap");
}

// Columns ask for numbers in a history alone: the options are those of before afterwards.
void columns_leave_the_options() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 1, 1);
  const Contact contact(problem, automatic, {{RC_OPT_STIFFNESS, "0"}, {RC_OPT_BOUNDS, "0"}});
  const Field targets(2, problem.target);
  Field stiffness(2), lower(2);
  rc_history history = history_of(problem, targets);
  history.columns.stiffness = RC_OUT(stiffness.data());
  history.columns.load_lower = RC_OUT(lower.data());
  check(rc_contact_solve_history(contact.handle(), &history) == RC_OK, rc_last_error());
  check(stiffness[1] > 0 && lower[1] > 0, "columns");
  const rc_result after = contact.solve(problem).result;
  check(std::isnan(after.stiffness) && std::isnan(after.load_lower), "options after a history");
}

// A batch writes NaN to all columns of steps without an answer.
void a_step_without_an_answer_has_no_numbers() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 0.5, 0.75);
  const Field targets = {0.3 * problem.target, std::numeric_limits<double>::quiet_NaN()};
  rc_batch batch = RC_BATCH_INIT;
  batch.control = problem.control;
  batch.n = 1;
  batch.steps = 2;
  batch.targets = RC_IN(targets.data());
  batch.undeformed_gap = RC_IN(problem.gap.data());
  rc_array* const columns = &batch.columns.load;
  Field found[13];  // load .. certificate
  for (std::size_t k = 0; k < std::size(found); ++k) {
    found[k].assign(2, -7);
    columns[k] = RC_OUT(found[k].data());
  }
  check_equal(rc_batch_solve(&problem.system, nullptr, &batch), RC_ERR_ARGUMENT, "status");
  for (const Field& each : found) check(std::isfinite(each[0]) && std::isnan(each[1]), "numbers of a step without an answer");
}

// Coarse solutions belong to the last step alone.
void levels_are_those_of_the_last_step() {
  const Problem problem = rough_problem(64, 64, RC_BOUNDARY_FREE, 0.5, 0.5);
  const Contact contact(problem, {"cmr", "auto"}, {{"cmr.levels", "3"}});
  check_equal(follow(contact, problem, {0.5 * problem.target, 0.9 * problem.target}).seen.back().result.levels, 2, "levels");
  check_equal(follow(contact, problem, {0}).seen.back().result.levels, 0, "levels of a step without contact");
  rc_level level = RC_LEVEL_INIT;
  check(rc_contact_level(contact.handle(), 0, &level) == RC_ERR_ARGUMENT, "a level of the step before");
}

std::vector<Test> tests() {
  std::vector<Test> all = RC_TESTS(fn_may_ask_for_its_points, columns_leave_the_options, a_step_without_an_answer_has_no_numbers,
                                   levels_are_those_of_the_last_step);
  for (const End& end : all_ends) all.push_back({std::string("ends/") + end.name, [&end] { ends(end); }});
  const auto add_larger = [&](const char* name, std::int64_t side, const Pair& pair, const Settings& settings) {
    all.push_back({std::string("restored/") + name, [=] { larger_grids_give_the_same_bits(side, pair, settings); }});
  };
  add_larger("automatic", 160, automatic, {});
  add_larger("nested", 160, {"haar-cg", "fft"}, {});
  add_larger("cascade", 160, {"cmr", "fft"}, {});
  add_larger("goal", 160, {"auto", "fft"}, {{RC_OPT_ACCURACY, "0.1"}});
  add_larger("few_points", 512, {"haar-cg", "split"}, {});
  return all;
}

}  // namespace

}  // namespace paths

int main(int argc, char** argv) { return pairs::run_group("paths", paths::tests(), argc, argv); }
