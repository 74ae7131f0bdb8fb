#include "batch.h"

#include <cstring>
#include <ctime>
#include <iostream>

#include "library.h"
#include "rough_surface.h"
#include "stopwatch.h"
#include "table.h"

namespace bench {

namespace {

constexpr std::int64_t block = 40;  // surfaces that are in memory at a time; one thread and several take turns on them

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Surfaces first, first + 1, ... with ten increasing approaches up to half the mean gap, or with the loads found there.
struct Block {
  std::int64_t n = 0;
  Field gaps, targets;
};

Block block_of(const BatchRequest& request, std::int64_t first, std::int64_t n) {
  SurfaceClass rough{"roll-off at 4 waves"};
  rough.hurst = 0.8;
  rough.roll_off = 4;
  Block result{n, {}, {}};
  for (std::int64_t i = 0; i < n; ++i) {
    const Field gap = gap_below_highest(rough.heights(request.points, static_cast<std::uint64_t>(first + i + 1)));
    result.gaps.insert(result.gaps.end(), gap.begin(), gap.end());
    for (std::int64_t k = 1; k <= request.steps; ++k)
      result.targets.push_back(0.5 * mean_of(gap) * static_cast<double>(k) / static_cast<double>(request.steps));
  }
  return result;
}

// What one way of solving needed for all blocks.
struct Total {
  double seconds = 0, cpu = 0;
  std::int64_t certified = 0;  // surfaces
  std::int64_t products = 0;
  rc_status status = RC_OK;
};

Options options_of(const BatchRequest& request, std::int64_t threads) {
  Options options;
  options.set(RC_OPT_SOLVER, request.solver).set(RC_OPT_BACKEND, request.backend).set(RC_OPT_TOL, request.tol);
  options.set(RC_OPT_THREADS, static_cast<double>(threads));
  return options;
}

Field solve(const BatchRequest& request, const Block& contacts, std::int32_t control, std::int64_t threads, Total& total) {
  const auto slots = static_cast<std::size_t>(contacts.n * request.steps);
  Field load(slots);
  std::vector<std::int64_t> applications(slots);
  rc_batch batch = RC_BATCH_INIT;
  batch.control = control;
  batch.n = contacts.n;
  batch.steps = request.steps;
  batch.targets = contacts.targets.data();
  batch.gap = contacts.gaps.data();
  batch.load = load.data();
  batch.applications = applications.data();
  const rc_system system = unit_square(request.points);
  const Options options = options_of(request, threads);
  const double cpu = cpu_seconds();
  const auto start = Clock::now();
  const rc_status status = check(rc_batch_solve(&system, options.get(), &batch));
  total.seconds += seconds_since(start);
  total.cpu += cpu_seconds() - cpu;
  total.certified += batch.certified;
  for (const std::int64_t each : applications) total.products += std::max<std::int64_t>(each, 0);
  if (total.status == RC_OK) total.status = status;
  return load;
}

Json row_of(const BatchRequest& request, std::int64_t threads, const Total& total) {
  const double solves = static_cast<double>(request.surfaces * request.steps);
  return {{"threads", threads},
          {"surfaces", request.surfaces},
          {"n", request.points},
          {"steps", request.steps},
          {"control", request.control},
          {"solver", request.solver},
          {"backend", request.backend},
          {"tol", request.tol},
          {"seconds", total.seconds},
          {"cpu_seconds", total.cpu},
          {"surfaces_per_second", static_cast<double>(request.surfaces) / total.seconds},
          {"solves_per_second", solves / total.seconds},
          {"products", total.products},
          {"certified", total.certified},
          {"status", rc_status_name(total.status)}};
}

const std::vector<Column> columns = {{"threads", "threads"},
                                     {"surfaces", "surfaces"},
                                     {"n", "n"},
                                     {"steps", "steps"},
                                     {"control", "control"},
                                     {"s", "seconds", "%.2f"},
                                     {"CPU s", "cpu_seconds", "%.2f"},
                                     {"surfaces/s", "surfaces_per_second", "%.1f"},
                                     {"solves/s", "solves_per_second", "%.1f"},
                                     {"products", "products"},
                                     {"certified", "certified"},
                                     {"status", "status"}};

}  // namespace

Json run_batch(const BatchRequest& request) {
  const bool by_load = request.control == "load";
  Total approaches, one, several;
  for (std::int64_t first = 0; first < request.surfaces; first += block) {
    Block contacts = block_of(request, first, std::min(block, request.surfaces - first));
    if (by_load) contacts.targets = solve(request, contacts, RC_CONTROL_DISPLACEMENT, request.threads, approaches);
    const std::int32_t control = by_load ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
    Field alone, shared;
    // Who comes first changes from block to block.
    const bool even = first / block % 2 == 0;
    if (even) alone = solve(request, contacts, control, 1, one);
    shared = solve(request, contacts, control, request.threads, several);
    if (!even) alone = solve(request, contacts, control, 1, one);
    if (std::memcmp(alone.data(), shared.data(), alone.size() * sizeof(double)) != 0)
      throw Failure("loads depend on the number of threads");
    std::cerr << first + contacts.n << " of " << request.surfaces << " surfaces\n";
  }
  const Json rows = {row_of(request, 1, one), row_of(request, request.threads, several)};
  const double scaling = one.seconds / several.seconds, growth = several.cpu / one.cpu;
  std::cout << table(columns, rows) << "\n"
            << request.threads << " threads: " << scaling << " times as fast as one, with " << growth << " of its CPU time\n";
  return {{"batch", rows}, {"scaling", scaling}, {"cpu_growth", growth}};
}

}  // namespace bench
