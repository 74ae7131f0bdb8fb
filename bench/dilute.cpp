#include "dilute.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "dilute_solves.h"
#include "library.h"
#include "scene.h"
#include "stopwatch.h"
#include "table.h"

namespace bench {

namespace {

// The trial set that a solver works on holds the contact and about three times as many points around it.
constexpr double trial_points_per_contact = 4;

// rc_solver::solve has no user pointer.
struct Timing {
  double budget = 0;
  std::int64_t contacts = 0, points = 0;
  double first = 0;  // seconds of the first product, with the set-up
  CallTimes in_double, in_float;
  Field y;
};
thread_local Timing timing;

// The pressure is the compenetration's excess over what three quarters of the trial set have.
rc_status multiply(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  const auto n = static_cast<std::size_t>(problem->n);
  Field sorted(problem->u, problem->u + n), x(n);
  const auto level = sorted.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(n) * (1 - 1 / trial_points_per_contact));
  std::nth_element(sorted.begin(), level, sorted.end());
  for (std::size_t i = 0; i < n; ++i) x[i] = std::max(0.0, problem->u[i] - *level);
  timing.points = problem->n;
  timing.contacts = static_cast<std::int64_t>(n) - std::count(x.begin(), x.end(), 0.0);
  timing.y.resize(n);
  rc_status status = RC_OK;
  const auto start = Clock::now();
  status = problem->apply(problem, x.data(), timing.y.data());
  timing.first = seconds_since(start);
  timing.in_double = time_calls(timing.budget, [&] {
    if (status == RC_OK) status = problem->apply(problem, x.data(), timing.y.data());
  });
  if (problem->apply_float) {
    const std::vector<float> single(x.begin(), x.end());
    std::vector<float> product(n);
    timing.in_float = time_calls(timing.budget, [&] {
      if (status == RC_OK) status = problem->apply_float(problem, single.data(), product.data());
    });
  }
  return status == RC_OK ? RC_STOP_CANCELLED : status;
}

const rc_solver timer = {
    sizeof(rc_solver), "dilute-timer", "times products, solves nothing", "BSD-3-Clause", 0, RC_CONTROL_DISPLACEMENT, 0, 0,
    nullptr,           multiply};
const rc_solver* const solvers[] = {&timer};
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "dilute-timer", "1", 0, 1, nullptr, solvers};

Timing timed(const Field& gap, std::int64_t n, double approach, const char* backend, std::int64_t threads, double budget) {
  Context context;
  context.add(plugin);
  Options options(context.get());
  options.set(RC_OPT_SOLVER, timer.name).set(RC_OPT_BACKEND, backend).set(RC_OPT_THREADS, static_cast<double>(threads));
  rc_step step = RC_STEP_INIT;
  step.gap = gap.data();
  step.target = approach;
  timing = {};
  timing.budget = budget;
  Contact(unit_square(n), options).solve(step);
  return std::move(timing);
}

double difference(const Field& a, const Field& b) {
  double off = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    off = std::max(off, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return off / largest;
}

const std::vector<Column> columns = {{"n", "n"},
                                     {"contact %", "contact_percent", "%.3f"},
                                     {"contacts", "contacts"},
                                     {"points", "points"},
                                     {"threads", "threads"},
                                     {"fft ms", "fft_ms", "%.2f"},
                                     {"split ms", "split_ms", "%.2f"},
                                     {"ratio", "ratio", "%.1f"},
                                     {"fft float ms", "fft_float_ms", "%.2f"},
                                     {"split float ms", "split_float_ms", "%.2f"},
                                     {"ratio", "float_ratio", "%.1f"},
                                     {"first fft ms", "fft_first_ms", "%.1f"},
                                     {"first split ms", "split_first_ms", "%.1f"},
                                     {"difference", "difference", "%.1e"}};

Json row_of(std::int64_t n, std::int64_t threads, const Timing& fft, const Timing& split) {
  Json row = {{"n", n},
              {"contact_percent", 100.0 * static_cast<double>(split.contacts) / static_cast<double>(n * n)},
              {"contacts", split.contacts},
              {"points", split.points},
              {"threads", threads},
              {"fft_ms", 1e3 * fft.in_double.best},
              {"split_ms", 1e3 * split.in_double.best},
              {"ratio", fft.in_double.best / split.in_double.best},
              {"fft_first_ms", 1e3 * fft.first},
              {"split_first_ms", 1e3 * split.first},
              {"split_float_ms", 1e3 * split.in_float.best},
              {"difference", difference(split.y, fft.y)}};
  if (fft.in_float.count > 0) {
    row["fft_float_ms"] = 1e3 * fft.in_float.best;
    row["float_ratio"] = fft.in_float.best / split.in_float.best;
  }
  return row;
}

}  // namespace

namespace {

Json dilute_products(const DiluteRequest& request) {
  Json rows = Json::array();
  std::vector<std::int64_t> threads{1};
  if (request.threads > 1) threads.push_back(request.threads);
  for (const std::int64_t n : request.sizes) {
    SelfAffine surface;
    surface.seed = request.seed;
    surface.roll_off = 12;  // so that the contacts are all over the grid
    surface.cut_off = static_cast<double>(n) / 3;
    const Field gap = self_affine_gap(n, surface);
    Field sorted = gap;
    for (const double contact : request.contacts) {
      const double points = static_cast<double>(gap.size()) * contact * trial_points_per_contact;
      const auto level = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(points, static_cast<double>(gap.size() - 1)));
      std::nth_element(sorted.begin(), level, sorted.end());
      for (const std::int64_t count : threads) {
        const Timing fft = timed(gap, n, *level, "fft", count, request.budget);
        const Timing split = timed(gap, n, *level, "split", count, request.budget);
        rows.push_back(row_of(n, count, fft, split));
        std::cerr << n << " points a side, " << 100 * contact << " %, " << count << " threads\n";
      }
    }
  }
  std::cout << "Products\n" << table(columns, rows);
  return rows;
}

}  // namespace

Json run_dilute(const DiluteRequest& request) {
  Json document;
  if (request.products) document["dilute"] = dilute_products(request);
  if (request.solves) document["solves"] = dilute_solves(request);
  return document;
}

}  // namespace bench
