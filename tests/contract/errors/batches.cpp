#include <roughcontact/history.h>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

// Three tilted planes, each pressed in two steps; contact 0 comes to no harm in any case that reaches the contacts.
struct Study {
  Scene scene;
  rc_batch batch = RC_BATCH_INIT;
  std::vector<double> gaps, targets{0.2, 0.4, 0.2, 0.4, 0.2, 0.4};
  std::vector<double> load = std::vector<double>(6, untouched);

  Study() {
    for (int i = 0; i < 3; ++i) gaps.insert(gaps.end(), scene.gap.begin(), scene.gap.end());
    batch.control = RC_CONTROL_APPROACH;
    batch.n = 3;
    batch.steps = 2;
    batch.targets = RC_IN(targets.data());
    batch.undeformed_gap = RC_IN(gaps.data());
    batch.columns.load = RC_OUT(load.data());
    batch.written = 99;
  }
  Outcome run(std::int64_t written) {
    const Outcome outcome = rc_batch_solve(&scene.system, nullptr, &batch);
    assert_int_equal(batch.written, written);
    assert_int_equal(load[0] != untouched, written == 3);
    if (written == 3) assert_true(load[0] > 0 || batch.control == RC_CONTROL_LOAD);
    return outcome;
  }
};

template <class Spoil> auto batch_with(std::int64_t written, const Spoil& spoil) {
  return [=] {
    Study study;
    spoil(study);
    return study.run(written);
  };
}

}  // namespace

Section batches() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {
      "Batches",
      {
          {"`rc_batch_solve`: system is null",
           refused,
           {"rc_batch_solve: rc_system is null"},
           [] {
             rc_batch batch = RC_BATCH_INIT;
             return rc_batch_solve(nullptr, nullptr, &batch);
           }},
          {"`rc_batch_solve`: batch is null",
           refused,
           {"rc_batch_solve: rc_batch is null"},
           [] {
             const Scene scene;
             return rc_batch_solve(&scene.system, nullptr, nullptr);
           }},
          {"batch of a bad system",
           refused,
           {"rc_batch_solve: rc_system.modulus = 0 must be positive and finite"},
           batch_with(0, [](Study& s) { s.scene.system.modulus = 0; })},
          {"batch with n = -1",
           refused,
           {"rc_batch_solve: rc_batch.n = -1 must be >= 0"},
           batch_with(0, [](Study& s) { s.batch.n = -1; })},
          {"batch with steps = -1",
           refused,
           {"rc_batch_solve: rc_batch.steps = -1 must be >= 0"},
           batch_with(0, [](Study& s) { s.batch.steps = -1; })},
          {"batch with control = 3",
           refused,
           {"rc_batch.control = 3 is none of RC_CONTROL_APPROACH (1), RC_CONTROL_LOAD (2), RC_CONTROL_AREA (4), "
            "RC_CONTROL_PRESSURE (8)"},
           batch_with(0, [](Study& s) { s.batch.control = 3; })},
          {"batch with warm_start = -1",
           refused,
           {"rc_batch_solve: rc_batch.warm_start = -1 is neither 0 nor 1"},
           batch_with(0, [](Study& s) { s.batch.warm_start = -1; })},
          {"batch with virgin = 2",
           refused,
           {"rc_batch_solve: rc_batch.virgin = 2 is neither 0 nor 1"},
           batch_with(0, [](Study& s) { s.batch.virgin = 2; })},
          {"batch with reserved = 1",
           refused,
           {"rc_batch_solve: rc_batch.reserved = 1 must be 0"},
           batch_with(0, [](Study& s) { s.batch.reserved = 1; })},
          {"batch without targets",
           refused,
           {"rc_batch_solve: rc_batch.targets is null but n = 3 and steps = 2"},
           batch_with(0, [](Study& s) { s.batch.targets = {}; })},
          {"batch without gaps",
           refused,
           {"rc_batch_solve: rc_batch.undeformed_gap is null but n = 3"},
           batch_with(0, [](Study& s) { s.batch.undeformed_gap = {}; })},
          {"batch whose mask is in a device's memory",
           refused,
           {"rc_batch_solve: rc_batch.mask.memory = \"cuda\": this call takes arrays in the host's memory only; copy it there, "
            "and "
            "set memory to null"},
           batch_with(0,
                      [](Study& s) {
                        s.batch.mask = {s.gaps.data(), RC_NATIVE, 0, "cuda"};
                      })},
          {"batch whose load is to be written in floats",
           refused,
           {"rc_batch_solve: rc_columns.load.type = 1 is not RC_NATIVE"},
           batch_with(0, [](Study& s) { s.batch.columns.load.type = RC_SINGLE; })},
          {"batch with undeformed_gap_stride = 15",
           RC_ERR_SHAPE,
           {"rc_batch.undeformed_gap_stride = 15 must be 0, RC_BATCH_SHARED (-1) or at least nx*ny = 16"},
           batch_with(0, [](Study& s) { s.batch.undeformed_gap_stride = 15; })},
          {"batch with target_stride = -2",
           RC_ERR_SHAPE,
           {"rc_batch.target_stride = -2 must be 0, RC_BATCH_SHARED (-1) or at least steps = 2"},
           batch_with(0, [](Study& s) { s.batch.target_stride = -2; })},
          {"batch of more contacts than can be addressed",
           RC_ERR_SHAPE,
           {"rc_batch: n = 4611686018427387904 contacts of 2 values are more than 1152921504606846975 values"},
           batch_with(0, [](Study& s) { s.batch.n = INT64_C(1) << 62; })},
          {"batch of no contacts",
           RC_OK,
           {},
           batch_with(0,
                      [](Study& s) {
                        s.batch.n = 0;
                        s.batch.targets = s.batch.undeformed_gap = {};
                      })},
          {"batch with NaN in the gap of contact 1",
           refused,
           {"rc_batch_solve: 1 of 3 contacts are not certified (1 RC_ERR_ARGUMENT); first contact 1, step 0, target 0.2: gap has "
            "1 value(s) that are not finite"},
           batch_with(3, [](Study& s) { s.gaps[points + 3] = nan; })},
          {"batch with a target of contact 2 that is infinite",
           refused,
           {"1 of 3 contacts are not certified (1 RC_ERR_ARGUMENT); first contact 2, step 1, target inf: rc_step.target = inf is "
            "not finite"},
           batch_with(3, [](Study& s) { s.targets[5] = infinity; })},
          {"batch with negative loads of contacts 1 and 2",
           RC_ERR_INFEASIBLE,
           {"2 of 3 contacts are not certified (2 RC_ERR_INFEASIBLE); first contact 1, step 1, target -1: load = -1 is negative"},
           batch_with(3,
                      [](Study& s) {
                        s.batch.control = RC_CONTROL_LOAD;
                        s.targets[3] = s.targets[4] = -1;
                      })},
          {"batch that `fn` ends",
           RC_STOP_CANCELLED,
           {"rc_batch_solve: 2 of 3 contacts are not certified (2 RC_STOP_CANCELLED); first contact 1, step 0, target 0.2: "
            "rc_batch.fn ended the batch"},
           batch_with(3,
                      [](Study& s) {
                        s.batch.fn = [](std::int64_t, std::int64_t step, const rc_result*, void*) -> std::int32_t {
                          return step == 1;
                        };
                      })},
          {"batch that `progress` ends",
           RC_STOP_CANCELLED,
           {"rc_batch_solve: 2 of 3 contacts are not certified (2 RC_STOP_CANCELLED); first contact 1, step 1, target 0.4: "
            "rc_batch.progress ended the batch"},
           batch_with(3,
                      [](Study& s) { s.batch.progress = [](std::int64_t ended, void*) -> std::int32_t { return ended == 3; }; })},
      }};
}

}  // namespace errors
