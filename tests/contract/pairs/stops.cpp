// Steps that end early: their status, their half-way result, and the step after.
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "invariance_tests.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// Small enough for naive code, hard enough that no solver ends in its first iteration.
Problem stopped_problem(std::int32_t control) {
  Problem problem = rough_problem(16, 12);
  problem.target *= 1.6;
  return control == RC_CONTROL_LOAD ? at_load(problem, 12) : problem;
}

void check_usable(const Problem& problem, const Answer& answer) {
  check_equal(answer.result.status, answer.status, "result.status");
  check(!answer.message.empty(), "the message is empty");
  for (const double value : answer.p) check(std::isfinite(value) && value >= 0, "p = " + text(value));
  check(answer.worst_residual() > 1e-12, "a stopped answer within the tolerance is certified");
  check_against_naive(problem, answer);
}

// A stop leaves no trace: the next step equals a cold one.
void check_step_after(const Problem& problem, const Contact& contact, const Pair& pair) {
  const Answer after = contact.solve(problem);
  check_status(after, RC_OK, "the step after a stop");
  check_near(after.p, solved(problem, pair).p, 1e-9, "p of the step after a stop");
}

void max_iter_stops(const Pair& pair) {
  for (const std::int32_t control : controls) {
    const Problem problem = stopped_problem(control);
    const std::int64_t needed = solved(problem, pair).result.iterations;
    if (needed < 2) continue;
    const Contact contact(problem, pair, {{RC_OPT_MAX_ITER, "1"}});
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_STOP_MAX_ITER);
    check_equal(answer.result.iterations, 1, "iterations");
    check_usable(problem, answer);
    const Options more = make_options(pair, problem.kernel);
    check(rc_contact_set_options(contact.handle(), more.get()) == RC_OK, rc_last_error());
    check_step_after(problem, contact, pair);
  }
}

void time_limit_stops(const Pair& pair) {
  for (const std::int32_t control : controls) {
    const Problem problem = stopped_problem(control);
    const Contact contact(problem, pair, {{RC_OPT_TIME_LIMIT, "1e-9"}});
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_STOP_TIME);
    check_usable(problem, answer);
    const Options patient = make_options(pair, problem.kernel, {{RC_OPT_TIME_LIMIT, "1000"}});
    check(rc_contact_set_options(contact.handle(), patient.get()) == RC_OK, rc_last_error());
    check_step_after(problem, contact, pair);
  }
}

struct Stopper {
  rc_contact* contact = nullptr;  // cancelled instead of returning nonzero
  std::int64_t calls = 0, stop_at = 0;
  rc_progress last = {};
};

std::int32_t count(const rc_progress* progress, void* user) {
  Stopper& stopper = *static_cast<Stopper*>(user);
  stopper.last = *progress;
  if (++stopper.calls != stopper.stop_at) return 0;
  if (!stopper.contact) return 1;
  rc_contact_cancel(stopper.contact);
  return 0;
}

void callback_stops(const Pair& pair, bool by_cancel) {
  for (const std::int32_t control : controls) {
    const Problem problem = stopped_problem(control);
    const Contact contact(problem, pair);
    Stopper stopper;
    stopper.stop_at = 1;
    if (by_cancel) stopper.contact = contact.handle();
    check(rc_contact_on_progress(contact.handle(), count, &stopper, 1) == RC_OK, rc_last_error());
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_STOP_CANCELLED);
    check_equal(stopper.calls, 1, "calls of the progress function");
    check_equal(static_cast<std::int64_t>(stopper.last.struct_size), sizeof(rc_progress), "struct_size");
    check(stopper.last.products > 0 && stopper.last.seconds >= 0, "the progress report is empty");
    check_usable(problem, answer);
    check_step_after(problem, contact, pair);
    check(stopper.calls > 1, "the progress function is not called any more");
    check(rc_contact_on_progress(contact.handle(), nullptr, nullptr, 1) == RC_OK, rc_last_error());
  }
}

void early_cancel_stops_the_next_solve(const Pair& pair) {
  const Problem problem = stopped_problem(RC_CONTROL_APPROACH);
  const Contact contact(problem, pair);
  rc_contact_cancel(contact.handle());
  check_status(contact.solve(problem), RC_STOP_CANCELLED);
  check_step_after(problem, contact, pair);
}

struct Rendezvous {
  std::atomic<bool> running{false}, cancelled{false};
};

// Waits in the first report until the other thread has cancelled.
std::int32_t wait(const rc_progress*, void* user) {
  Rendezvous& meeting = *static_cast<Rendezvous*>(user);
  meeting.running = true;
  while (!meeting.cancelled) std::this_thread::sleep_for(std::chrono::microseconds(100));
  return 0;
}

void other_thread_stops(const Pair& pair) {
  for (const std::int32_t control : controls) {
    const Problem problem = stopped_problem(control);
    const Contact contact(problem, pair);
    Rendezvous meeting;
    check(rc_contact_on_progress(contact.handle(), wait, &meeting, 1) == RC_OK, rc_last_error());
    rc_status busy = RC_OK;
    std::thread other([&] {
      while (!meeting.running) std::this_thread::sleep_for(std::chrono::microseconds(100));
      busy = rc_contact_reset(contact.handle());
      rc_contact_cancel(contact.handle());
      meeting.cancelled = true;
    });
    const Answer answer = contact.solve(problem);
    meeting.running = true;
    other.join();
    check_status(answer, RC_STOP_CANCELLED);
    check(busy == RC_ERR_BUSY, std::string("reset of a solving contact: ") + rc_status_name(busy));
    check_usable(problem, answer);
    check_step_after(problem, contact, pair);
  }
}

void stop_keeps_the_last_start(const Pair& pair) {
  const Problem problem = stopped_problem(RC_CONTROL_APPROACH);
  const Contact stopped(problem, pair), undisturbed(problem, pair);
  check_same(stopped.solve(problem).p, undisturbed.solve(problem).p, "p of the first step");
  Problem next = problem;
  next.target *= 0.9;
  rc_contact_cancel(stopped.handle());
  check_status(stopped.solve(next), RC_STOP_CANCELLED);
  check_same(stopped.solve(next).p, undisturbed.solve(next).p, "p of the step after a stop");
}

}  // namespace

std::vector<Test> stop_tests() {
  std::vector<Test> tests;
  const auto add = [&](const char* name, const std::function<void(const Pair&)>& body) {
    add_for_pairs(tests, name, RC_BOUNDARY_FREE, body);
  };
  add("max_iter_stops_with_a_usable_result", max_iter_stops);
  add("time_limit_stops_with_a_usable_result", time_limit_stops);
  add("progress_function_stops_with_a_usable_result", [](const Pair& pair) { callback_stops(pair, false); });
  add("cancel_from_the_progress_function_stops_with_a_usable_result", [](const Pair& pair) { callback_stops(pair, true); });
  add("cancel_from_another_thread_stops_with_a_usable_result", other_thread_stops);
  add("cancel_before_a_solve_stops_it", early_cancel_stops_the_next_solve);
  add("stopped_step_keeps_the_last_certified_start", stop_keeps_the_last_start);
  return tests;
}

}  // namespace pairs
