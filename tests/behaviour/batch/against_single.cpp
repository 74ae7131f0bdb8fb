// Batches: given starts, arrays of floats, calls of fn, and cold starts on coarser grids. Scenes test that a batch has the bits
// of single contacts.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "study.h"
#include "support/registry.h"

namespace batch {

namespace {

using namespace pairs;

// Grids on which a cold start begins on a coarser one: what is kept of those from surface to surface changes nothing.
void coarse_grids_start_anew(std::int32_t boundary, std::int32_t control) {
  Study study = rough_study(3, 2, control, boundary, 136, 130);
  study.pair = {"haar-cg", "fft"};
  study.masks.assign(study.gaps.size(), 1);
  for (std::size_t i = 0; i < study.points() / 3; ++i) study.masks[i] = 0;  // of the first surface
  const Outcome one = study.solve(1);
  check_outcome(one, RC_OK, 3, 3, -1);
  check_same(one, study.solve(2));
  Outcome apart;
  for (std::int64_t i = 0; i < 3; ++i) apart.append(study.alone(i).solve(1));
  check_same(one, apart);
}

void pressures_start_the_next_call() {
  Study study = rough_study(3, 2);
  const Outcome first = study.solve(2);
  Study next = study;
  next.p0 = first.p;
  const Outcome apart = next.solve(2);
  check_outcome(apart, RC_OK, 3, 3, -1);
  Field p = first.p;  // in place
  Outcome in_place = next.solve(2, [&](rc_batch& b) {
    b.p0 = RC_IN(p.data());
    b.p = RC_OUT(p.data());
  });
  in_place.p = p;
  check_same(apart, in_place);
  // The last step again, from its own solution: nothing is left to do.
  next.steps = 1;
  next.targets.clear();
  for (std::int64_t i = 0; i < study.n; ++i) next.targets.push_back(study.target(i, 1));
  const Outcome again = next.solve(2);
  for (std::size_t i = 0; i < 3; ++i) check(again.iterations[i] <= 2, "iterations from the solution");
}

// Pressures that are rounded to floats at the end, and serve as a start.
void floats_serve_as_pressures() {
  const Study study = rough_study(3, 2);
  const Outcome doubles = study.solve(1);
  std::vector<float> p(study.gaps.size());
  Outcome floats = study.solve(2, [&](rc_batch& b) { b.p = {p.data(), RC_SINGLE, 0, nullptr}; });
  for (std::size_t m = 0; m < p.size(); ++m)
    check_near(p[m], doubles.p[m], 1e-6 * pairs::largest(doubles.p), "a pressure in a float");
  floats.p = doubles.p;
  check_same(doubles, floats);
  const Outcome again = study.solve(2, [&](rc_batch& b) { b.p0 = {p.data(), RC_SINGLE, 0, nullptr}; });
  check_outcome(again, RC_OK, 3, 3, -1);
}

void fn_sees_each_step_in_order() {
  Study study = rough_study(5, 3);
  std::vector<std::atomic<std::int64_t>> seen(5);
  Field load(15), p(study.gaps.size());
  study.ends = [&](std::int64_t contact, std::int64_t step, const rc_result& result) {
    const auto i = static_cast<std::size_t>(contact);
    if (seen[i]++ != step) seen[i] = -100;
    load[3 * i + static_cast<std::size_t>(step)] = result.load;
    for (std::size_t m = 0; m < study.points(); ++m)
      if (static_cast<double*>(result.p.data)[m] > 0 && std::abs(static_cast<double*>(result.gap.data)[m]) > 1e-9) seen[i] = -100;
    std::copy_n(static_cast<double*>(result.p.data), study.points(), p.begin() + static_cast<std::ptrdiff_t>(i * study.points()));
    return false;
  };
  const Outcome outcome = study.solve(3);
  check_outcome(outcome, RC_OK, 5, 5, -1);
  for (const auto& each : seen) check_equal(each, 3, "steps seen");
  pairs::check_same(load, outcome.load, "load");
  pairs::check_same(p, outcome.p, "p");
  const Outcome without = study.solve(2, [](rc_batch& b) { b.p = {}; });
  pairs::check_same(load, without.load, "load");
  pairs::check_same(p, outcome.p, "p where the batch's is null");
}

}  // namespace

std::vector<Test> against_single_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int32_t control : controls)
      tests.push_back({group_name({"haar-cg", "fft"}, rough_study(0, 0, control, boundary).problem.system, control) +
                           "/coarse_grids_start_anew",
                       [=] { coarse_grids_start_anew(boundary, control); }});
  tests.push_back({"pressures_start_the_next_call", pressures_start_the_next_call});
  tests.push_back({"floats_serve_as_pressures", floats_serve_as_pressures});
  tests.push_back({"fn_sees_each_step_in_order", fn_sees_each_step_in_order});
  return tests;
}

}  // namespace batch
