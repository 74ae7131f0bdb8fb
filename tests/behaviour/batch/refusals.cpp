// Batches that are refused as a whole: nothing is written but the counts.
#include <cmath>
#include <limits>
#include <new>

#include "study.h"
#include "support/failing_new.h"
#include "support/unit_system.h"

namespace batch {

namespace {

using namespace pairs;

void refused(const Study& study, const std::function<void(rc_batch&)>& change, rc_status status, const std::string& says) {
  for (const int threads : {1, 2}) {
    const Outcome outcome = study.solve(threads, change);
    check_outcome(outcome, status, 0, 0, -1);
    check(outcome.message.find(says) != std::string::npos, "message: " + outcome.message + ", lacks: " + says);
    for (const Field* each : {&outcome.load, &outcome.approach, &outcome.p})
      for (const double value : *each) check(value == blank, "something was written");
    for (const rc_status each : outcome.statuses) check_equal(each, -7, "status");
  }
}

void bad_arguments_are_refused() {
  const Study study = rough_study(3, 2);
  const auto bad = [&](const std::function<void(rc_batch&)>& change, const std::string& says,
                       rc_status status = RC_ERR_ARGUMENT) { refused(study, change, status, says); };
  bad([](rc_batch& b) { b.n = -1; }, "rc_batch_solve: rc_batch.n = -1 must be >= 0");
  bad([](rc_batch& b) { b.steps = -3; }, "rc_batch.steps = -3 must be >= 0");
  bad([](rc_batch& b) { b.control = 7; },
      "rc_batch.control = 7 is none of RC_CONTROL_APPROACH (1), RC_CONTROL_LOAD (2), RC_CONTROL_AREA (4), RC_CONTROL_PRESSURE "
      "(8)");
  bad([](rc_batch& b) { b.targets = {}; }, "rc_batch.targets is null but n = 3 and steps = 2");
  bad([](rc_batch& b) { b.undeformed_gap = {}; }, "rc_batch.undeformed_gap is null but n = 3");
  bad([](rc_batch& b) { b.target_stride = 1; },
      "rc_batch.target_stride = 1 must be 0, RC_BATCH_SHARED (-1) or at least steps = 2", RC_ERR_SHAPE);
  bad([](rc_batch& b) { b.undeformed_gap_stride = 431; },
      "rc_batch.undeformed_gap_stride = 431 must be 0, RC_BATCH_SHARED (-1) or at least nx*ny = 432", RC_ERR_SHAPE);
  bad([](rc_batch& b) { b.mask_stride = -2; }, "rc_batch.mask_stride = -2 must be 0", RC_ERR_SHAPE);
  bad([](rc_batch& b) { b.n = std::numeric_limits<std::int64_t>::max(); }, "are more than", RC_ERR_SHAPE);
  bad(
      [](rc_batch& b) {
        b.n = std::numeric_limits<std::int64_t>::max() / 64;
        b.undeformed_gap_stride = b.mask_stride = b.target_stride = RC_BATCH_SHARED;
      },
      "are more than", RC_ERR_SHAPE);
}

void bad_systems_and_options_are_refused() {
  Study study = rough_study(3, 2);
  study.problem.system.modulus = -1;
  refused(study, {}, RC_ERR_ARGUMENT, "rc_batch_solve: rc_system.modulus = -1");
  study.problem.system.modulus = 1;
  study.pair.solver = "no-such-solver";
  refused(study, {}, RC_ERR_NO_SOLVER, "no-such-solver");
}

void null_pointers_are_refused() {
  const rc_system system = RC_SYSTEM_INIT;
  rc_batch b = RC_BATCH_INIT;
  b.control = RC_CONTROL_APPROACH;
  check_equal(rc_batch_solve(&system, nullptr, nullptr), RC_ERR_ARGUMENT, "batch null");
  check(std::string(rc_last_error()) == "rc_batch_solve: rc_batch is null", rc_last_error());
  check_equal(rc_batch_solve(nullptr, nullptr, &b), RC_ERR_ARGUMENT, "system null");
  check(std::string(rc_last_error()) == "rc_batch_solve: rc_system is null", rc_last_error());
  for (const std::size_t size : {std::size_t{0}, offsetof(rc_batch, progress) - 1, std::size_t{100000}}) {
    b.struct_size = size;
    b.written = 5;
    check_equal(rc_batch_solve(&system, nullptr, &b), RC_ERR_ARGUMENT, "struct_size");
    check(std::string(rc_last_error()).find("rc_batch.struct_size = ") != std::string::npos, rc_last_error());
    check_equal(b.written, 5, "written");
  }
}

void nothing_to_do_is_done() {
  for (const auto& [n, steps] : {std::pair<std::int64_t, std::int64_t>{0, 3}, {3, 0}, {0, 0}}) {
    rc_batch b = RC_BATCH_INIT;
    b.control = RC_CONTROL_APPROACH;
    b.n = n;
    b.steps = steps;
    b.written = -7;
    const rc_system system = support::unit_system();
    check(rc_batch_solve(&system, nullptr, &b) == RC_OK, rc_last_error());
    check_equal(b.written, n, "written");
    check_equal(b.certified, n, "certified");
    check_equal(b.first, -1, "first");
  }
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

std::vector<Test> refusal_tests() {
  return {{"bad_arguments_are_refused", bad_arguments_are_refused},
          {"bad_systems_and_options_are_refused", bad_systems_and_options_are_refused},
          {"null_pointers_are_refused", null_pointers_are_refused},
          {"nothing_to_do_is_done", nothing_to_do_is_done},
          {"memory_runs_out_for_one_contact_at_most", memory_runs_out_for_one_contact_at_most}};
}

}  // namespace batch
