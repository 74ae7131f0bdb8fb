// Contacts that fail among sound ones, and batches that end early.
#include <atomic>
#include <chrono>
#include <cmath>
#include <new>
#include <thread>

#include "study.h"
#include "support/failing_new.h"

namespace batch {

namespace {

using namespace pairs;

bool says(const Outcome& outcome, const std::string& text) { return outcome.message.find(text) != std::string::npos; }

// Step k of contact i has an answer, and this status.
void check_step(const Outcome& outcome, const Study& study, std::int64_t i, std::int64_t k, rc_status status, bool answer) {
  const auto at = static_cast<std::size_t>(i * study.steps + k);
  const std::string what = "contact " + std::to_string(i) + ", step " + std::to_string(k);
  check_equal(outcome.statuses[at], status, what);
  for (const Field* each : {&outcome.load, &outcome.approach, &outcome.contact_area, &outcome.certificate})
    check(std::isfinite((*each)[at]) == answer, what + ": an output");
  check((outcome.products[at] >= 0) == answer && (outcome.iterations[at] >= 0) == answer, what + ": a count");
  check(answer || (outcome.products[at] == -1 && outcome.iterations[at] == -1), what + ": a count is not -1");
}

bool pressures_untouched(const Outcome& outcome, const Study& study, std::int64_t i) {
  const std::size_t points = study.points();
  for (std::size_t m = 0; m < points; ++m)
    if (outcome.p[static_cast<std::size_t>(i) * points + m] != blank) return false;
  return true;
}

void a_failing_contact_stops_no_other() {
  Study study = rough_study(6, 3, RC_CONTROL_LOAD);
  const Outcome sound = study.solve(1);
  check_outcome(sound, RC_OK, 6, 6, -1);
  study.gap(4)[17] = std::nan("");
  study.target(2, 1) = -1;
  study.target(5, 0) = std::nan("");
  const Outcome outcome = study.solve(1);
  check_outcome(outcome, RC_ERR_INFEASIBLE, 6, 3, 2);
  check(says(outcome,
             "rc_batch_solve: 3 of 6 contacts are not certified (1 RC_ERR_INFEASIBLE, 2 RC_ERR_ARGUMENT); first contact 2, step "
             "1, target -1: load = -1 is negative"),
        outcome.message);
  for (std::int64_t i = 0; i < 6; ++i)
    for (std::int64_t k = 0; k < 3; ++k) {
      const bool answer = i != 4 && i != 5 && (i != 2 || k == 0);
      check_step(outcome, study, i, k, answer ? RC_OK : i == 2 ? RC_ERR_INFEASIBLE : RC_ERR_ARGUMENT, answer);
      const auto at = static_cast<std::size_t>(3 * i + k);
      if (answer) check(outcome.load[at] == sound.load[at] && outcome.approach[at] == sound.approach[at], "an answer changed");
    }
  check(pressures_untouched(outcome, study, 4) && pressures_untouched(outcome, study, 5), "pressures of a contact that failed");
  check(!pressures_untouched(outcome, study, 2), "pressures of the step before the failure");
  for (const int threads : {2, 3}) check_same(outcome, study.solve(threads));
}

void an_uncertified_step_is_written_and_ends_its_contact() {
  Study study = rough_study(3, 2);
  study.pair = {"polonsky-keer", "dense"};
  study.settings = {{RC_OPT_MAX_ITER, "1"}};
  for (const std::int64_t i : {0, 2}) study.target(i, 0) *= 4;
  study.target(1, 0) = study.target(1, 1) = 0;  // nothing touches, no iteration is needed
  const Outcome outcome = study.solve(2);
  check_outcome(outcome, RC_STOP_MAX_ITER, 3, 1, 0);
  check(says(outcome, "2 of 3 contacts are not certified (2 RC_STOP_MAX_ITER); first contact 0, step 0"), outcome.message);
  for (const std::int64_t i : {0, 2}) {
    check_step(outcome, study, i, 0, RC_STOP_MAX_ITER, true);
    check_step(outcome, study, i, 1, RC_STOP_MAX_ITER, false);
    check(!pressures_untouched(outcome, study, i), "pressures");
  }
  check_step(outcome, study, 1, 1, RC_OK, true);
  // A failure counts for more than a stop before it.
  study.target(2, 0) = std::nan("");
  for (const int threads : {1, 2}) check_outcome(study.solve(threads), RC_ERR_ARGUMENT, 3, 1, 2);
}

void fn_ends_it_after_the_last_step() {
  Study study = rough_study(3, 2);
  study.ends = [](std::int64_t contact, std::int64_t step, const rc_result&) { return contact == 2 && step == 1; };
  const Outcome outcome = study.solve(1);
  check_outcome(outcome, RC_STOP_CANCELLED, 3, 3, -1);
  check(says(outcome, "rc_batch.fn ended the batch; all 3 contacts are certified"), outcome.message);
}

struct Heard {
  std::atomic<std::int64_t> calls{0}, most{0}, end_at{-1};
};

std::int32_t hear(std::int64_t ended, void* user) {
  Heard& heard = *static_cast<Heard*>(user);
  ++heard.calls;
  std::int64_t most = heard.most;
  while (most < ended && !heard.most.compare_exchange_weak(most, ended)) {
  }
  return heard.end_at >= 0 && ended >= heard.end_at;
}

void progress_hears_of_every_step() {
  for (const int threads : {1, 3}) {
    Study study = rough_study(6, 3, RC_CONTROL_LOAD);
    study.target(2, 1) = -1;  // its last two steps have outputs all the same
    Heard heard;
    const auto with_progress = [&](rc_batch& batch) {
      batch.progress = hear;
      batch.user = &heard;
    };
    check_same(study.solve(1), study.solve(threads, with_progress));
    check_equal(heard.most.load(), std::int64_t{18}, "steps");
    check_equal(heard.calls.load(), std::int64_t{17}, "calls: one for both steps that failed");
  }
}

// After five steps, by fn or by progress: finished steps stay, and the others have the status.
void a_callback_ends_the_batch() {
  for (const bool by_progress : {false, true})
    for (const int threads : {1, 3}) {
      Study study = rough_study(8, 2);
      const Outcome sound = study.solve(1);
      Heard heard;
      std::atomic<std::int64_t> seen{0};
      heard.end_at = 5;
      if (!by_progress) study.ends = [&](std::int64_t, std::int64_t, const rc_result&) { return ++seen == 5; };
      const Outcome outcome = study.solve(threads, [&](rc_batch& batch) {
        if (by_progress) batch.progress = hear, batch.user = &heard;
      });
      check(outcome.status == RC_STOP_CANCELLED && outcome.written == 8, outcome.message);
      check(says(outcome, by_progress ? "rc_batch.progress ended the batch" : "rc_batch.fn ended the batch"), outcome.message);
      std::int64_t steps = 0, contacts = 0, interrupted = 0;
      for (std::int64_t i = 0; i < 8; ++i)
        for (std::int64_t k = 0; k < 2; ++k) {
          const auto at = static_cast<std::size_t>(2 * i + k);
          const bool answer = outcome.statuses[at] == RC_OK;
          const bool stopped = !answer && std::isfinite(outcome.load[at]);  // in the middle of its solve, by another thread
          check_step(outcome, study, i, k, answer ? RC_OK : RC_STOP_CANCELLED, answer || stopped);
          interrupted += stopped;
          check(!answer || outcome.load[at] == sound.load[at], "what was finished does not stay");
          steps += answer;
          contacts += answer && k == 1;
        }
      check_equal(outcome.certified, contacts, "certified");
      check(steps >= 5 && steps + interrupted < 5 + threads,
            std::to_string(steps) + " steps, others " + std::to_string(interrupted));
    }
}

void the_time_limit_is_the_batchs() {
  Study study = rough_study(4, 2);
  study.settings = {{RC_OPT_TIME_LIMIT, "1e-9"}};
  for (const int threads : {1, 2}) {
    const Outcome outcome = study.solve(threads);
    check_outcome(outcome, RC_STOP_TIME, 4, 0, 0);
    check(says(outcome, "4 of 4 contacts are not certified (4 RC_STOP_TIME); first contact 0, step 0") &&
              says(outcome, "time_limit = 1e-09 s is over"),
          outcome.message);
    for (std::int64_t i = 0; i < 4; ++i) check_step(outcome, study, i, 1, RC_STOP_TIME, false);
  }
  study.settings = {{RC_OPT_TIME_LIMIT, "1e6"}};
  check_outcome(study.solve(2), RC_OK, 4, 4, -1);
}

// The stop reaches a running solve: of hundreds of iterations, each longer than a millisecond.
void a_running_solve_is_stopped() {
  Study study = rough_study(4, 1, RC_CONTROL_APPROACH, RC_BOUNDARY_FREE, 40, 40);
  study.pair = {"polonsky-keer", "callback"};
  study.settings = {{RC_OPT_MAX_ITER, "1000000000"}, {RC_OPT_TIME_LIMIT, "0.03"}};
  study.problem.system.op = RC_OPERATOR_CALLBACK;
  study.problem.system.apply = [](const double* x, double* y, std::int64_t n, void*) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    for (std::int64_t i = 0; i < n; ++i) y[i] = (1 + 1e3 * static_cast<double>(i)) * x[i];
    return std::int32_t{0};
  };
  for (double& target : study.targets) target = 1e3;
  const Outcome outcome = study.solve(2);
  check_outcome(outcome, RC_STOP_TIME, 4, 0, 0);
  check_step(outcome, study, 0, 0, RC_STOP_TIME, true);
}

// Wherever an allocation fails, the call is refused or the contact at hand has that status, and the others are solved.
void memory_runs_out_for_one_contact_at_most() {
  Study study = rough_study(3, 1, RC_CONTROL_APPROACH, RC_BOUNDARY_FREE, 12, 9);
  study.pair = {"polonsky-keer", "dense"};
  const Outcome sound = study.solve(1);
  check_outcome(sound, RC_OK, 3, 3, -1);
  bool refused_once = false, one_once = false;
  for (std::int64_t countdown = 1; countdown < 3000; countdown += countdown < 40 ? 1 : 7) {
    Outcome outcome;
    bool own = false;
    try {
      outcome = study.solve(1, [&](rc_batch&) { support::fail_allocation(countdown); });
    } catch (const std::bad_alloc&) {
      own = true;  // the copy of the message
    }
    const bool failed = support::allocation_failed();
    support::fail_allocation(0);
    if (!failed) break;
    if (own) continue;
    if (outcome.status == RC_OK) {  // memory that was to be lent after a step is kept or freed instead
      for (std::size_t i = 0; i < 3; ++i) check(outcome.load[i] == sound.load[i], "load where nothing was refused");
      continue;
    }
    check_equal(outcome.status, RC_ERR_MEMORY, outcome.message);
    if (outcome.written == 0) {
      refused_once = true;
      continue;
    }
    check_equal(outcome.certified, 2, "certified");
    one_once = true;
    for (std::size_t i = 0; i < 3; ++i)
      check(static_cast<std::int64_t>(i) == outcome.first ? std::isnan(outcome.load[i]) : outcome.load[i] == sound.load[i],
            "load");
  }
  check(refused_once && one_once, "allocations failed in other places than expected");
}

}  // namespace

std::vector<Test> ending_tests() {
  return RC_TESTS(a_failing_contact_stops_no_other, an_uncertified_step_is_written_and_ends_its_contact,
                  memory_runs_out_for_one_contact_at_most, fn_ends_it_after_the_last_step, progress_hears_of_every_step,
                  a_callback_ends_the_batch, the_time_limit_is_the_batchs, a_running_solve_is_stopped);
}

}  // namespace batch
