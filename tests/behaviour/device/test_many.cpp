// Many small contacts at once on the host build of the plugin for devices, against the same contacts one at a time.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "contact/calls/contact.h"
#include "many.h"

namespace {

using namespace device;
using namespace device::many;

// The answers for all contacts, with the pressures of every step.
struct Record {
  std::vector<rc_many_answer> answers;
  std::vector<double> p;
  std::int64_t to_device = 0, to_host = 0;  // bytes, if they are counted
};
Record record;

// The plugin, whose answers are recorded.
const rc_plugin* recorded() {
  static rc_solver solver = *plugin()->solvers[0];
  static const rc_solver* const solvers[] = {&solver};
  static rc_plugin copy = *plugin();
  solver.solve_many = [](const rc_host* host, rc_many* many, const rc_options* options) -> rc_status {
    const std::int64_t to_device = host_faults().to_device, to_host = host_faults().to_host;
    const rc_status status = plugin()->solvers[0]->solve_many(host, many, options);
    record.to_device += host_faults().to_device - to_device;
    record.to_host += host_faults().to_host - to_host;
    if (status != RC_OK || many->n == 0) return status;
    const std::int64_t count = many->done * many->steps;
    record.answers.insert(record.answers.end(), many->answers, many->answers + count);
    record.p.insert(record.p.end(), many->p, many->p + count * many->grid->nx * many->grid->ny);
    return status;
  };
  copy.solvers = solvers;
  return &copy;
}

// The library's own products find the residuals and the approach that the solver has reported, in every step.
void expect_certified(const Scene& s) {
  record = {};
  const Contact context(1048576, side, recorded());
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_OK);
  assert_int_equal(record.answers.size(), static_cast<std::size_t>(s.n * s.steps));
  for (std::int64_t i = 0; i < s.n; ++i) {
    rc::Contact contact(s.system, *context.options());
    for (std::int64_t k = 0; k < s.steps; ++k) {
      const auto at = static_cast<std::size_t>(i * s.steps + k);
      const rc_many_answer& said = record.answers[at];
      rc_step step = RC_STEP_INIT;
      step.control = s.control;
      step.target = s.targets[at];
      if (k == 0) step.undeformed_gap.data = s.gaps.data() + static_cast<std::size_t>(i) * s.points();
      if (k == 0 && !s.masks.empty()) step.mask.data = s.masks.data() + static_cast<std::size_t>(i) * s.points();
      const rc::Outputs given{{record.p.data() + at * s.points()}, {}};
      const rc::Numbers own = contact.certify(step, given, said.compression);
      rc_result result = rc::result_with(given);
      rc::write(own, contact.problem().system, result);
      assert_int_equal(own.status, RC_OK);
      const auto expect = [&](const char* name, double found_here, double reported, double allowed) {
        if (!(std::abs(found_here - reported) <= allowed))
          fail_msg("contact %d, step %d: %s is %.15g, reported as %.15g", static_cast<int>(i), static_cast<int>(k), name,
                   found_here, reported);
      };
      expect("kkt_primal", result.kkt_primal, said.primal, 1e-3 * tol);
      expect("kkt_dual", result.kkt_dual, said.dual, 1e-3 * tol);
      expect("kkt_complementarity", result.kkt_complementarity, said.complementarity, 1e-3 * tol);
      expect("load", result.load, found.load[at], 1e-12 * result.load);
      expect("approach", result.approach, found.approach[at], 1e-12 * (std::abs(said.lowest) + std::abs(said.compression)));
      expect("area", result.contact_area, found.area[at], 0);
      const double worst = std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
      expect("certificate", worst, found.certificate[at], 1e-3 * tol);
    }
  }
}

void expect_as_one_at_a_time(const Scene& s, const char* name) {
  const Contact context;
  const Found many = solved(s, context), one = one_at_a_time(s, context);
  if (many.status != RC_OK || one.status != RC_OK) fail_msg("%s: %s / %s", name, many.words.c_str(), one.words.c_str());
  std::int64_t products[2] = {0, 0};
  for (const std::int64_t each : many.products) products[0] += each;
  for (const std::int64_t each : one.products) products[1] += each;
  std::printf("%s: %lld products, one at a time %lld; %lld calls, one at a time %lld\n", name,
              static_cast<long long>(products[0]), static_cast<long long>(products[1]), static_cast<long long>(many.calls),
              static_cast<long long>(one.calls));
  assert_int_equal(many.certified, s.n);
  assert_true(many.calls < s.few_calls() && one.calls > s.few_calls());
  expect_near(many.load, one.load, 1e-5 * most_of(one.load), "load");
  expect_near(many.approach, one.approach, 1e-6 * (1 + most_of(one.approach)), "approach");
  expect_near(many.p, one.p, 1e-4 * most_of(one.p), "p");
  for (const double each : many.certificate) assert_true(each >= 0 && each <= tol);
  expect_certified(s);
}

// Every second contact leaves out points, where the gap means nothing.
void leave_out_points(Scene& s) {
  s.masks.assign(s.gaps.size(), 1);
  for (std::size_t m = 0; m < s.masks.size(); ++m)
    if (m / s.points() % 2 == 1 && (m / 5) % 3 == 0) {
      s.masks[m] = 0;
      s.gaps[m] = std::nan("");
    }
}
// Each step leaves an indentation to the next.
void yield(Scene& s) { s.system.hardness = 0.2; }
void in_metres(Scene& s) {
  s.system.hx = 2e-6;
  s.system.hy = 1e-6;
  s.system.modulus = 2e11;
  for (double& each : s.gaps) each *= 1e-6;
  for (double& each : s.targets) each *= s.control == RC_CONTROL_LOAD ? 2e11 * 2e-12 : 1e-6;
}

void answers_are_those_of_contacts_one_at_a_time(void**) {
  struct Row {
    const char* name;
    std::int64_t nx, ny, steps;
    void (*change)(Scene&);
  };
  const auto nothing = [](Scene&) {};
  for (const Row& row : {Row{"square", 24, 24, 1, nothing}, Row{"no periodic transform", 17, 30, 1, nothing},
                         Row{"larger", 64, 64, 1, nothing}, Row{"column", 1, 40, 1, nothing}, Row{"row", 36, 1, 1, nothing},
                         Row{"few points", 3, 2, 1, nothing}, Row{"masks", 24, 20, 1, leave_out_points},
                         Row{"hardness", 20, 24, 3, yield}, Row{"metres, long cells", 24, 20, 2, in_metres}})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
        if (boundary == RC_BOUNDARY_PERIODIC && (row.nx == 17 || row.change == in_metres)) continue;
        Scene s = scene_of(row.nx, row.ny, boundary, control, row.steps);
        row.change(s);
        expect_as_one_at_a_time(s, row.name);
      }
}

void histories_start_from_the_step_before(void**) {
  for (const bool warm : {true, false})
    for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
      Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, control, 4);
      s.warm = warm;
      s.targets[1] = control == RC_CONTROL_LOAD ? 0 : -10;  // nothing touches there
      s.targets[6] = s.targets[5];                          // what is solved already
      expect_as_one_at_a_time(s, warm ? "warm history" : "cold history");
      if (!warm) continue;
      const Contact context;
      const Found found = solved(s, context);
      assert_int_equal(found.products[1], 0);
      assert_true(found.load[1] == 0);
      assert_true(3 * found.products[6] <= found.products[5]);
    }
}

// Later steps of a history start from the pressures on the device: targets go there, records and pressures come back.
void no_later_step_sends_a_start(void**) {
  std::int64_t to_device[2], to_host[2];
  const std::int64_t steps[2] = {1, 6};
  const Contact context(1048576, side, recorded());
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 6);
  for (int k = 0; k < 2; ++k) {
    s.steps = steps[k];
    host_faults() = {.fault = Fault::once, .at = 0, .counts = true};
    record = {};
    const Found found = solved(s, context, 1, [&](rc_batch& b) { b.target_stride = 6; });
    assert_int_equal(found.status, RC_OK);
    to_device[k] = record.to_device;
    to_host[k] = record.to_host;
  }
  const auto n = static_cast<double>(s.n * static_cast<std::int64_t>(s.points()));
  std::printf("1 step: %.2f bytes a point to the device, %.2f back; 6 steps: %.2f and %.2f\n",
              static_cast<double>(to_device[0]) / n, static_cast<double>(to_host[0]) / n, static_cast<double>(to_device[1]) / n,
              static_cast<double>(to_host[1]) / n);
  assert_int_equal(to_device[1] - to_device[0], 5 * s.n * static_cast<std::int64_t>(sizeof(double)));
  const auto of_step = static_cast<std::int64_t>(sizeof(rc_many_answer) + s.points() * sizeof(double));
  assert_int_equal(to_host[1] - to_host[0], 5 * s.n * of_step);
}

void options_of_the_solver_hold(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  const Contact context;
  auto* const options = const_cast<rc_options*>(context.options());
  assert_int_equal(rc_options_set_text(options, "haar-cg.products", "double"), RC_OK);
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_OK);
  assert_true(found.calls < s.few_calls());
  expect_near(found.p, one_at_a_time(s, context).p, 1e-5, "p");
  assert_int_equal(rc_options_set_number(options, RC_OPT_MAX_ITER, 3), RC_OK);
  const Found stopped = solved(s, context);
  assert_int_equal(stopped.status, RC_STOP_MAX_ITER);
  assert_int_equal(stopped.iterations[0], 3);
}

// What of an answer only contacts one at a time have; and another backend's certificate.
void what_asks_for_more_is_solved_one_at_a_time(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  {
    const Contact context;
    for (rc_array rc_columns::*const output : {&rc_columns::stiffness, &rc_columns::mean_gap, &rc_columns::load_upper}) {
      std::vector<double> values(static_cast<std::size_t>(s.n));
      const Found found = solved(s, context, 1, [&](rc_batch& b) { b.columns.*output = RC_OUT(values.data()); });
      assert_int_equal(found.status, RC_OK);
      assert_true(found.calls > s.few_calls() && values[0] > 0);
    }
  }
  {
    Contact context;
    context.use("haar-cuda-host", "dense");
    assert_true(solved(s, context).calls > s.few_calls());
  }
  {
    Scene prime = scene_of(17, 24, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD);
    const Contact context;
    const Found found = solved(prime, context);
    assert_int_equal(found.status, RC_OK);
    assert_true(found.calls > s.few_calls());
  }
}

void auto_takes_many_by_what_each_costs(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  Contact context(1048576, side, cheap<true>());
  context.use("auto", "auto");
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_OK);
  assert_true(found.calls > 0 && found.calls < s.few_calls());
}

void pressures_to_start_from(void**) {
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  const Contact context;
  const Found cold = solved(s, context);
  s.p0 = cold.p;
  const Found warm = solved(s, context);
  for (std::size_t i = 0; i < warm.products.size(); ++i) assert_true(3 * warm.products[i] <= cold.products[i]);
  std::vector<double> p = cold.p;
  Found in_place = solved(s, context, 1, [&](rc_batch& b) {
    b.p0 = RC_IN(p.data());
    b.p = RC_OUT(p.data());
  });
  in_place.p = p;
  expect_same(warm, in_place);
  s.p0[s.points() + 3] = std::nan("");
  const Found bad = solved(s, context);
  assert_int_equal(bad.statuses[1], RC_ERR_ARGUMENT);
  assert_int_equal(bad.certified, s.n - 1);
}

void strides_and_shared_arrays(void**) {
  const Contact context;
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 2);
  const Found plain = solved(s, context);
  std::vector<double> wide;
  for (std::size_t i = 0; i < 5; ++i) {
    wide.insert(wide.end(), s.gaps.begin() + static_cast<std::ptrdiff_t>(i * s.points()),
                s.gaps.begin() + static_cast<std::ptrdiff_t>((i + 1) * s.points()));
    wide.insert(wide.end(), 13, std::nan(""));
  }
  expect_same(plain, solved(s, context, 1, [&](rc_batch& b) {
                b.undeformed_gap = RC_IN(wide.data());
                b.undeformed_gap_stride = static_cast<std::int64_t>(s.points()) + 13;
              }));
  const Found shared = solved(s, context, 1, [&](rc_batch& b) { b.undeformed_gap_stride = RC_BATCH_SHARED; });
  assert_int_equal(shared.status, RC_OK);
  assert_true(shared.calls < s.few_calls());
  assert_true(shared.load[0] == plain.load[0] && shared.approach[1] == plain.approach[1]);
}

// However they are shared among threads and calls.
void bits_are_the_same_however_many_are_taken_at_once(void**) {
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 2);
  const Contact context;
  const Found found = solved(s, context);
  for (const int threads : {2, 3}) expect_same(found, solved(s, context, threads));
  for (const double limit : {0.29, 0.2, 0.15}) {  // [MiB]
    const Contact little(limit);
    const Found parts = solved(s, little);
    if (parts.status != RC_OK) fail_msg("%g MiB: %s", limit, parts.words.c_str());
    std::printf("%g MiB: %lld calls\n", limit, static_cast<long long>(parts.calls));
    expect_same(found, parts);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(answers_are_those_of_contacts_one_at_a_time),
                              cmocka_unit_test(histories_start_from_the_step_before),
                              cmocka_unit_test(no_later_step_sends_a_start),
                              cmocka_unit_test(options_of_the_solver_hold),
                              cmocka_unit_test(what_asks_for_more_is_solved_one_at_a_time),
                              cmocka_unit_test(auto_takes_many_by_what_each_costs),
                              cmocka_unit_test(pressures_to_start_from),
                              cmocka_unit_test(strides_and_shared_arrays),
                              cmocka_unit_test(bits_are_the_same_however_many_are_taken_at_once)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
