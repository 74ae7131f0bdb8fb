// Steps of a history on the host build of the plugin for devices.
#include <algorithm>
#include <cstdio>

#include "scene.h"

namespace {

using namespace device;
using rc_cuda::Fault, rc_cuda::host_faults;

// The plugin, but the core does not offer its solver to keep anything.
const rc_plugin* forgetful() {
  static rc_solver solver = *plugin()->solvers[0];
  static const rc_solver* const solvers[] = {&solver};
  static rc_plugin copy = *plugin();
  solver.solve = [](const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
    const_cast<rc_problem*>(problem)->kept = nullptr;
    return plugin()->solvers[0]->solve(host, problem, options, p, d);
  };
  copy.solvers = solvers;
  return &copy;
}

struct Pair {
  Contact keeps, forgets;
  explicit Pair(const rc_system& system = grid_of(side), double limit = 1048576)
      : keeps(limit, system, plugin()), forgets(limit, system, forgetful()) {}
};

struct Step {
  std::vector<double> p;
  std::int64_t to_device = 0, to_host = 0;
  std::int64_t box = 0;  // points of the bounding box of those with pressure
};

Step solved(Contact& contact, rc_step step) {
  Step done{std::vector<double>(hills().size(), untouched)};
  rc_result result = RC_RESULT_INIT;
  result.p.data = done.p.data();
  host_faults() = {.counts = true};
  const rc_status status = contact.solve(step, result);
  done.to_device = host_faults().to_device;
  done.to_host = host_faults().to_host;
  host_faults() = {};
  if (status != RC_OK) fail_msg("%s", contact.words().c_str());
  std::int64_t left = side, right = -1, low = side, high = -1;
  for (std::int64_t i = 0; i < side * side; ++i) {
    if (!(done.p[static_cast<std::size_t>(i)] > 0)) continue;
    left = std::min(left, i % side);
    right = std::max(right, i % side);
    low = std::min(low, i / side);
    high = std::max(high, i / side);
  }
  done.box = (right - left + 1) * (high - low + 1);
  return done;
}

rc_step warm_step(double target, bool first, std::int32_t control = RC_CONTROL_APPROACH) {
  rc_step step = cold_step();
  step.control = control;
  step.target = target;
  step.warm_start = 1;
  if (first) step.undeformed_gap.data = hills().data();
  return step;
}

// Bytes that the start of a step does not send to the device, the bits of the answers being the same.
std::int64_t saved(Pair& pair, const rc_step& step) {
  const Step kept = solved(pair.keeps, step), usual = solved(pair.forgets, step);
  assert_true(kept.p == usual.p);
  assert_int_equal(kept.to_host, usual.to_host);
  const std::int64_t bytes = usual.to_device - kept.to_device;
  if (bytes != 0) assert_true(bytes >= 8 * kept.box && bytes <= 8 * side * side && bytes % 8 == 0);
  return bytes;
}

// Also where the contact that made them is gone.
void plans_and_memory_stay_from_step_to_step(void**) {
  Contact contact;
  rc_contact* other = nullptr;
  const rc_system system = grid_of(side);
  assert_int_equal(rc_contact_create(&system, contact.options(), &other), RC_OK);
  rc_step step = cold_step();
  step.undeformed_gap.data = hills().data();
  rc_result result = RC_RESULT_INIT;
  const auto calls_of = [&](rc_contact* on) {
    assert_int_equal(with_fault(Fault::once, 0, [&] { return rc_contact_solve(on, &step, &result); }), RC_OK);
    return last_calls();
  };
  const std::int64_t first = calls_of(other), second = calls_of(other);
  std::printf("%lld calls of the layer below, then %lld\n", static_cast<long long>(first), static_cast<long long>(second));
  assert_true(second + 10 < first);
  assert_int_equal(calls_of(contact.get()), second);
  rc_contact_destroy(other);
  step.target = 0.2;  // a smaller box: plans of other lengths
  calls_of(contact.get());
}

// Up, down, far beyond what is extrapolated, in boxes that grow and shrink; each control, with a mask, a hardness, a period.
void pressures_stay_on_the_device_from_step_to_step(void**) {
  const double approaches[] = {0.4, 0.5, 0.6, 0.58, 1.7, 1.4, 1.45}, loads[] = {1, 1.4, 1.8, 1.7, 6, 4, 4.2};
  std::vector<std::uint8_t> mask(hills().size(), 1);
  std::fill_n(mask.begin() + 200, 40, std::uint8_t{0});
  for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      for (const bool masked : {false, true})
        for (const double hardness : {0.0, 0.3}) {
          rc_system system = grid_of(side);
          system.boundary = boundary;
          system.hardness = hardness;
          Pair pair(system);
          for (int k = 0; k < 7; ++k) {
            rc_step step = warm_step(control == RC_CONTROL_LOAD ? loads[k] : approaches[k], k == 0, control);
            if (masked && k == 0) step.mask.data = mask.data();
            const std::int64_t bytes = saved(pair, step);
            if ((bytes > 0) != (k > 0))
              fail_msg("control %d, step %d: %lld bytes saved", control, k, static_cast<long long>(bytes));
          }
        }
}

// Every point is in the box: a warm step sends the gap, and for the certificate the pressures.
void a_warm_step_sends_no_start(void**) {
  const std::int64_t points = side * side, vector = 8 * points;
  Pair pair;
  for (const double target : {4.2, 4.3, 4.4}) {
    const Step usual = solved(pair.forgets, warm_step(target, target == 4.2));
    const Step kept = solved(pair.keeps, warm_step(target, target == 4.2));
    assert_true(kept.p == usual.p);
    if (target == 4.2) continue;
    assert_int_equal(usual.to_device - kept.to_device, vector);
    assert_int_equal(kept.to_host, usual.to_host);
    const std::int64_t besides = kept.to_device - 2 * vector;  // trees and states of cells
    assert_true(besides >= points && besides < vector);
    std::printf("bytes a point to the device and back: %.1f and %.1f, with the start %.1f\n",
                static_cast<double>(kept.to_device) / static_cast<double>(points),
                static_cast<double>(kept.to_host) / static_cast<double>(points),
                static_cast<double>(usual.to_device) / static_cast<double>(points));
  }
}

// What a step starts from is the caller's, another solver's, or another contact's: the device's copy is not taken for it.
void other_starts_are_sent(void**) {
  Pair pair;
  saved(pair, warm_step(0.4, true));
  assert_true(saved(pair, warm_step(0.5, false)) > 0);
  const std::vector<double> own(hills().size(), 0.01);
  rc_step step = warm_step(0.5, false);
  step.p0.data = own.data();
  assert_int_equal(saved(pair, step), 0);
  step.p0.data = nullptr;
  assert_true(saved(pair, step) > 0);
  for (Contact* each : {&pair.keeps, &pair.forgets}) each->use("haar-cg", "cuda-host");
  saved(pair, warm_step(0.55, false));
  for (Contact* each : {&pair.keeps, &pair.forgets}) each->use("haar-cuda-host", "cuda-host");
  assert_int_equal(saved(pair, warm_step(0.5, false)), 0);
  assert_true(saved(pair, warm_step(0.5, false)) > 0);
  for (Contact* each : {&pair.keeps, &pair.forgets}) assert_int_equal(rc_contact_reset(each->get()), RC_OK);
  assert_int_equal(saved(pair, warm_step(0.5, true)), 0);
}

// Kept pressures give way to a solve that needs the memory.
void what_is_kept_makes_no_step_fail(void**) {
  const auto needs = [](double limit) {
    Contact contact(limit, grid_of(side), forgetful());
    std::vector<double> p(hills().size());
    rc_step step = warm_step(4.5, true);
    rc_result result = RC_RESULT_INIT;
    result.p.data = p.data();
    return contact.solve(step, result) != RC_OK;
  };
  double least = 0, enough = 1;  // [MiB]
  for (int k = 0; k < 40; ++k) {
    const double middle = (least + enough) / 2;
    (needs(middle) ? least : enough) = middle;
  }
  Pair pair(grid_of(side), enough);
  saved(pair, warm_step(0.4, true));
  assert_true(saved(pair, warm_step(0.45, false)) > 0);
  for (const double target : {4.5, 4.5, 4.5}) assert_int_equal(saved(pair, warm_step(target, false)), 0);
}

// The step is the same afterwards, with another backend where the device stays lost.
void any_call_of_a_warm_step_may_fail(void**) {
  std::vector<double> p;
  rc_result result = RC_RESULT_INIT;
  const auto third_step = [&](Contact& contact) {
    p.assign(hills().size(), untouched);
    result.p.data = p.data();
    return contact.solve(warm_step(0.5, false), result);
  };
  const auto failing = [&](Contact& contact, Fault fault, std::int64_t at) {
    solved(contact, warm_step(0.4, true));
    solved(contact, warm_step(0.45, false));
    return with_fault(fault, at, [&] { return third_step(contact); });
  };
  {
    Contact contact;
    assert_int_equal(failing(contact, Fault::once, 0), RC_OK);
  }
  const std::vector<double> wanted = p;
  const std::int64_t all = last_calls();
  for (const Fault fault : {Fault::once, Fault::lost})
    for (std::int64_t k = 1; k <= all; k += k < all - 24 && k > 12 ? 7 : 1) {
      Contact contact;
      assert_int_equal(failing(contact, fault, k), RC_ERR_EXTERNAL);
      expect_untouched(p);
      if (fault == Fault::lost) contact.use("haar-cg", "dense");
      assert_int_equal(third_step(contact), RC_OK);
      for (std::size_t i = 0; i < p.size(); ++i)
        assert_true(fault == Fault::once ? p[i] == wanted[i] : std::abs(p[i] - wanted[i]) < 1e-6);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(pressures_stay_on_the_device_from_step_to_step),
                              cmocka_unit_test(a_warm_step_sends_no_start),
                              cmocka_unit_test(other_starts_are_sent),
                              cmocka_unit_test(what_is_kept_makes_no_step_fail),
                              cmocka_unit_test(any_call_of_a_warm_step_may_fail),
                              cmocka_unit_test(plans_and_memory_stay_from_step_to_step)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
