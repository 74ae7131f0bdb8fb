// Many small contacts at once on the host build of the plugin for devices.
#pragma once

#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "scene.h"

namespace device::many {

using rc_cuda::Fault, rc_cuda::host_faults;

constexpr double tol = 1e-8;
// Contacts on one grid, each with a surface and a history of its own.
struct Scene {
  rc_system system = grid_of(24);
  std::int32_t control = RC_CONTROL_APPROACH;
  std::int64_t n = 5, steps = 1;
  bool warm = true;
  std::vector<double> gaps, targets, p0;
  std::vector<std::uint8_t> masks;

  std::size_t points() const { return static_cast<std::size_t>(system.nx * system.ny); }
  // The most calls of the CUDA runtime that a batch makes for all its contacts together; one step of a contact by itself makes
  // hundreds.
  std::int64_t few_calls() const { return 150 * steps; }
};

inline Scene scene_of(std::int64_t nx, std::int64_t ny, std::int32_t boundary, std::int32_t control, std::int64_t steps = 1) {
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
  std::int64_t certified = 0, first = 0, calls = 0;
  std::vector<double> load, approach, area, certificate, p;
  std::vector<rc_status> statuses;
  std::vector<std::int64_t> iterations, products;
};

using Change = std::function<void(rc_batch&)>;

inline Found solved(const Scene& s, const Contact& context, int threads = 1, const Change& change = {}) {
  Found f;
  const auto slots = static_cast<std::size_t>(s.n * s.steps);
  for (std::vector<double>* const each : {&f.load, &f.approach, &f.area, &f.certificate}) each->assign(slots, untouched);
  f.p.assign(static_cast<std::size_t>(s.n) * s.points(), untouched);
  f.statuses.assign(slots, -7);
  f.iterations.assign(slots, -7);
  f.products.assign(slots, -7);
  rc_batch b = RC_BATCH_INIT;
  b.control = s.control;
  b.warm_start = s.warm;
  b.n = s.n;
  b.steps = s.steps;
  b.targets = RC_IN(s.targets.data());
  b.undeformed_gap = RC_IN(s.gaps.data());
  b.mask = RC_IN(s.masks.empty() ? nullptr : s.masks.data());
  b.p0 = RC_IN(s.p0.empty() ? nullptr : s.p0.data());
  b.p = RC_OUT(f.p.data());
  b.columns.load = RC_OUT(f.load.data());
  b.columns.approach = RC_OUT(f.approach.data());
  b.columns.contact_area = RC_OUT(f.area.data());
  b.columns.certificate = RC_OUT(f.certificate.data());
  b.columns.status = RC_OUT(f.statuses.data());
  b.columns.iterations = RC_OUT(f.iterations.data());
  b.columns.products = RC_OUT(f.products.data());
  if (change) change(b);
  auto* const options = const_cast<rc_options*>(context.options());
  assert_int_equal(rc_options_set_number(options, RC_OPT_THREADS, threads), RC_OK);
  assert_int_equal(rc_options_set_number(options, RC_OPT_TOL, tol), RC_OK);
  if (host_faults().fault == Fault::none) host_faults() = {.fault = Fault::once, .at = 0};  // counts calls
  f.status = rc_batch_solve(&s.system, options, &b);
  f.calls = host_faults().calls;
  host_faults() = {};
  f.words = rc_last_error();
  f.certified = b.certified;
  f.first = b.first;
  return f;
}

inline std::int32_t goes_on(std::int64_t, std::int64_t, const rc_result*, void*) { return 0; }

// With a callback, which wants more than many give: one at a time.
inline Found one_at_a_time(const Scene& s, const Contact& context) {
  return solved(s, context, 1, [](rc_batch& b) { b.fn = goes_on; });
}

inline double most_of(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

inline void expect_near(const std::vector<double>& a, const std::vector<double>& b, double allowed, const char* what) {
  assert_int_equal(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= allowed))
      fail_msg("%s %zu: %.15g and %.15g, more than %g apart", what, i, a[i], b[i], allowed);
}

inline void expect_same(const Found& a, const Found& b) {
  assert_true(a.p == b.p && a.load == b.load && a.approach == b.approach && a.area == b.area && a.certificate == b.certificate);
  assert_true(a.statuses == b.statuses && a.iterations == b.iterations && a.products == b.products);
}

}  // namespace device::many
