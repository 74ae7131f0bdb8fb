#include <roughcontact/history.h>

#include <optional>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

constexpr double up[] = {0.2, 0.4, 0.55};

// A path of three steps over the tilted plane; `wanted` steps must be written and no more.
struct History {
  Scene scene;
  rc_history path = RC_HISTORY_INIT;
  std::vector<double> targets{up[0], up[1], up[2]};
  std::vector<double> load = std::vector<double>(3, untouched);

  History() {
    path.control = RC_CONTROL_APPROACH;
    path.n = 3;
    path.targets = RC_IN(targets.data());
    path.undeformed_gap = RC_IN(scene.gap.data());
    path.columns.load = RC_OUT(load.data());
    path.completed = 99;
  }
  Outcome run(rc_contact* contact, std::int64_t wanted) {
    const Outcome outcome = rc_contact_solve_history(contact, &path);
    assert_int_equal(path.completed, wanted);
    for (std::int64_t i = 0; i < 3; ++i) assert_int_equal(load[static_cast<std::size_t>(i)] != untouched, i < wanted);
    return outcome;
  }
};

template <class Spoil> auto path_with(std::int64_t wanted, const Spoil& spoil) {
  return [=] {
    History history;
    spoil(history);
    return history.run(made(history.scene).get(), wanted);
  };
}

Outcome gap_of_the_step_before() {
  History history;
  const ContactHandle contact = made(history.scene);
  assert_int_equal(solve(contact.get(), history.scene), RC_OK);
  history.path.undeformed_gap = {};
  return history.run(contact.get(), 3);
}

struct Inside {
  rc_contact* contact;
  std::function<Outcome(rc_contact*)> call;
  std::optional<Outcome> outcome;
};

Outcome from_path(const std::function<Outcome(rc_contact*)>& call) {
  History history;
  const ContactHandle contact = made(history.scene);
  Inside inside{contact.get(), call, {}};
  history.path.user = &inside;
  history.path.fn = [](std::int64_t, const rc_result*, void* user) -> std::int32_t {
    auto& here = *static_cast<Inside*>(user);
    here.outcome = here.call(here.contact);
    return 0;
  };
  assert_int_equal(history.run(contact.get(), 3).status, RC_OK);
  return *inside.outcome;
}

Outcome level_after(bool solved, std::int64_t i) {
  const Scene scene;
  const ContactHandle contact = made(scene);
  if (solved) {
    assert_int_equal(solve(contact.get(), scene), RC_OK);
    assert_int_equal(answer().result()->levels, 0);
    answer().prepare();
  }
  rc_level level = RC_LEVEL_INIT;
  return rc_contact_level(contact.get(), i, &level);
}

}  // namespace

Section paths() {
  const rc_status refused = RC_ERR_ARGUMENT;
  const char* const busy = "the contact is in use by another thread; make one contact per thread";
  return {
      "Paths and levels",
      {
          {"`rc_contact_solve_history`: contact is null",
           refused,
           {"rc_contact_solve_history: contact is null"},
           [] {
             rc_history path = RC_HISTORY_INIT;
             return rc_contact_solve_history(nullptr, &path);
           }},
          {"`rc_contact_solve_history`: path is null",
           refused,
           {"rc_contact_solve_history: rc_history is null"},
           [] { return rc_contact_solve_history(made(Scene()).get(), nullptr); }},
          {"path of no steps",
           RC_OK,
           {},
           path_with(0,
                     [](History& h) {
                       h.path.n = 0;
                       h.path.targets = {};
                     })},
          {"path with n = -1",
           refused,
           {"rc_contact_solve_history: rc_history.n = -1 must be >= 0"},
           path_with(0, [](History& h) { h.path.n = -1; })},
          {"path without targets",
           refused,
           {"rc_contact_solve_history: rc_history.targets is null but rc_history.n = 3"},
           path_with(0, [](History& h) { h.path.targets = {}; })},
          {"path with targets in floats",
           refused,
           {"rc_contact_solve_history: rc_history.targets.type = 1 is not RC_NATIVE"},
           path_with(0, [](History& h) { h.path.targets.type = RC_SINGLE; })},
          {"path whose gap is in a device's memory",
           refused,
           {"rc_contact_solve_history: rc_history.undeformed_gap.memory = \"cuda\": this call takes arrays in the host's memory "
            "only; copy it there, and set memory to null"},
           path_with(0, [](History& h) { h.path.undeformed_gap.memory = "cuda"; })},
          {"path with control = 3",
           refused,
           {"rc_history.control = 3 is none of RC_CONTROL_APPROACH (1), RC_CONTROL_LOAD (2), RC_CONTROL_AREA (4), "
            "RC_CONTROL_PRESSURE (8)"},
           path_with(0, [](History& h) { h.path.control = 3; })},
          {"path with warm_start = 2",
           refused,
           {"rc_contact_solve_history: rc_history.warm_start = 2 is neither 0 nor 1"},
           path_with(0, [](History& h) { h.path.warm_start = 2; })},
          {"path with virgin = 2",
           refused,
           {"rc_contact_solve_history: rc_history.virgin = 2 is neither 0 nor 1"},
           path_with(0, [](History& h) { h.path.virgin = 2; })},
          {"path with a target that is NaN",
           refused,
           {"rc_contact_solve_history: rc_history.targets[2] = nan is not finite"},
           path_with(0, [](History& h) { h.targets[2] = nan; })},
          {"path with a target that is infinite",
           refused,
           {"rc_history.targets[1] = -inf is not finite"},
           path_with(0, [](History& h) { h.targets[1] = -infinity; })},
          {"path whose gap has NaN",
           refused,
           {"rc_contact_solve_history: step 0, targets[0] = 0.2: gap has 1 value(s) that are not finite"},
           path_with(0, [](History& h) { h.scene.gap[5] = nan; })},
          {"path without a gap on a new contact",
           refused,
           {"rc_contact_solve_history: step 0, targets[0] = 0.2: rc_step.undeformed_gap.data is null and no earlier step "
            "gave one"},
           path_with(0, [](History& h) { h.path.undeformed_gap = {}; })},
          {"path without a gap after a step", RC_OK, {}, gap_of_the_step_before},
          {"path with a negative load",
           RC_ERR_INFEASIBLE,
           {"rc_contact_solve_history: step 1, targets[1] = -1: load = -1 is negative"},
           path_with(1,
                     [](History& h) {
                       h.path.control = RC_CONTROL_LOAD;
                       h.targets[1] = -1;
                     })},
          {"path that reaches the mean plane",
           RC_ERR_INFEASIBLE,
           {"rc_contact_solve_history: step 2, targets[2] = 1: approach = 1 reaches the mean plane of the gap, 0.9375"},
           path_with(2,
                     [](History& h) {
                       h.scene.system.boundary = RC_BOUNDARY_PERIODIC;
                       h.targets[2] = 1;
                     })},
          {"path that `fn` ends",
           RC_STOP_CANCELLED,
           {"rc_contact_solve_history: step 1, targets[1] = 0.4: rc_history.fn ended the history after this step"},
           path_with(2,
                     [](History& h) {
                       h.path.fn = [](std::int64_t step, const rc_result*, void*) -> std::int32_t { return step == 1; };
                     })},
          {"path's `fn` cancels the contact",
           RC_STOP_CANCELLED,
           {"rc_contact_solve_history: step 2, targets[2] = 0.55: stopped by the progress callback, rc_contact_cancel or "
            "rc_stop_when"},
           [] {
             History history;
             const ContactHandle contact = made(history.scene);
             history.path.user = contact.get();
             history.path.fn = [](std::int64_t step, const rc_result*, void* user) -> std::int32_t {
               if (step == 1) rc_contact_cancel(static_cast<rc_contact*>(user));
               return 0;
             };
             return history.run(contact.get(), 2);
           }},
          {"path's `fn` solves on the same contact",
           RC_ERR_BUSY,
           {"rc_contact_solve: ", busy},
           [] { return from_path([](rc_contact* c) { return solve(c, Scene()); }); }},
          {"path's `fn` starts a path",
           RC_ERR_BUSY,
           {"rc_contact_solve_history: ", busy},
           [] {
             return from_path([](rc_contact* c) {
               rc_history path = RC_HISTORY_INIT;
               return rc_contact_solve_history(c, &path);
             });
           }},
          {"path's `fn` asks for points without a place for their number",
           refused,
           {"rc_contact_points: n is null"},
           [] { return from_path([](rc_contact* c) { return rc_contact_points(c, 0, {}, {}, nullptr); }); }},
          {"`rc_contact_level`: contact is null",
           refused,
           {"rc_contact_level: contact is null"},
           [] {
             rc_level level{};
             return rc_contact_level(nullptr, 0, &level);
           }},
          {"`rc_contact_level`: out is null",
           refused,
           {"rc_contact_level: rc_level is null"},
           [] { return rc_contact_level(made(Scene()).get(), 0, nullptr); }},
          {"level of a contact that solved nothing",
           refused,
           {"rc_contact_level: level = 0: the last step left 0 coarse solutions"},
           [] { return level_after(false, 0); }},
          {"level of a solver without levels",
           refused,
           {"rc_contact_level: level = 0: the last step left 0"},
           [] { return level_after(true, 0); }},
          {"`rc_contact_points`: contact is null",
           refused,
           {"rc_contact_points: contact is null"},
           [] {
             std::int64_t n = 0;
             return rc_contact_points(nullptr, 0, {}, {}, &n);
           }},
          {"`rc_contact_points`: n is null",
           refused,
           {"rc_contact_points: n is null"},
           [] { return rc_contact_points(made(Scene()).get(), 0, {}, {}, nullptr); }},
          {"`rc_contact_points`: room = -1",
           refused,
           {"rc_contact_points: room = -1 must be >= 0"},
           [] {
             std::int64_t n = 0;
             return rc_contact_points(made(Scene()).get(), -1, {}, {}, &n);
           }},
          {"`rc_contact_explain`: contact is null",
           refused,
           {"rc_contact_explain: contact is null"},
           [] {
             const char* text = nullptr;
             return rc_contact_explain(nullptr, &text);
           }},
          {"`rc_contact_explain`: out is null",
           refused,
           {"rc_contact_explain: out is null"},
           [] { return rc_contact_explain(made(Scene()).get(), nullptr); }},
          {"level -1",
           refused,
           {"rc_contact_level: level = -1: the last step left 0 coarse solutions, numbered from 0"},
           [] { return level_after(true, -1); }},
      }};
}

}  // namespace errors
