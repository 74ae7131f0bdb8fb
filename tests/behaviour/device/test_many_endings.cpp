// How a batch ends that the host build of the plugin for devices solves together: failures, infeasible targets, progress, too
// little memory or time.
#include <algorithm>
#include <cmath>
#include <limits>

#include "many.h"

namespace {

using namespace device;
using namespace device::many;

void failures_are_their_contacts_own(void**) {
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_APPROACH, 2);
  const Contact context;
  const Found healthy = solved(s, context);
  s.gaps[1 * s.points() + 7] = std::nan("");
  s.targets[2 * 2 + 1] = std::numeric_limits<double>::infinity();  // the second step of contact 2
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_ERR_ARGUMENT);
  assert_int_equal(found.first, 1);
  assert_int_equal(found.certified, s.n - 2);
  if (found.words.find("first contact 1, step 0") == std::string::npos) fail_msg("%s", found.words.c_str());
  for (const std::size_t i : {0U, 3U, 4U}) {
    assert_int_equal(found.statuses[2 * i + 1], RC_OK);
    for (std::size_t m = 0; m < s.points(); ++m) assert_true(found.p[i * s.points() + m] == healthy.p[i * s.points() + m]);
  }
  assert_true(found.p[1 * s.points()] == untouched);
  assert_true(std::isnan(found.load[2 * 1]));
  assert_int_equal(found.statuses[2 * 2], RC_OK);
  assert_int_equal(found.statuses[2 * 2 + 1], RC_ERR_ARGUMENT);
  assert_true(found.p[2 * s.points() + s.points() / 2] != untouched);
}

void infeasible_targets_are_told_one_at_a_time(void**) {
  const Contact context;
  Scene load = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  load.targets[1] = -1;
  load.targets[3] = 0;
  const Found found = solved(load, context);
  assert_int_equal(found.status, RC_ERR_INFEASIBLE);
  assert_int_equal(found.certified, load.n - 1);
  assert_true(found.load[3] == 0 && found.area[3] == 0);
  Scene capped = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  capped.system.hardness = 0.3;
  capped.targets[0] = 0.31 * static_cast<double>(capped.points());
  assert_int_equal(solved(capped, context).statuses[0], RC_ERR_INFEASIBLE);
  Scene mean = scene_of(24, 24, RC_BOUNDARY_PERIODIC, RC_CONTROL_APPROACH);
  mean.targets[2] = 4;
  assert_int_equal(solved(mean, context).statuses[2], RC_ERR_INFEASIBLE);
  Scene none = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  none.masks.assign(none.gaps.size(), 1);
  std::fill_n(none.masks.begin(), none.points(), 0);
  assert_int_equal(solved(none, context).statuses[0], RC_ERR_INFEASIBLE);
}

void any_call_may_fail_in_the_middle_of_a_batch(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 2);
  const Contact healthy;
  const Found wanted = solved(s, healthy);
  for (std::int64_t k = 1; k <= wanted.calls; ++k) {
    const Contact context;
    host_faults() = {.fault = Fault::once, .at = k};
    const Found once = solved(s, context);  // its contacts are solved one at a time
    if (once.status != RC_OK) fail_msg("call %d: %s", static_cast<int>(k), once.words.c_str());
    expect_near(once.p, wanted.p, 1e-4 * most_of(wanted.p), "p");
    const std::string logged = context.logged();
    if (logged.find("contacts 0 .. 4 are solved one at a time: ") == std::string::npos ||
        logged.find("the kernel failed") == std::string::npos)
      fail_msg("call %d: the log has \"%s\"", static_cast<int>(k), logged.c_str());
    host_faults() = {.fault = Fault::lost, .at = k};
    const Found lost = solved(s, context);
    assert_int_equal(lost.status, RC_ERR_EXTERNAL);
    assert_int_equal(lost.certified, 0);
    if (lost.words.find("the device is lost") == std::string::npos) fail_msg("%s", lost.words.c_str());
    expect_untouched(lost.p);
  }
}

struct Heard {
  std::vector<std::int64_t> ended;
  std::int64_t end_at = -1;
};

void with_progress(rc_batch& batch, Heard& heard) {
  batch.user = &heard;
  batch.progress = [](std::int64_t ended, void* user) {
    Heard& all = *static_cast<Heard*>(user);
    all.ended.push_back(ended);
    return static_cast<std::int32_t>(all.end_at >= 0 && ended >= all.end_at);
  };
}

// A progress function leaves them together; it hears of each part.
void progress_hears_of_parts(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 2);
  const Contact context, little(0.15);
  Heard of_all, of_parts;
  const Found plain = solved(s, context);
  const Found all = solved(s, context, 1, [&](rc_batch& b) { with_progress(b, of_all); });
  const Found parts = solved(s, little, 1, [&](rc_batch& b) { with_progress(b, of_parts); });
  expect_same(plain, all);
  expect_same(plain, parts);
  assert_true(all.calls == plain.calls && all.calls < s.few_calls());
  assert_true(of_all.ended == std::vector<std::int64_t>{2 * s.n});
  const std::vector<std::int64_t>& ended = of_parts.ended;
  assert_true(ended.size() > 1 && std::is_sorted(ended.begin(), ended.end()) && ended.back() == 2 * s.n);
}

void progress_ends_a_batch_between_parts(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 2);
  const Contact context, little(0.15);
  const Found plain = solved(s, context);
  Heard heard;
  heard.end_at = 1;
  const Found stopped = solved(s, little, 1, [&](rc_batch& b) { with_progress(b, heard); });
  assert_int_equal(stopped.status, RC_STOP_CANCELLED);
  if (stopped.words.find("rc_batch.progress ended the batch") == std::string::npos) fail_msg("%s", stopped.words.c_str());
  assert_int_equal(heard.ended.size(), 1);
  assert_true(stopped.certified > 0 && stopped.certified < s.n && heard.ended[0] == 2 * stopped.certified);
  for (std::size_t at = 0; at < stopped.statuses.size(); ++at) {
    const bool done = at < static_cast<std::size_t>(heard.ended[0]);
    assert_int_equal(stopped.statuses[at], done ? RC_OK : RC_STOP_CANCELLED);
    assert_true(!done || stopped.load[at] == plain.load[at]);
  }
}

void too_little_memory_for_one(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  const Contact context(0.01);
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_ERR_MEMORY);
  assert_int_equal(found.certified, 0);
  expect_untouched(found.p);
}

void a_batch_ends_in_time(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  const Contact context;
  auto* const options = const_cast<rc_options*>(context.options());
  assert_int_equal(rc_options_set_number(options, RC_OPT_TIME_LIMIT, 1e-9), RC_OK);
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_STOP_TIME);
  assert_int_equal(found.certified, 0);
  expect_untouched(found.p);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(failures_are_their_contacts_own),
                              cmocka_unit_test(infeasible_targets_are_told_one_at_a_time),
                              cmocka_unit_test(any_call_may_fail_in_the_middle_of_a_batch),
                              cmocka_unit_test(progress_hears_of_parts),
                              cmocka_unit_test(progress_ends_a_batch_between_parts),
                              cmocka_unit_test(too_little_memory_for_one),
                              cmocka_unit_test(a_batch_ends_in_time)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
