// device_solves N CONTROL TOL SOLVER BACKEND THREADS RUNS: cold solves of a rough surface of N x N points with a tenth in
// contact. device_solves batch COUNT SOLVER BACKEND THREADS: that many contacts of 64 x 64 points by one rc_batch_solve. One line
// of JSON. bench/device.sh runs it.
#include <roughcontact/history.h>
#include <roughcontact/registry.h>
#include <roughcontact/roughcontact.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return '"' + text + '"';
}

[[noreturn]] void refuse(const char* what) {
  std::printf("{\"failed\": %s}\n", quoted(std::string(what) + ": " + rc_last_error()).c_str());
  std::exit(0);
}

struct Wave {
  double x, y, phase, amplitude;  // cycles along each side
};

// Waves of 2 cycles to n/8 along the side, with heights that fall as a self-affine surface's of Hurst exponent 0.8.
std::vector<Wave> waves(std::int64_t n, unsigned seed) {
  std::vector<Wave> all;
  std::uint64_t state = seed;
  const auto uniform = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-53;
  };
  for (double k = 2; k <= static_cast<double>(n) / 8; k *= 1.3)
    for (int i = 0; i < 3; ++i) {
      const double angle = std::numbers::pi * uniform();
      all.push_back({std::round(k * std::cos(angle)), std::round(k * std::sin(angle)), 2 * std::numbers::pi * uniform(),
                     std::pow(k, -0.8)});
    }
  return all;
}

double slope_of(const std::vector<Wave>& all) {
  double square = 0;
  for (const Wave& w : all) square += 0.5 * std::pow(2 * std::numbers::pi * w.amplitude, 2) * (w.x * w.x + w.y * w.y);
  return std::sqrt(square);
}

// The gap over the unit square. cos(a + b) by tables of each axis.
void fill_gap(std::int64_t n, const std::vector<Wave>& all, double* gap) {
  const auto count = static_cast<std::size_t>(n);
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::vector<double> tables(4 * all.size() * count);
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < count; ++i) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      double* const at = tables.data() + 4 * (k * count + i);
      at[0] = std::cos(all[k].x * turn + all[k].phase);
      at[1] = std::sin(all[k].x * turn + all[k].phase);
      at[2] = all[k].amplitude * std::cos(all[k].y * turn);
      at[3] = all[k].amplitude * std::sin(all[k].y * turn);
    }
  std::vector<double> lowest(threads, 1e300);
  std::vector<std::thread> team;
  for (std::size_t t = 0; t < threads; ++t)
    team.emplace_back([&, t] {
      for (std::size_t y = t; y < count; y += threads) {
        double* const row = gap + y * count;
        std::fill_n(row, count, 0.0);
        for (std::size_t k = 0; k < all.size(); ++k) {
          const double* const of = tables.data() + 4 * k * count;
          const double c = of[4 * y + 2], s = of[4 * y + 3];
          for (std::size_t x = 0; x < count; ++x) row[x] += of[4 * x] * c - of[4 * x + 1] * s;
        }
        for (std::size_t x = 0; x < count; ++x) lowest[t] = std::min(lowest[t], row[x]);
      }
    });
  for (std::thread& each : team) each.join();
  const double least = *std::min_element(lowest.begin(), lowest.end());
  for (std::size_t i = 0; i < count * count; ++i) gap[i] -= least;
}

rc_system square(std::int64_t n) {
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = n;
  system.hx = system.hy = 1 / static_cast<double>(n);
  system.modulus = 1;
  return system;
}

// The context's last warning, for example that contacts of a batch were solved one at a time. Several threads may log at once.
struct Warning {
  std::mutex mutex;
  std::string text;
};

rc_options* options_of(const char* solver, const char* backend, int threads, double tol, Warning& warning) {
  rc_context_config config = RC_CONTEXT_CONFIG_INIT;
  config.log = [](std::int32_t level, const char* text, void* user) {
    Warning& last = *static_cast<Warning*>(user);
    const std::lock_guard guarded(last.mutex);
    if (level == RC_LOG_WARNING) last.text = text;
  };
  config.log_user = &warning;
  rc_context* context = nullptr;
  rc_options* options = nullptr;
  if (rc_context_create(&config, &context) != RC_OK || rc_options_create(context, &options) != RC_OK ||
      rc_options_set_text(options, RC_OPT_SOLVER, solver) != RC_OK ||
      rc_options_set_text(options, RC_OPT_BACKEND, backend) != RC_OK ||
      rc_options_set_int(options, RC_OPT_THREADS, threads) != RC_OK || rc_options_set_real(options, RC_OPT_TOL, tol) != RC_OK)
    refuse("options");
  rc_context_destroy(context);  // the options keep what they need
  return options;
}

// A tenth of a surface of this slope touches at about this mean pressure, in units of the contact modulus.
double load_of_a_tenth(double slope) { return 0.1 * slope / 2; }

int solve(char** argv) {
  const std::int64_t n = std::atoll(argv[1]);
  const bool by_load = std::strcmp(argv[2], "load") == 0;
  const double tol = std::atof(argv[3]);
  const int runs = std::atoi(argv[7]);
  const rc_system system = square(n);
  const std::vector<Wave> all = waves(n, 1);
  std::vector<double> gap(static_cast<std::size_t>(n * n));
  fill_gap(n, all, gap.data());
  Warning warning;
  rc_options* const options = options_of(argv[4], argv[5], std::atoi(argv[6]), tol, warning);
  rc_contact* contact = nullptr;
  if (rc_contact_create(&system, options, &contact) != RC_OK) refuse("rc_contact_create");
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_LOAD;
  step.target = load_of_a_tenth(slope_of(all));
  step.undeformed_gap = gap.data();
  step.borrow = 1;
  step.warm_start = 0;
  rc_result result = RC_RESULT_INIT;
  std::vector<double> pressures(gap.size());
  result.p = pressures.data();
  double first = 0, best = 1e300;
  for (int run = 0; run < runs + (by_load ? 0 : 1); ++run) {
    const auto begin = std::chrono::steady_clock::now();
    if (rc_contact_solve(contact, &step, &result) < 0) refuse("rc_contact_solve");
    const double taken = seconds_since(begin);
    if (run == 0) first = taken;
    if (!by_load && run == 0) {  // the approach of that load is the target of the runs that count
      step.control = RC_CONTROL_APPROACH;
      step.target = result.approach;
      continue;
    }
    if (run > 0 || runs == 1) best = std::min(best, taken);
  }
  std::printf(
      "{\"n\": %lld, \"control\": \"%s\", \"tol\": %g, \"solver\": \"%s\", \"backend\": \"%s\", \"threads\": %s, \"status\": "
      "\"%s\", \"first_seconds\": %.6f, \"seconds\": %.6f, \"products\": %lld, \"iterations\": %lld, \"area\": %.5f, "
      "\"residual\": %.2e, \"warning\": %s}\n",
      static_cast<long long>(n), argv[2], tol, result.solver, result.backend, argv[6], rc_status_name(result.status), first, best,
      static_cast<long long>(result.products), static_cast<long long>(result.iterations),
      static_cast<double>(result.contacts) / static_cast<double>(n * n), std::max(result.kkt_primal, result.kkt_dual),
      quoted(warning.text).c_str());
  rc_contact_destroy(contact);
  rc_options_destroy(options);
  return 0;
}

int solve_batch(char** argv) {
  constexpr std::int64_t n = 64, surfaces = 64;
  const std::int64_t count = std::atoll(argv[2]);
  const rc_system system = square(n);
  std::vector<double> gaps(static_cast<std::size_t>(count * n * n)), targets;
  for (std::int64_t i = 0; i < count; ++i) {
    double* const gap = gaps.data() + i * n * n;
    if (i < surfaces)
      fill_gap(n, waves(n, static_cast<unsigned>(i + 1)), gap);
    else
      std::copy_n(gaps.data() + i % surfaces * n * n, n * n, gap);
    targets.push_back(load_of_a_tenth(slope_of(waves(n, 1))));
  }
  Warning warning;
  rc_options* const options = options_of(argv[3], argv[4], std::atoi(argv[5]), 1e-8, warning);
  rc_batch batch = RC_BATCH_INIT;
  batch.control = RC_CONTROL_LOAD;
  batch.n = count;
  batch.steps = 1;
  batch.targets = targets.data();
  batch.undeformed_gap = gaps.data();
  double first = 0, best = 1e300;
  for (int run = 0; run < 4; ++run) {  // the first one sets the device up
    const auto begin = std::chrono::steady_clock::now();
    if (rc_batch_solve(&system, options, &batch) < 0) refuse("rc_batch_solve");
    const double taken = seconds_since(begin);
    (run == 0 ? first : best) = run == 0 ? taken : std::min(best, taken);
  }
  std::printf(
      "{\"batch\": %lld, \"n\": %lld, \"solver\": \"%s\", \"backend\": \"%s\", \"threads\": %s, \"certified\": %lld, "
      "\"first_seconds\": %.6f, \"seconds\": %.6f, \"solves_per_second\": %.1f, \"warning\": %s}\n",
      static_cast<long long>(count), static_cast<long long>(n), argv[3], argv[4], argv[5],
      static_cast<long long>(batch.certified), first, best, static_cast<double>(count) / best, quoted(warning.text).c_str());
  rc_options_destroy(options);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 6 && std::strcmp(argv[1], "batch") == 0) return solve_batch(argv);
  if (argc == 8) return solve(argv);
  std::fprintf(stderr, "usage: %s N load|approach TOL SOLVER BACKEND THREADS RUNS | batch COUNT SOLVER BACKEND THREADS\n",
               argv[0]);
  return 2;
}
