// Sparse contact solved at few points against the same contact solved over all of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sparse.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace sparse_contact {

namespace {

using namespace pairs;

constexpr std::int64_t side = 512;
constexpr double shallow = 1.2;  // standard deviations below the highest point: about one point in a hundred touches
const Pair everywhere{"haar-cg", "fft"};

const char* few_on(const Problem& problem) { return problem.periodic() ? "fft" : "split"; }

Problem at_load_of(Problem problem, const Sparse& answer) { return at_load(std::move(problem), answer.result.load); }

Problem periodic(Problem problem) {
  problem.system.boundary = RC_BOUNDARY_PERIODIC;
  return problem;
}

void check_against_all_points(const Problem& problem, const char* what) {
  const Sparse sparse = sparse_contact::solved(problem, few_on(problem));
  check_equal(sparse.result.levels, 0, "grids of a solver that starts over all points");
  const Answer all = pairs::solved(problem, everywhere, {{RC_OPT_TOL, "1e-9"}});
  check_near(sparse.everywhere(), all.p, 1e-6, what);
  check_near(sparse.result.load, all.result.load, 1e-7 * all.result.load, "load");
  check_near(sparse.result.approach, all.result.approach, 1e-7 * std::abs(all.result.approach), "approach");
  check_near(sparse.result.energy, all.result.energy, 1e-7 * std::abs(all.result.energy), "energy");
  check(sparse.result.contacts > 0 && sparse.result.contacts <= sparse.result.points / 20, "contact is sparse");
  check(std::abs(sparse.result.contacts - all.result.contacts) <= 1 + all.result.contacts / 1000, "contacts");
  if (problem.control == RC_CONTROL_APPROACH) {
    check_equal(sparse.result.candidates, all.result.candidates, "candidates");
    check(sparse.result.load_lower <= all.result.load_upper && all.result.load_lower <= sparse.result.load_upper,
          "load interval");
    check(sparse.result.load_upper - sparse.result.load_lower <= 1e-4 * sparse.result.load, "width of the load interval");
  }
  check_equal(sparse.result.proven_contacts + sparse.result.proven_open + sparse.result.undecided, sparse.result.points,
              "every point is counted once");
  check(sparse.result.proven_contacts <= all.result.contacts && sparse.result.undecided <= 1 + sparse.result.contacts / 10,
        "proven counts");
}

void agrees(const Problem& problem) {
  check_against_all_points(problem, "approach control");
  check_against_all_points(at_load_of(problem, sparse_contact::solved(problem, few_on(problem))), "load control");
}

void rough_surfaces() {
  for (const unsigned seed : {1u, 2u})
    for (const double depth : {0.5, shallow}) agrees(self_affine(side, side, seed, depth));
  for (const double depth : {0.5, shallow}) agrees(periodic(self_affine(side, side, 5, depth)));
}

void any_shape_and_cell() {
  Problem problem = self_affine(700, 461, 3, shallow);
  problem.system.hx = 0.5;
  problem.system.hy = 1.25;
  problem.system.modulus = 7;
  agrees(problem);
  agrees(periodic(problem));
  problem.kernel = "galerkin";
  agrees(problem);
}

void masked_points() {
  Problem problem = self_affine(side, side, 4, shallow);
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.points(); ++i)
    if ((i / 7 + i / side / 5) % 3 == 0) {
      problem.mask[i] = 0;
      problem.gap[i] = std::numeric_limits<double>::quiet_NaN();
    }
  problem.target = problem.lowest_gap() + 10 * shallow;
  agrees(problem);
  agrees(periodic(problem));
}

// Peaks of one cell vanish in the mean of a coarser grid: only the screening sees them.
void peaks_that_no_coarse_grid_shows() {
  Problem problem;
  problem.system.nx = problem.system.ny = side;
  problem.gap.assign(problem.points(), 0.0);
  for (std::int64_t y = 0; y < side; ++y)
    for (std::int64_t x = 0; x < side; ++x) {
      const double dx = static_cast<double>(x) - 200, dy = static_cast<double>(y) - 240;
      double& gap = problem.gap[static_cast<std::size_t>(y * side + x)];
      gap = (dx * dx + dy * dy) / 2000;
      if (x % 61 == 5 && y % 53 == 7) gap = std::min(gap, 0.1 + 1e-4 * static_cast<double>(x + y));
    }
  problem.target = 1;
  agrees(problem);
  agrees(periodic(problem));
}

// Its candidates lie in a small box: transforms of the box, and no product beyond it.
void one_asperity() {
  Problem problem;
  problem.system.nx = side;
  problem.system.ny = 640;
  problem.gap = paraboloid(side, 640, 1, 100.3, 411.8, 900);
  problem.target = 0.4;
  const Sparse sparse = sparse_contact::solved(problem, "fft");
  check(sparse.result.modelled < sparse.result.points / 64, "unknowns");
  const Answer full = pairs::solved(problem, everywhere, {{RC_OPT_TOL, "1e-9"}});
  check_near(sparse.everywhere(), full.p, 1e-6, "pressures");
  check_equal(sparse.result.candidates, full.result.candidates, "candidates");
  const Sparse by_load = sparse_contact::solved(at_load_of(problem, sparse), "fft");
  check_near(by_load.everywhere(), full.p, 1e-5, "pressures in load control");
  check_near(by_load.result.approach, 0.4, 1e-7, "approach");
}

// The look for sparse contact serves as its start: the solver needs no grids of its own.
void dense_contact_is_left_to_transforms() {
  Problem problem = rough_problem(side, side);
  problem.target += 3 * (problem.target - problem.lowest_gap());
  const Sparse dense = sparse_contact::solved(problem, "fft");
  check(dense.result.contacts > side * side / 10, "contact is dense");
  check_equal(dense.result.levels, 0, "grids of the solver");
  check_near(dense.everywhere(), pairs::solved(problem, everywhere, {{RC_OPT_TOL, "1e-9"}}).p, 1e-6, "pressures");
  const Sparse by_load = sparse_contact::solved(at_load_of(problem, dense), "fft");
  check_equal(by_load.result.levels, 0, "grids of the solver in load control");
  check_near(by_load.everywhere(), dense.everywhere(), 1e-5, "pressures in load control");
}

void arrays_over_all_points_on_request() {
  const Problem given = self_affine(side, side, 6, shallow);
  for (const Problem& problem : {given, periodic(given)}) {
    const Sparse sparse = sparse_contact::solved(problem, few_on(problem));
    const Answer full = pairs::solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
    check(std::string(full.result.backend) == few_on(problem), "backend");
    check_same(sparse.everywhere(), full.p, "pressures");
    const double mean = sum(full.gap) / static_cast<double>(full.gap.size());
    check_near(full.result.mean_gap, mean, 1e-12 * mean, "mean gap");
    check(std::isnan(sparse.result.mean_gap), "the mean gap is unknown if the gap is known at some points only");
    check_near(sparse.result.max_pressure, largest(full.p), 0, "largest pressure");
    check_equal(std::count_if(full.gap.begin(), full.gap.end(), [](double gap) { return gap < -1e-6; }), 0, "overlapping points");
    const Answer checked = Contact(problem, automatic, {{RC_OPT_TOL, "1e-7"}}).certify(problem.step(), full.p);
    check(checked.status == RC_OK, checked.message);
    check_near(checked.gap, full.gap, 1e-9, "gap");
  }
}

void borrowed_arrays_and_threads_do_not_change_a_bit() {
  const Problem problem = self_affine(side, side, 7, shallow);
  for (const Problem& each : {problem, at_load_of(problem, sparse_contact::solved(problem, "split")), periodic(problem)}) {
    const Sparse alone = sparse_contact::solved(each, few_on(each));
    for (const char* threads : {"1", "2", "3"}) {
      const SparseContact contact(each, {{RC_OPT_THREADS, threads}});
      const Sparse answer = contact.solve(each, true);
      check(answer.status == RC_OK, answer.message);
      check(answer.index == alone.index, "contact points");
      check_same(answer.p, alone.p, "pressures");
      check_equal(answer.result.undecided, alone.result.undecided, "undecided");
    }
  }
}

void a_second_step_starts_from_the_first() {
  const Problem problem = self_affine(side, side, 8, shallow);
  const SparseContact contact(problem);
  const Sparse first = contact.solve(problem);
  Problem again = problem;
  again.target = problem.lowest_gap() + 10 * shallow * 1.005;
  const Sparse second = contact.solve(again);
  check(first.status == RC_OK && second.status == RC_OK, second.message);
  check_near(second.everywhere(), sparse_contact::solved(again, "split").everywhere(), 1e-6, "pressures");
  check(second.result.products < first.result.products, "products of a step that changes little");
}

// Even steps, the first two of which start on coarser grids. Without the line all of them do, and take what cold ones take.
void further_steps_start_on_the_line_through_the_last_two() {
  const Problem whole = self_affine(side, side, 8, shallow);
  const double load = sparse_contact::solved(whole, "split").result.load;
  for (const bool by_load : {false, true}) {
    const auto step = [&](int k) {
      const double part = 0.8 + 0.04 * k;
      if (by_load) return at_load(whole, part * load);
      Problem problem = whole;
      problem.target = whole.lowest_gap() + part * (whole.target - whole.lowest_gap());
      return problem;
    };
    const SparseContact contact(step(0));
    std::int64_t warm = 0, cold = 0;
    for (int k = 0; k <= 5; ++k) {
      const Sparse found = contact.solve(step(k)), alone = sparse_contact::solved(step(k), "split");
      check(found.status == RC_OK, found.message);
      check_near(found.everywhere(), alone.everywhere(), 1e-6, "pressures");
      if (k < 2) continue;
      warm += found.result.products;
      cold += alone.result.products;
    }
    report(std::string(by_load ? "by load: " : "by approach: ") + std::to_string(warm) + " products, cold " +
           std::to_string(cold));
    check(warm < cold, "products of steps on the line");
  }
}

std::int32_t stop(const rc_progress*, void*) { return 1; }

void stops_are_reported() {
  const Problem problem = self_affine(side, side, 9, shallow);
  const SparseContact contact(problem);
  check(rc_contact_on_progress(contact.handle(), stop, nullptr, 1) == RC_OK, rc_last_error());
  const Sparse stopped = contact.solve(problem);
  check(stopped.status == RC_STOP_CANCELLED, stopped.message);
  std::int64_t n = -1;
  check(rc_contact_points(contact.handle(), 0, {}, {}, &n) == RC_OK && n == 0, "no certified step, no contact points");
  check(rc_contact_points(contact.handle(), -1, {}, {}, &n) == RC_ERR_ARGUMENT, "room = -1");
  check(rc_contact_points(contact.handle(), 0, {}, {}, nullptr) == RC_ERR_ARGUMENT, "n = null");
  check(SparseContact(problem, {{RC_OPT_MAX_ITER, "3"}}).solve(problem).status == RC_STOP_MAX_ITER, "max_iter");
  const Problem by_load = at_load_of(problem, sparse_contact::solved(problem, "split"));
  check(SparseContact(by_load, {{RC_OPT_MAX_ITER, "3"}}).solve(by_load).status == RC_STOP_MAX_ITER, "max_iter in load control");
}

}  // namespace

}  // namespace sparse_contact

int main(int argc, char** argv) {
  using namespace sparse_contact;
  return pairs::run_group("sparse_contact",
                          RC_TESTS(rough_surfaces, any_shape_and_cell, masked_points, peaks_that_no_coarse_grid_shows,
                                   one_asperity, dense_contact_is_left_to_transforms, arrays_over_all_points_on_request,
                                   borrowed_arrays_and_threads_do_not_change_a_bit, a_second_step_starts_from_the_first,
                                   further_steps_start_on_the_line_through_the_last_two, stops_are_reported),
                          argc, argv);
}
