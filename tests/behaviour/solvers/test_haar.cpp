// haar-cg: all numbers of threads and starts lead to one answer; its counts of products stay within limits for every
// share of contact; and where it stalls an exact solver takes over and is named.
#include <roughcontact/surface.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <tuple>

#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

const Pair haar{"haar-cg", "fft"};
constexpr std::int64_t side = 256;

double share_in_contact(const Answer& answer) {
  return static_cast<double>(answer.result.contacts) / static_cast<double>(answer.result.points);
}

void same_bits_for_any_threads(const Problem& problem, const Pair& pair, const char* precision) {
  const auto with = [&](const char* threads) {
    return solved(problem, pair,
                  {{RC_OPT_THREADS, threads},
                   {RC_OPT_TOL, std::string(precision) == "single" ? "1e-5" : "1e-8"},
                   {"fft.precision", precision}});
  };
  const Answer alone = with("1");
  for (const char* threads : {"1", "2", "3"}) {
    const Answer shared = with(threads);
    check_same(shared.p, alone.p, "pressures");
    check_same(shared.gap, alone.gap, "gap");
    check_equal(shared.result.products, alone.result.products, "products");
  }
}

void threads_and_runs_do_not_change_a_bit() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const char* backend : {"fft", "split"})
      for (const std::int32_t control : controls) {
        const Pair pair{"haar-cg", backend};
        Problem problem = rugged_problem(side, side + 3, 0.7, boundary);
        if (!obstacle(pair, problem.system, control).empty()) continue;
        if (control == RC_CONTROL_LOAD) problem = at_load(problem, solved(problem, haar, {{RC_OPT_TOL, "1e-8"}}).result.load);
        same_bits_for_any_threads(problem, pair, "mixed");
        Problem hard = problem;
        hard.system.hardness = 0.5 * largest(solved(problem, haar, {{RC_OPT_TOL, "1e-8"}}).p);
        if (obstacle(pair, hard.system, control).empty()) same_bits_for_any_threads(hard, pair, "mixed");
        if (pair.backend == "fft") same_bits_for_any_threads(problem, pair, "single");
      }
}

void a_coarse_start_saves_products() {
  const Problem problem = rugged_problem(side, side, 0.8);
  const Answer nested = solved(problem, haar), plain = solved(problem, haar, {{"haar-cg.nested", "0"}});
  check_near(nested.p, plain.p, 1e-8, "pressures");
  report("products " + std::to_string(nested.result.products) + " after a coarse start, " +
         std::to_string(plain.result.products) + " without");
  check(nested.result.products < plain.result.products, "the coarse start saves nothing");
}

void load_control_costs_little_more() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const double depth : {0.3, 0.8, 0.995}) {
      const Problem problem = rugged_problem(side, side, depth, boundary);
      const Answer by_approach = solved(problem, haar, {{RC_OPT_TOL, "1e-8"}});
      const Answer by_load = solved(at_load(problem, by_approach.result.load), haar, {{RC_OPT_TOL, "1e-8"}});
      report(text(100 * share_in_contact(by_approach)) + " % in contact: products " +
             std::to_string(by_approach.result.products) + " by approach, " + std::to_string(by_load.result.products) +
             " by load");
      // With a product to confirm each residual a free one takes 26, without blocks across the border a periodic one 39.
      const std::int64_t most = boundary == RC_BOUNDARY_FREE ? 25 : 30;
      check(std::max(by_approach.result.products, by_load.result.products) <= most, "more products than needed");
      check(static_cast<double>(by_load.result.products) <= 1.4 * static_cast<double>(by_approach.result.products),
            "load control takes many more products");
      check(static_cast<double>(by_approach.result.products) <= 1.2 * static_cast<double>(by_load.result.products),
            "a prescribed approach takes many more products");
      check_near(by_load.result.approach, problem.target, 1e-6 * problem.target, "approach");
    }
}

// [nx*ny] gap of a self-affine surface, its shortest wave of so many cells.
Field self_affine(std::int64_t nx, std::int64_t ny, std::uint64_t seed, double shortest) {
  const std::int64_t n = std::max(nx, ny);
  const auto waves = [n](double number) { return 2 * std::numbers::pi * number / static_cast<double>(n); };
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = nx;
  spec.ny = ny;
  spec.hurst = 0.8;
  spec.q_rolloff = waves(4);
  spec.q_high = waves(static_cast<double>(n) / shortest);
  spec.rms_height = 0;
  spec.rms_slope = 0.1;
  Field gap(static_cast<std::size_t>(nx * ny));
  check(rc_surface_spectral(&spec, gap.data()) == RC_OK, rc_surface_last_error());
  for (double& value : gap) value = -value;
  return gap;
}

// Products by load and by approach.
void counts_stay_low(Problem problem, double load) {
  const Answer by_load = solved(at_load(problem, load), haar, {{RC_OPT_TOL, "1e-8"}});
  problem.target = by_load.result.approach;
  const Answer by_approach = solved(problem, haar, {{RC_OPT_TOL, "1e-8"}});
  report(text(100 * share_in_contact(by_load)) + " % in contact: products " + std::to_string(by_load.result.products) +
         " by load, " + std::to_string(by_approach.result.products) + " by approach");
  check(std::max(by_load.result.products, by_approach.result.products) <= 30, "more products than needed");
}

// A third of the points in contact, in many small parts, on a surface whose points are those of half the grid, each four times.
// Sets swing where cuts add load to the parts: without strips that keep theirs a load takes 64 products.
void broken_contact_takes_no_more_products() {
  constexpr std::int64_t n = 1024;
  const Field half = self_affine(n / 2, n / 2, 2, 8);
  Problem problem;
  problem.system.nx = problem.system.ny = n;
  for (std::int64_t i = 0; i < n * n; ++i)
    problem.gap.push_back(2 * half[static_cast<std::size_t>(i / n / 2 * (n / 2) + i % n / 2)]);
  counts_stay_low(problem, 0.03 * n * n);
}

// Blocks at the ends of a period are smaller than others where its cells are no power of two. With couplings as if they were not,
// the load of a periodic surface is found slowly: 41 products by approach.
void sides_of_any_length_take_no_more_products() {
  for (const std::int64_t n : {320, 384}) {
    Problem problem;
    problem.system.nx = problem.system.ny = n;
    problem.system.boundary = RC_BOUNDARY_PERIODIC;
    problem.gap = self_affine(n, n, 1, 4);
    for (const double pressure : {0.02, 0.035}) counts_stay_low(problem, pressure * static_cast<double>(n * n));
  }
}

// Cells, or a surface, that are much longer than wide: near a stall processors differ by a third.
void elongated_surfaces_take_hardly_more_products_than_plain_gradients() {
  constexpr double most = 1.5;
  constexpr std::int64_t spare = 15;  // by which small counts may differ
  for (const auto& [nx, ny, hy] : {std::tuple<std::int64_t, std::int64_t, double>{128, 64, 60}, {37, 100, 0.026}, {96, 96, 61}})
    for (const double depth : {0.3, 0.5, 0.8}) {
      Problem problem;
      problem.system.boundary = RC_BOUNDARY_PERIODIC;
      problem.system.nx = nx;
      problem.system.ny = ny;
      problem.system.hy = hy;
      problem.gap = self_affine(nx, ny, 7, 3);
      const double highest = -*std::min_element(problem.gap.begin(), problem.gap.end());
      for (double& gap : problem.gap) gap += highest;
      problem.target = depth * sum(problem.gap) / static_cast<double>(problem.points());
      const auto products = [&](const char* solver) {
        return solved(problem, {solver, "fft"}, {{RC_OPT_TOL, "1e-6"}}).result.products;
      };
      const std::int64_t ours = products("haar-cg"), plain = products("polonsky-keer");
      report(std::to_string(nx) + " x " + std::to_string(ny) + ": products " + std::to_string(ours) + ", polonsky-keer " +
             std::to_string(plain));
      check(static_cast<double>(ours) <= most * static_cast<double>(plain) + spare, "too many products");
    }
}

// Coarser grids are a better start than the pressures of a far smaller load.
void a_large_step_costs_hardly_more_than_a_cold_one() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Problem problem = rugged_problem(side, side, 0.8, boundary);
    const double load = solved(problem, haar).result.load;
    const Contact contact(problem, haar);
    check_status(contact.solve(at_load(problem, 0.3 * load)), RC_OK, "first step");
    const Answer warm = contact.solve(at_load(problem, load)), cold = solved(at_load(problem, load), haar);
    check_near(warm.p, cold.p, 1e-8, "pressures");
    report("products " + std::to_string(warm.result.products) + ", cold " + std::to_string(cold.result.products));
    check(static_cast<double>(warm.result.products) <= 1.1 * static_cast<double>(cold.result.products),
          "a step takes many more products than a cold solve");
  }
}

// The last approach tells how far the next can come: hardly more points are looked at than may touch.
void a_small_step_by_load_looks_at_few_points() {
  const Problem problem = rugged_problem(64, 64, 0.3);
  const double load = solved(problem, haar).result.load;
  const Pair exact{"nnls", "dense"};
  const Contact contact(problem, exact);
  check_status(contact.solve(at_load(problem, load)), RC_OK, "first step");
  const Answer warm = contact.solve(at_load(problem, 1.01 * load));
  check_near(warm.p, solved(at_load(problem, 1.01 * load), haar).p, 1e-8, "pressures");
  report("points looked at " + std::to_string(warm.result.modelled) + ", below the approach " +
         std::to_string(warm.result.candidates));
  check(warm.result.modelled >= warm.result.candidates &&
            warm.result.modelled <= 1.15 * static_cast<double>(warm.result.candidates),
        "a small step looks at far more points than may touch");
}

// After some steps that lie near each other one takes hardly more than the products that tell its residual, also where the target
// jumps back. Each has the answer of a cold contact, with any number of threads, and a surface that changes is no trap.
void steps_near_each_other_take_few_products() {
  Problem problem = rugged_problem(60, 52, 0.5);
  const double depth = problem.target - problem.lowest_gap(), approach = problem.target, load = solved(problem, haar).result.load;
  for (const std::int32_t control : controls) {
    const auto target_of = [&](int step) {
      const double part = 1 + 1e-3 * (step % 20);
      return control == RC_CONTROL_LOAD ? part * load : approach + (part - 1) * depth;
    };
    const Contact contact(problem, haar), plain(problem, haar, {{"haar-cg.inverse", "0"}}),
        other(problem, haar, {{RC_OPT_THREADS, "3"}});
    std::int64_t products = 0, without = 0;
    for (int step = 0; step < 60; ++step) {
      rc_step next = problem.step();
      next.control = control;
      next.target = target_of(step);
      if (step > 0) next.undeformed_gap.data = nullptr;
      const Answer near = contact.solve(next), slow = plain.solve(next), same = other.solve(next);
      check_status(near, RC_OK, "step");
      check_near(near.p, slow.p, 1e-6, "pressures");
      check_same(same.p, near.p, "pressures of three threads");
      if (step < 20) continue;
      products += near.result.products;
      without += slow.result.products;
    }
    report("products " + std::to_string(products) + " in 40 steps, without " + std::to_string(without));
    check(5 * products < 2 * without, "steps near each other are no cheaper");

    Problem changed = problem;
    for (double& gap : changed.gap) gap *= 1.3;
    changed.control = control;
    changed.target = control == RC_CONTROL_LOAD ? 0.8 * load : changed.lowest_gap() + depth;
    const Answer after = contact.solve(changed);
    check_status(after, RC_OK, "another surface");
    check_near(after.p, solved(changed, haar).p, 1e-6, "pressures on another surface");
  }
}

void full_contact_is_no_harder() {
  const auto products = [](double depth, double least_share) {
    const Answer answer = solved(rugged_problem(side, side, depth), haar, {{RC_OPT_TOL, "1e-8"}});
    check(share_in_contact(answer) >= least_share, "only " + text(share_in_contact(answer)) + " in contact");
    report(text(100 * share_in_contact(answer)) + " % in contact: " + std::to_string(answer.result.products) + " products");
    return answer.result.products;
  };
  const std::int64_t usual = products(1.8, 0.2);
  check(products(8, 0.97) <= usual + 2, "nearly full contact takes more products");
  check(products(1e4, 1) <= usual + 2, "full contact takes more products");
}

void pivoting_takes_over() {
  Problem problem = rugged_problem(64, 64, 0.9999, RC_BOUNDARY_PERIODIC);
  const Settings impatient = {{"haar-cg.patience", "0"}, {RC_OPT_TOL, "1e-9"}};
  const Answer answer = solved(problem, haar, impatient);
  check(std::string(answer.result.note).find("haar-cg stalled; nnls completed the step") != std::string::npos,
        std::string("note: ") + answer.result.note);
  check_near(answer.p, solved(problem, {"nnls", "fft"}).p, 1e-6, "pressures");
  // With allow_fallback = 0 nothing takes over, and the status says that it stalled.
  Settings strict = impatient;
  strict.push_back({RC_OPT_ALLOW_FALLBACK, "0"});
  check_status(solve(problem, haar, strict), RC_STOP_STALLED);
}

// A process takes 61 bytes a point for it, and 75 with all products in double precision: `auto` must not refuse grids that fit.
void its_estimate_of_memory_is_what_it_takes() {
  const auto bytes_a_point = [](const char* products) {
    const Problem problem = rugged_problem(2 * side, 2 * side, 8);
    const Contact contact(problem, automatic, {{"haar-cg.products", products}});
    check_status(contact.solve(problem), RC_OK, products);
    const char* text = "";
    check(rc_contact_explain(contact.handle(), &text) == RC_OK, rc_last_error());
    const char* const of = std::strstr(text, "haar-cg on fft: ");
    double seconds = 0, mebibytes = 0;
    check(of && std::sscanf(of, "haar-cg on fft: %lf s, %lf MiB", &seconds, &mebibytes) == 2, text);
    return mebibytes * 1048576 / static_cast<double>(problem.points());
  };
  const double mixed = bytes_a_point("mixed"), all_double = bytes_a_point("double");
  report("bytes a point: " + text(mixed) + ", in double precision " + text(all_double));
  check(mixed >= 50 && mixed <= 75, "mixed");
  check(all_double >= 70 && all_double <= 95, "double");
}

// What "auto" would take has too little memory, and says so before it is made.
void auto_leaves_what_has_too_little_memory() {
  const Problem problem = rugged_problem(48, 48, 0.9);
  const Settings exact = {{RC_OPT_TOL, "9e-13"}};
  check(std::string(solved(problem, automatic, exact).result.backend) == "dense", "auto no longer takes dense here");
  Settings small = exact;
  small.push_back({"dense.memory_limit", "1"});
  const Answer answer = solve(problem, automatic, small);
  check(std::string(answer.result.backend) != "dense", "dense without memory");
  check_near(answer.p, solved(problem, automatic, exact).p, 1e-8, "pressures");
  small.push_back({RC_OPT_BACKEND, "dense"});
  check_status(solve(problem, automatic, small), RC_ERR_MEMORY);
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.haar",
                   {{"threads_and_runs_do_not_change_a_bit", threads_and_runs_do_not_change_a_bit},
                    {"a_coarse_start_saves_products", a_coarse_start_saves_products},
                    {"load_control_costs_little_more", load_control_costs_little_more},
                    {"broken_contact_takes_no_more_products", broken_contact_takes_no_more_products},
                    {"sides_of_any_length_take_no_more_products", sides_of_any_length_take_no_more_products},
                    {"elongated_surfaces_take_hardly_more_products_than_plain_gradients",
                     elongated_surfaces_take_hardly_more_products_than_plain_gradients},
                    {"a_large_step_costs_hardly_more_than_a_cold_one", a_large_step_costs_hardly_more_than_a_cold_one},
                    {"a_small_step_by_load_looks_at_few_points", a_small_step_by_load_looks_at_few_points},
                    {"steps_near_each_other_take_few_products", steps_near_each_other_take_few_products},
                    {"full_contact_is_no_harder", full_contact_is_no_harder},
                    {"pivoting_takes_over", pivoting_takes_over},
                    {"its_estimate_of_memory_is_what_it_takes", its_estimate_of_memory_is_what_it_takes},
                    {"auto_leaves_what_has_too_little_memory", auto_leaves_what_has_too_little_memory}},
                   argc, argv);
}
