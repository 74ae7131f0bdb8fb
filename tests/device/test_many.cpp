// Many small contacts at once on the host build of the plugin for devices, against the same contacts one at a time.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>

#include "scene.h"

namespace {

using namespace device;
using rc_cuda::Fault, rc_cuda::host_faults;

constexpr double tol = 1e-8;
constexpr std::int64_t few_calls = 40;  // of the layer below; a contact by itself makes hundreds

// Contacts on one grid, each with a surface and a history of its own.
struct Scene {
  rc_system system = grid_of(24);
  std::int32_t control = RC_CONTROL_DISPLACEMENT;
  std::int64_t n = 5, steps = 1;
  bool warm = true;
  std::vector<double> gaps, targets, p0;
  std::vector<std::uint8_t> masks;

  std::size_t points() const { return static_cast<std::size_t>(system.nx * system.ny); }
};

Scene scene_of(std::int64_t nx, std::int64_t ny, std::int32_t boundary, std::int32_t control, std::int64_t steps = 1) {
  Scene s;
  s.system.nx = nx;
  s.system.ny = ny;
  s.system.boundary = boundary;
  s.control = control;
  s.steps = steps;
  std::mt19937 random(static_cast<unsigned>(nx + 100 * ny));
  const auto phase = [&] { return 6.28 * static_cast<double>(random() % 1000) * 1e-3; };
  for (std::int64_t i = 0; i < s.n; ++i) {
    const double a = phase(), b = phase(), c = phase();
    for (std::int64_t m = 0; m < nx * ny; ++m) {
      const double x = static_cast<double>(m % nx) / static_cast<double>(nx),
                   y = static_cast<double>(m / nx) / static_cast<double>(ny);
      s.gaps.push_back(3 - std::cos(6.2832 * 3 * x + a) * std::cos(6.2832 * 2 * y + b) - std::cos(6.2832 * (x + y) + c) +
                       0.3 * static_cast<double>(random() % 1000) * 1e-3);
    }
    const double lowest = *std::min_element(s.gaps.end() - static_cast<std::ptrdiff_t>(nx * ny), s.gaps.end());
    for (std::int64_t k = 0; k < steps; ++k) {
      const double share = k + 1 < steps || steps == 1 ? 0.4 + 0.3 * static_cast<double>(k) : 0.3;
      s.targets.push_back(control == RC_CONTROL_LOAD ? share * 0.01 * static_cast<double>((i + 1) * nx * ny) : lowest + share);
    }
  }
  return s;
}

struct Found {
  rc_status status = RC_OK;
  std::string words;
  std::int64_t certified = 0, first = 0, calls = 0, to_device = 0, to_host = 0;
  std::vector<double> load, approach, area, certificate, p;
  std::vector<rc_status> statuses;
  std::vector<std::int64_t> iterations, applications;
};

using Change = std::function<void(rc_batch&)>;

Found solved(const Scene& s, const Contact& context, int threads = 1, const Change& change = {}) {
  Found f;
  const auto slots = static_cast<std::size_t>(s.n * s.steps);
  for (std::vector<double>* const each : {&f.load, &f.approach, &f.area, &f.certificate}) each->assign(slots, untouched);
  f.p.assign(static_cast<std::size_t>(s.n) * s.points(), untouched);
  f.statuses.assign(slots, -7);
  f.iterations.assign(slots, -7);
  f.applications.assign(slots, -7);
  rc_batch b = RC_BATCH_INIT;
  b.control = s.control;
  b.warm_start = s.warm;
  b.n = s.n;
  b.steps = s.steps;
  b.targets = s.targets.data();
  b.undeformed_gap = s.gaps.data();
  b.mask = s.masks.empty() ? nullptr : s.masks.data();
  b.p0 = s.p0.empty() ? nullptr : s.p0.data();
  b.p = f.p.data();
  b.load = f.load.data();
  b.approach = f.approach.data();
  b.contact_area = f.area.data();
  b.certificate = f.certificate.data();
  b.status = f.statuses.data();
  b.iterations = f.iterations.data();
  b.applications = f.applications.data();
  if (change) change(b);
  auto* const options = const_cast<rc_options*>(context.options());
  assert_int_equal(rc_options_set_int(options, RC_OPT_THREADS, threads), RC_OK);
  assert_int_equal(rc_options_set_real(options, RC_OPT_TOL, tol), RC_OK);
  if (host_faults().fault == Fault::none) host_faults() = {.fault = Fault::once, .at = 0};  // counts calls
  f.status = rc_batch_solve(&s.system, options, &b);
  f.calls = host_faults().calls;
  f.to_device = host_faults().to_device;
  f.to_host = host_faults().to_host;
  host_faults() = {};
  f.words = rc_last_error();
  f.certified = b.certified;
  f.first = b.first;
  return f;
}

std::int32_t goes_on(std::int64_t, std::int64_t, const rc_result*, void*) { return 0; }

// With a callback, which wants more than is told of many: one at a time.
Found one_at_a_time(const Scene& s, const Contact& context) {
  return solved(s, context, 1, [](rc_batch& b) { b.fn = goes_on; });
}

double most_of(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double allowed, const char* what) {
  assert_int_equal(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= allowed))
      fail_msg("%s %zu: %.15g and %.15g, more than %g apart", what, i, a[i], b[i], allowed);
}

void expect_same(const Found& a, const Found& b) {
  assert_true(a.p == b.p && a.load == b.load && a.approach == b.approach && a.area == b.area && a.certificate == b.certificate);
  assert_true(a.statuses == b.statuses && a.iterations == b.iterations && a.applications == b.applications);
}

// The library's own certificate of the answer's pressures.
void expect_certified(const Scene& s, const Found& found, const Contact& context) {
  for (std::int64_t i = 0; i < s.n; ++i) {
    rc_contact* contact = nullptr;
    assert_int_equal(rc_contact_create(&s.system, context.options(), &contact), RC_OK);
    rc_step step = RC_STEP_INIT;
    step.control = s.control;
    step.target = s.targets[static_cast<std::size_t>((i + 1) * s.steps - 1)];
    step.undeformed_gap = s.gaps.data() + static_cast<std::size_t>(i) * s.points();
    step.mask = s.masks.empty() ? nullptr : s.masks.data() + static_cast<std::size_t>(i) * s.points();
    std::vector<double> p(found.p.begin() + i * static_cast<std::int64_t>(s.points()),
                          found.p.begin() + (i + 1) * static_cast<std::int64_t>(s.points()));
    rc_result result = RC_RESULT_INIT;
    result.p = p.data();
    if (rc_contact_certify(contact, &step, &result) != RC_OK) fail_msg("contact %d: %s", static_cast<int>(i), rc_last_error());
    const auto last = static_cast<std::size_t>((i + 1) * s.steps - 1);
    const double all = std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
    // By load the library takes the approach that fits best.
    if (s.control == RC_CONTROL_DISPLACEMENT && !(std::abs(all - found.certificate[last]) <= 1e-3 * tol))
      fail_msg("contact %d: the library finds %g, was told %g", static_cast<int>(i), all, found.certificate[last]);
    rc_contact_destroy(contact);
  }
}

void expect_as_one_at_a_time(const Scene& s, const char* name) {
  const Contact context;
  const Found many = solved(s, context), one = one_at_a_time(s, context);
  if (many.status != RC_OK || one.status != RC_OK) fail_msg("%s: %s / %s", name, many.words.c_str(), one.words.c_str());
  std::int64_t products[2] = {0, 0};
  for (const std::int64_t each : many.applications) products[0] += each;
  for (const std::int64_t each : one.applications) products[1] += each;
  std::printf("%s: %lld products, one at a time %lld; %lld calls, one at a time %lld\n", name,
              static_cast<long long>(products[0]), static_cast<long long>(products[1]), static_cast<long long>(many.calls),
              static_cast<long long>(one.calls));
  assert_int_equal(many.certified, s.n);
  assert_true(many.calls < few_calls && one.calls > few_calls);
  expect_near(many.load, one.load, 1e-5 * most_of(one.load), "load");
  expect_near(many.approach, one.approach, 1e-6 * (1 + most_of(one.approach)), "approach");
  expect_near(many.p, one.p, 1e-4 * most_of(one.p), "p");
  for (const double each : many.certificate) assert_true(each >= 0 && each <= tol);
  if (s.system.hardness == 0 || s.steps == 1) expect_certified(s, many, context);
}

void answers_are_those_of_contacts_one_at_a_time(void**) {
  const std::pair<std::int64_t, std::int64_t> sizes[] = {{24, 24}, {17, 30}, {64, 64}, {1, 40}, {36, 1}, {3, 2}};
  for (const auto& [nx, ny] : sizes)
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      for (const std::int32_t control : {RC_CONTROL_DISPLACEMENT, RC_CONTROL_LOAD}) {
        if (boundary == RC_BOUNDARY_PERIODIC && nx == 17) continue;  // no transform of that length
        Scene s = scene_of(nx, ny, boundary, control);
        char name[64];
        std::snprintf(name, sizeof name, "%dx%d, %s, %s", static_cast<int>(nx), static_cast<int>(ny),
                      boundary == RC_BOUNDARY_FREE ? "free" : "periodic", control == RC_CONTROL_LOAD ? "load" : "approach");
        expect_as_one_at_a_time(s, name);
      }
}

void masks_belong_to_their_contacts(void**) {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int32_t control : {RC_CONTROL_DISPLACEMENT, RC_CONTROL_LOAD}) {
      Scene s = scene_of(24, 20, boundary, control);
      s.masks.assign(s.gaps.size(), 1);
      for (std::size_t m = 0; m < s.masks.size(); ++m)
        if (m / s.points() % 2 == 1 && (m / 5) % 3 == 0) {
          s.masks[m] = 0;
          s.gaps[m] = std::nan("");  // means nothing there
        }
      expect_as_one_at_a_time(s, "masks");
    }
}

void histories_start_from_the_step_before(void**) {
  for (const bool warm : {true, false})
    for (const std::int32_t control : {RC_CONTROL_DISPLACEMENT, RC_CONTROL_LOAD}) {
      Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, control, 4);
      s.warm = warm;
      s.targets[1] = control == RC_CONTROL_LOAD ? 0 : -10;  // nothing touches there
      s.targets[6] = s.targets[5];                          // what is solved already
      expect_as_one_at_a_time(s, warm ? "warm history" : "cold history");
      if (!warm) continue;
      const Contact context;
      const Found found = solved(s, context);
      assert_int_equal(found.applications[1], 0);
      assert_true(found.load[1] == 0);
      assert_true(3 * found.applications[6] <= found.applications[5]);
    }
}

// Of a history's later steps only targets and records travel.
void pressures_of_a_history_stay_on_the_device(void**) {
  std::int64_t to_device[2], to_host[2];
  const std::int64_t steps[2] = {1, 6};
  const Contact context;
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 6);
  for (int k = 0; k < 2; ++k) {
    s.steps = steps[k];
    host_faults() = {.fault = Fault::once, .at = 0, .counts = true};
    const Found found = solved(s, context, 1, [&](rc_batch& b) { b.target_stride = 6; });
    assert_int_equal(found.status, RC_OK);
    to_device[k] = found.to_device;
    to_host[k] = found.to_host;
  }
  const auto n = static_cast<double>(s.n * static_cast<std::int64_t>(s.points()));
  std::printf("1 step: %.2f bytes a point to the device, %.2f back; 6 steps: %.2f and %.2f\n",
              static_cast<double>(to_device[0]) / n, static_cast<double>(to_host[0]) / n, static_cast<double>(to_device[1]) / n,
              static_cast<double>(to_host[1]) / n);
  assert_int_equal(to_device[1] - to_device[0], 5 * s.n * static_cast<std::int64_t>(sizeof(double)));
  assert_int_equal(to_host[1] - to_host[0], 5 * s.n * static_cast<std::int64_t>(sizeof(rc_many_answer)));
}

void hardness_leaves_an_indentation_between_steps(void**) {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int32_t control : {RC_CONTROL_DISPLACEMENT, RC_CONTROL_LOAD}) {
      Scene s = scene_of(20, 24, boundary, control, 3);
      s.system.hardness = 0.2;
      expect_as_one_at_a_time(s, "hardness");
    }
}

void units_and_long_cells(void**) {
  for (const std::int32_t control : {RC_CONTROL_DISPLACEMENT, RC_CONTROL_LOAD}) {
    Scene s = scene_of(24, 20, RC_BOUNDARY_FREE, control, 2);
    s.system.hx = 2e-6;
    s.system.hy = 1e-6;
    s.system.modulus = 2e11;
    for (double& each : s.gaps) each *= 1e-6;
    for (double& each : s.targets) each *= control == RC_CONTROL_LOAD ? 2e11 * 2e-12 : 1e-6;
    expect_as_one_at_a_time(s, "other units");
  }
}

void options_of_the_solver_hold(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  const Contact context;
  auto* const options = const_cast<rc_options*>(context.options());
  assert_int_equal(rc_options_set_text(options, "haar-cg.products", "double"), RC_OK);
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_OK);
  assert_true(found.calls < few_calls);
  expect_near(found.p, one_at_a_time(s, context).p, 1e-5, "p");
  assert_int_equal(rc_options_set_int(options, RC_OPT_MAX_ITER, 3), RC_OK);
  const Found stopped = solved(s, context);
  assert_int_equal(stopped.status, RC_STOP_MAX_ITER);
  assert_int_equal(stopped.iterations[0], 3);
}

// What of an answer only contacts one at a time have; and another backend's certificate.
void what_asks_for_more_is_solved_one_at_a_time(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  {
    const Contact context;
    std::vector<double> stiffness(static_cast<std::size_t>(s.n));
    const Found found = solved(s, context, 1, [&](rc_batch& b) { b.stiffness = stiffness.data(); });
    assert_int_equal(found.status, RC_OK);
    assert_true(found.calls > few_calls && stiffness[0] > 0);
  }
  {
    Contact context;
    context.use("haar-cuda-host", "dense");
    assert_true(solved(s, context).calls > few_calls);
  }
  {
    Scene prime = scene_of(17, 24, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD);
    const Contact context;
    const Found found = solved(prime, context);
    assert_int_equal(found.status, RC_OK);
    assert_true(found.calls > few_calls);
  }
}

// The plugin with estimates by which "auto" takes it for batches.
const rc_plugin* cheap_for_many() {
  const auto score = [](const rc_facts* facts, rc_estimate* estimate) -> rc_status {
    estimate->seconds = facts->at_once > 1 ? 1e-12 : 1;
    estimate->product = 1;
    return RC_OK;
  };
  static rc_backend backend = *plugin()->backends[0];
  static rc_solver solver = *plugin()->solvers[0];
  static const rc_backend* const backends[] = {&backend};
  static const rc_solver* const solvers[] = {&solver};
  static rc_plugin cheap = *plugin();
  backend.score = score;
  solver.score = [](const rc_facts* facts, rc_estimate* estimate) -> rc_status {
    estimate->seconds = facts->backend->seconds;
    return RC_OK;
  };
  cheap.backends = backends;
  cheap.solvers = solvers;
  return &cheap;
}

void auto_takes_many_by_what_each_costs(void**) {
  const Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  Contact context(1048576, side, cheap_for_many());
  context.use("auto", "auto");
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_OK);
  assert_true(found.calls > 0 && found.calls < few_calls);
}

void failures_are_their_contacts_own(void**) {
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_DISPLACEMENT, 2);
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
  Scene mean = scene_of(24, 24, RC_BOUNDARY_PERIODIC, RC_CONTROL_DISPLACEMENT);
  mean.targets[2] = 4;
  assert_int_equal(solved(mean, context).statuses[2], RC_ERR_INFEASIBLE);
  Scene none = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  none.masks.assign(none.gaps.size(), 1);
  std::fill_n(none.masks.begin(), none.points(), 0);
  assert_int_equal(solved(none, context).statuses[0], RC_ERR_INFEASIBLE);
}

void pressures_to_start_from(void**) {
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD);
  const Contact context;
  const Found cold = solved(s, context);
  s.p0 = cold.p;
  const Found warm = solved(s, context);
  for (std::size_t i = 0; i < warm.applications.size(); ++i) assert_true(3 * warm.applications[i] <= cold.applications[i]);
  std::vector<double> p = cold.p;
  Found in_place = solved(s, context, 1, [&](rc_batch& b) {
    b.p0 = p.data();
    b.p = p.data();
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
                b.undeformed_gap = wide.data();
                b.undeformed_gap_stride = static_cast<std::int64_t>(s.points()) + 13;
              }));
  const Found shared = solved(s, context, 1, [&](rc_batch& b) { b.undeformed_gap_stride = RC_BATCH_SHARED; });
  assert_int_equal(shared.status, RC_OK);
  assert_true(shared.calls < few_calls);
  assert_true(shared.load[0] == plain.load[0] && shared.approach[1] == plain.approach[1]);
}

// However they are shared among threads and calls.
void bits_are_the_same_however_many_are_taken_at_once(void**) {
  Scene s = scene_of(24, 24, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 2);
  const Contact context;
  const Found found = solved(s, context);
  for (const int threads : {2, 3}) expect_same(found, solved(s, context, threads));
  for (const double limit : {0.19, 0.17, 0.15}) {  // [MiB]
    const Contact little(limit);
    const Found parts = solved(s, little);
    if (parts.status != RC_OK) fail_msg("%g MiB: %s", limit, parts.words.c_str());
    std::printf("%g MiB: %lld calls\n", limit, static_cast<long long>(parts.calls));
    expect_same(found, parts);
  }
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
  assert_true(all.calls == plain.calls && all.calls < few_calls);
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
  assert_int_equal(rc_options_set_real(options, RC_OPT_TIME_LIMIT, 1e-9), RC_OK);
  const Found found = solved(s, context);
  assert_int_equal(found.status, RC_STOP_TIME);
  assert_int_equal(found.certified, 0);
  expect_untouched(found.p);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(answers_are_those_of_contacts_one_at_a_time),
                              cmocka_unit_test(masks_belong_to_their_contacts),
                              cmocka_unit_test(histories_start_from_the_step_before),
                              cmocka_unit_test(pressures_of_a_history_stay_on_the_device),
                              cmocka_unit_test(hardness_leaves_an_indentation_between_steps),
                              cmocka_unit_test(units_and_long_cells),
                              cmocka_unit_test(options_of_the_solver_hold),
                              cmocka_unit_test(what_asks_for_more_is_solved_one_at_a_time),
                              cmocka_unit_test(auto_takes_many_by_what_each_costs),
                              cmocka_unit_test(failures_are_their_contacts_own),
                              cmocka_unit_test(infeasible_targets_are_told_one_at_a_time),
                              cmocka_unit_test(pressures_to_start_from),
                              cmocka_unit_test(strides_and_shared_arrays),
                              cmocka_unit_test(bits_are_the_same_however_many_are_taken_at_once),
                              cmocka_unit_test(any_call_may_fail_in_the_middle_of_a_batch),
                              cmocka_unit_test(progress_hears_of_parts),
                              cmocka_unit_test(progress_ends_a_batch_between_parts),
                              cmocka_unit_test(too_little_memory_for_one),
                              cmocka_unit_test(a_batch_ends_in_time)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
