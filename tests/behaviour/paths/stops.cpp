// Paths that end early: what was completed stays, and the rest can be solved afterwards.
#include <atomic>
#include <thread>

#include "history.h"
#include "path_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace paths {

namespace {

using namespace pairs;

Problem problem_of(std::int32_t boundary) { return rough_problem(18, 14, boundary, 0.5, 0.75); }

Field rest_of(const Field& targets, std::int64_t completed) { return {targets.begin() + completed, targets.end()}; }

// Breaks off at the third step by a target that has no solution.
void a_step_without_solution_leaves_the_earlier_ones(std::int32_t control, double impossible, const char* says) {
  const Problem problem = problem_of(RC_BOUNDARY_PERIODIC);
  const double top = control == RC_CONTROL_LOAD ? solved(problem, automatic).result.load : problem.target;
  Request request;
  request.control = control;
  request.targets = {0.5 * top, top, impossible, 0.8 * top};
  const Contact contact(problem, automatic);
  const History broken = follow(contact, problem, request);
  check_status(broken, RC_ERR_INFEASIBLE, 2);
  check(broken.message.find("step 2, targets[2] = ") != std::string::npos, broken.message);
  check(broken.message.find(says) != std::string::npos, broken.message);

  Request good = request;
  good.targets = {0.5 * top, top, 0.8 * top};
  const History whole = followed(Contact(problem, automatic), problem, good);
  check_same(broken, whole, 0, 2);
  good.targets = {0.8 * top};
  good.with_gap = false;
  check_same(followed(contact, problem, good), whole, 2, 1);
}

void an_uncertified_step_ends_the_path() {
  const Problem problem = problem_of(RC_BOUNDARY_FREE);
  const Contact contact(problem, {"polonsky-keer", "auto"}, {{RC_OPT_MAX_ITER, "2"}});
  Request request;
  request.targets = {0, problem.target, 0};
  const History history = follow(contact, problem, request);
  check_status(history, RC_STOP_MAX_ITER, 1);
  check(history.message.find("step 1, targets[1] = ") != std::string::npos, history.message);
  check(history.message.find("max_iter") != std::string::npos, history.message);
}

void a_path_ended_by_fn_goes_on_where_it_stopped(std::int32_t boundary, const Pair& pair) {
  const Problem problem = problem_of(boundary);
  Request request;
  for (const double each : {0.3, 0.9, 0.6, 1.0, 0.2}) request.targets.push_back(each * problem.target);
  const History whole = followed(Contact(problem, pair, complete(pair)), problem, request);

  const Contact contact(problem, pair, complete(pair));
  Request first = request;
  first.ends = [](std::int64_t step) { return step == 1; };
  const History head = follow(contact, problem, first);
  check_status(head, RC_STOP_CANCELLED, 2);
  check_same(head, whole, 0, 2);

  Request second = request;
  second.targets = rest_of(request.targets, head.completed);
  second.with_gap = false;
  check_same(followed(contact, problem, second), whole, 2, 3);
}

void a_cancellation_between_steps_is_not_lost() {
  const Problem problem = problem_of(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic);
  Request request;
  request.targets.assign(4, problem.target);
  request.ends = [&](std::int64_t step) {
    if (step == 1) rc_contact_cancel(contact.handle());
    return false;
  };
  check_status(follow(contact, problem, request), RC_STOP_CANCELLED, 2);
  request.ends = [](std::int64_t) { return false; };
  followed(contact, problem, request);  // and it does not last
}

void a_cancellation_after_the_last_step_has_nothing_to_stop() {
  const Problem problem = problem_of(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic);
  Request request;
  request.targets.assign(2, problem.target);
  request.ends = [&](std::int64_t step) {
    if (step == 1) rc_contact_cancel(contact.handle());
    return false;
  };
  followed(contact, problem, request);
  pairs::check_status(contact.solve(problem), RC_OK, "the solve after");
}

void cancelled_before_it_begins() {
  const Problem problem = problem_of(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic);
  Request request;
  request.targets.assign(2, 0.0);  // steps that would not even run a solver
  rc_contact_cancel(contact.handle());
  check_status(follow(contact, problem, request), RC_STOP_CANCELLED, 0);
  followed(contact, problem, request);
}

// The path is so long that only the other thread can end it.
void another_thread_cancels() {
  constexpr std::int64_t far = 20000;
  const Problem problem = problem_of(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic);
  Request request;
  for (std::int64_t i = 0; i < far; ++i) request.targets.push_back(problem.target * (i % 2 == 0 ? 1 : 0.4));
  std::atomic<std::int64_t> steps{0};
  request.ends = [&](std::int64_t step) {
    steps = step + 1;
    steps.notify_all();
    return false;
  };
  History history;
  {
    std::thread other([&] {
      for (std::int64_t seen = steps; seen < 3; seen = steps) steps.wait(seen);
      rc_contact_cancel(contact.handle());
    });
    history = follow(contact, problem, request);
    steps = far;
    steps.notify_all();
    other.join();
  }
  check(history.completed >= 3 && history.completed < far, std::to_string(history.completed) + " steps completed");
  check_status(history, RC_STOP_CANCELLED, history.completed);

  Request rest;
  rest.targets = {request.targets[static_cast<std::size_t>(history.completed)]};
  rest.with_gap = false;
  const History after = followed(contact, problem, rest);
  Problem single = problem;
  single.target = rest.targets[0];
  check_near(after.seen[0].p, solved(single, automatic).p, 1e-9, "p of the step that was broken off");
}

std::int32_t stop_at_once(const rc_progress*, void*) { return 1; }

void the_progress_callback_ends_the_path() {
  const Problem problem = problem_of(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic);
  check(rc_contact_on_progress(contact.handle(), stop_at_once, nullptr, 1) == RC_OK, rc_last_error());
  Request request;
  request.targets = {0, problem.target};
  check_status(follow(contact, problem, request), RC_STOP_CANCELLED, 1);
}

}  // namespace

std::vector<Test> stop_tests() {
  std::vector<Test> tests = {
      {"a_negative_load_leaves_the_earlier_steps",
       [] { a_step_without_solution_leaves_the_earlier_ones(RC_CONTROL_LOAD, -1, "load = -1 is negative"); }},
      {"an_approach_beyond_the_mean_plane_leaves_the_earlier_steps",
       [] { a_step_without_solution_leaves_the_earlier_ones(RC_CONTROL_APPROACH, 1e3, "reaches the mean plane"); }},
      {"an_uncertified_step_ends_the_path", an_uncertified_step_ends_the_path},
      {"a_cancellation_between_steps_is_not_lost", a_cancellation_between_steps_is_not_lost},
      {"a_cancellation_after_the_last_step_has_nothing_to_stop", a_cancellation_after_the_last_step_has_nothing_to_stop},
      {"cancelled_before_it_begins", cancelled_before_it_begins},
      {"another_thread_cancels", another_thread_cancels},
      {"the_progress_callback_ends_the_path", the_progress_callback_ends_the_path},
  };
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    add_for_pairs(tests, "a_path_ended_by_fn_goes_on_where_it_stopped", boundary,
                  [boundary](const Pair& pair) { a_path_ended_by_fn_goes_on_where_it_stopped(boundary, pair); });
  return tests;
}

}  // namespace paths
