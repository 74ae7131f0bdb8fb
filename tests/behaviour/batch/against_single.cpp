// A batch gives each of its contacts the same bits as a contact of its own does, with any number of threads.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "behaviour/paths/history.h"
#include "study.h"
#include "support/registry.h"

namespace batch {

namespace {

using namespace pairs;

void check_slice(const Field& all, std::int64_t i, const Field& one, const char* what) {
  const auto size = static_cast<std::ptrdiff_t>(one.size());
  pairs::check_same(Field(all.begin() + i * size, all.begin() + (i + 1) * size), one, what);
}

// Without fn, whose gap takes a product over all points instead of one over those that matter.
Field certificates(const Problem& problem, const Study& study, const Field& targets) {
  const Contact contact(problem, study.pair, study.settings);
  Field found(targets.size());
  rc_history path = RC_HISTORY_INIT;
  path.control = problem.control;
  path.warm_start = study.warm;
  path.n = static_cast<std::int64_t>(targets.size());
  path.targets = RC_IN(targets.data());
  path.undeformed_gap = RC_IN(problem.gap.data());
  path.mask = RC_IN(problem.mask.empty() ? nullptr : problem.mask.data());
  path.columns.certificate = RC_OUT(found.data());
  check(rc_contact_solve_history(contact.handle(), &path) == RC_OK, rc_last_error());
  return found;
}

// Each contact by rc_contact_solve_history on a fresh rc_contact.
void equals_single_contacts(const Study& study, const Outcome& outcome) {
  check_outcome(outcome, RC_OK, study.n, study.n, -1);
  for (std::int64_t i = 0; i < study.n; ++i) {
    const Problem problem = study.single(i);
    paths::Request request;
    request.control = problem.control;
    request.warm_start = study.warm;
    request.targets.assign(study.targets.begin() + i * study.steps, study.targets.begin() + (i + 1) * study.steps);
    request.with_stiffness = study.with_stiffness;
    const paths::History history = paths::followed(Contact(problem, study.pair, study.settings), problem, request);
    check_slice(outcome.load, i, history.load, "load");
    check_slice(outcome.approach, i, history.approach, "approach");
    check_slice(outcome.contact_area, i, history.contact_area, "contact area");
    check_slice(outcome.certificate, i, certificates(problem, study, request.targets), "certificate");
    check_slice(outcome.stiffness, i, history.stiffness, "stiffness");
    check_slice(outcome.p, i, history.seen.back().p, "p");
    for (std::int64_t k = 0; k < study.steps; ++k) {
      const auto at = static_cast<std::size_t>(i * study.steps + k), step = static_cast<std::size_t>(k);
      check_equal(outcome.statuses[at], RC_OK, "status");
      check_equal(outcome.products[at], history.products[step], "products");
      check_equal(outcome.iterations[at], history.seen[step].result.iterations, "iterations");
    }
  }
}

void more_threads_than_contacts() {
  const Study study = rough_study(2, 2);
  const Outcome outcome = study.solve(9);
  equals_single_contacts(study, outcome);
  check_same(study.solve(1), outcome);
}

// Grids on which a cold start begins on a coarser one: what is kept of those from surface to surface changes nothing.
void coarse_grids_start_anew(std::int32_t boundary, std::int32_t control) {
  Study study = rough_study(3, 2, control, boundary, 136, 130);
  study.pair = {"haar-cg", "fft"};
  study.masks.assign(study.gaps.size(), 1);
  for (std::size_t i = 0; i < study.points() / 3; ++i) study.masks[i] = 0;  // of the first surface
  const Outcome one = study.solve(1);
  equals_single_contacts(study, one);
  check_same(one, study.solve(2));
}

void a_shared_array_serves_all() {
  Study study = rough_study(3, 2), same = study;
  for (std::int64_t i = 0; i < study.n; ++i) {
    std::copy_n(study.gap(0), study.points(), same.gap(i));
    for (std::int64_t k = 0; k < study.steps; ++k) same.target(i, k) = study.target(0, k);
  }
  same.masks.assign(study.gaps.size(), 1);
  for (std::int64_t i = 0; i < study.n; ++i) same.masks[static_cast<std::size_t>(i) * study.points() + 5] = 0;
  study.masks.assign(study.points(), 1);
  study.masks[5] = 0;
  const Outcome shared =
      study.solve(2, [](rc_batch& b) { b.undeformed_gap_stride = b.mask_stride = b.target_stride = RC_BATCH_SHARED; });
  check_same(same.solve(2), shared);
  // Other targets on one surface.
  for (std::int64_t k = 0; k < study.steps; ++k) same.target(2, k) *= 0.7;
  study.targets = same.targets;
  check_same(same.solve(2), study.solve(2, [](rc_batch& b) { b.undeformed_gap_stride = b.mask_stride = RC_BATCH_SHARED; }));
}

void strides_leave_room_between_contacts() {
  const Study study = rough_study(3, 2);
  const std::size_t points = study.points();
  Field gaps, targets;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t m = 0; m < points + 11; ++m) gaps.push_back(m < points ? study.gaps[i * points + m] : std::nan(""));
    for (std::size_t k = 0; k < 5; ++k) targets.push_back(k < 2 ? study.targets[2 * i + k] : std::nan(""));
  }
  check_same(study.solve(1), study.solve(2, [&](rc_batch& b) {
    b.undeformed_gap = RC_IN(gaps.data());
    b.undeformed_gap_stride = static_cast<std::int64_t>(points) + 11;
    b.targets = RC_IN(targets.data());
    b.target_stride = 5;
  }));
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

// Gaps that floats hold exactly, and pressures that are rounded to floats at the end.
void floats_serve_as_gap_start_and_pressures() {
  Study study = rough_study(3, 2);
  std::vector<float> gaps(study.gaps.begin(), study.gaps.end());
  study.gaps.assign(gaps.begin(), gaps.end());
  const Outcome doubles = study.solve(1);
  std::vector<float> p(gaps.size());
  Outcome floats = study.solve(2, [&](rc_batch& b) {
    b.undeformed_gap = {gaps.data(), RC_SINGLE, 0, nullptr};
    b.p = {p.data(), RC_SINGLE, 0, nullptr};
  });
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

void outputs_may_be_null() {
  const Study study = rough_study(3, 2);
  check_outcome(study.solve(2,
                            [](rc_batch& b) {
                              b.p = {};
                              b.columns = {};
                            }),
                RC_OK, 3, 3, -1);
}

}  // namespace

std::vector<Test> against_single_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int32_t control : controls)
      tests.push_back({group_name({"haar-cg", "fft"}, rough_study(0, 0, control, boundary).problem.system, control) +
                           "/coarse_grids_start_anew",
                       [=] { coarse_grids_start_anew(boundary, control); }});
  tests.push_back({"more_threads_than_contacts", more_threads_than_contacts});
  tests.push_back({"a_shared_array_serves_all", a_shared_array_serves_all});
  tests.push_back({"strides_leave_room_between_contacts", strides_leave_room_between_contacts});
  tests.push_back({"pressures_start_the_next_call", pressures_start_the_next_call});
  tests.push_back({"floats_serve_as_gap_start_and_pressures", floats_serve_as_gap_start_and_pressures});
  tests.push_back({"fn_sees_each_step_in_order", fn_sees_each_step_in_order});
  tests.push_back({"outputs_may_be_null", outputs_may_be_null});
  return tests;
}

}  // namespace batch
