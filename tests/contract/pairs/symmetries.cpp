// Symmetries of the grid: translation, transposition, reflection; masked points and points that are far away.
#include <algorithm>
#include <limits>

#include "invariance_tests.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double same = 1e-10;

Problem problem_of(std::int32_t boundary, double hx = 0.5, double hy = 0.75) {
  Problem problem = rough_problem(18, 14, boundary, hx, hy);
  problem.target *= 1.4;
  return problem;
}

// The values at (nx, ny) points taken from the places that `from` gives.
template <class From> Field moved(const Field& values, std::int64_t nx, std::int64_t ny, From from) {
  Field result;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix) result.push_back(values[static_cast<std::size_t>(from(ix, iy))]);
  return result;
}

// Solves the moved problem in both controls and compares with the moved answer.
template <class Move> void check_moved(const Problem& problem, const Problem& other_system, const Pair& pair, Move move) {
  const Answer answer = solved(problem, pair);
  Problem other = other_system;
  other.gap = move(problem.gap);
  check_near(solved(other, pair).p, move(answer.p), same, "p");
  check_near(solved(at_load(other, answer.result.load), pair).p, move(answer.p), same, "p at the same load");
}

void transposed(std::int32_t boundary, const Pair& pair) {
  const Problem problem = problem_of(boundary);
  Problem other = problem;
  std::swap(other.system.nx, other.system.ny);
  std::swap(other.system.hx, other.system.hy);
  if (problem.semi_periodic()) other.system.boundary = RC_BOUNDARY_PERIODIC_X + RC_BOUNDARY_PERIODIC_Y - boundary;
  const std::int64_t nx = problem.system.nx, ny = problem.system.ny;
  check_moved(problem, other, pair, [=](const Field& values) {
    return moved(values, ny, nx, [=](std::int64_t ix, std::int64_t iy) { return ix * nx + iy; });
  });
}

void reflected(std::int32_t boundary, const Pair& pair) {
  const Problem problem = problem_of(boundary);
  const std::int64_t nx = problem.system.nx, ny = problem.system.ny;
  check_moved(problem, problem, pair, [=](const Field& values) {
    return moved(values, nx, ny, [=](std::int64_t ix, std::int64_t iy) { return iy * nx + (nx - 1 - ix); });
  });
  check_moved(problem, problem, pair, [=](const Field& values) {
    return moved(values, nx, ny, [=](std::int64_t ix, std::int64_t iy) { return (ny - 1 - iy) * nx + ix; });
  });
}

void cyclically_translated(std::int32_t boundary, const Pair& pair) {
  const Problem problem = problem_of(boundary);
  const std::int64_t nx = problem.system.nx, ny = problem.system.ny;
  const std::int64_t dy = boundary == RC_BOUNDARY_PERIODIC_X ? 0 : 5;
  for (std::int64_t dx : {1, 7}) {
    if (boundary == RC_BOUNDARY_PERIODIC_Y) dx = 0;
    check_moved(problem, problem, pair, [=](const Field& values) {
      return moved(values, nx, ny, [=](std::int64_t ix, std::int64_t iy) { return (iy + dy) % ny * nx + (ix + dx) % nx; });
    });
  }
}

void bump_is_free_to_move(std::int32_t, const Pair& pair) {
  constexpr std::int64_t nx = 40, ny = 36;
  Problem problem;
  problem.system.nx = nx;
  problem.system.ny = ny;
  problem.target = 1;
  problem.gap = paraboloid(nx, ny, 1, 8.25, 9.5, 20);
  const Answer here = solved(problem, pair);
  check(here.result.contacts > 20, "the bump is too small");
  for (const auto& [dx, dy] : {std::pair<std::int64_t, std::int64_t>{20, 15}, {1, 0}, {-2, 3}}) {
    problem.gap = paraboloid(nx, ny, 1, 8.25 + static_cast<double>(dx), 9.5 + static_cast<double>(dy), 20);
    const Answer there = solved(problem, pair);
    const Field back = moved(there.p, nx, ny, [=, x = dx, y = dy](std::int64_t ix, std::int64_t iy) {
      return (iy + y + ny) % ny * nx + (ix + x + nx) % nx;
    });
    check_near(back, here.p, same, "p");
    check_near(there.result.load, here.result.load, same * here.result.load, "load");
  }
}

// Holes equal points whose gap is so large that nothing reaches them; what stands in a hole is not read.
void holes_equal_large_gaps(std::int32_t boundary, const Pair& pair) {
  const Problem whole = problem_of(boundary);
  const Answer without = solved(whole, pair);
  Problem holes = whole, far = whole;
  holes.mask.assign(whole.points(), 1);
  for (std::size_t i = 0; i < whole.points(); ++i)
    if (without.p[i] > 0 ? i % 2 == 0 : i % 5 == 0) {
      holes.mask[i] = 0;
      holes.gap[i] = i % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : -1e6;
      far.gap[i] = 1e3;
    }
  const Answer with_holes = solved(holes, pair), with_far = solved(far, pair, {{RC_OPT_TOL, "1e-11"}});
  check_near(with_holes.p, with_far.p, 1e-8, "p");
  check_near(with_holes.result.load, with_far.result.load, 1e-9 * with_far.result.load, "load");
  check_equal(with_holes.result.points, static_cast<std::int64_t>(whole.points()), "points");
  const Problem loaded = at_load(holes, with_holes.result.load);
  const Answer again = solved(loaded, pair);
  check_near(again.p, with_holes.p, 1e-9, "p at the same load");
  check_near(again.result.approach, whole.target, 1e-9 * whole.target, "approach");
}

void long_cells(std::int32_t boundary, const Pair& pair) {
  for (const double ratio : {3.0, 1 / 3.0})
    for (const char* kernel : {"love", "galerkin"}) {
      Problem problem = rough_problem(9, 7, boundary, ratio, 1);
      if (boundary == RC_BOUNDARY_FREE) problem.kernel = kernel;
      problem.target *= 1.4;
      const Answer answer = solved(problem, pair);
      check_against_naive(problem, answer);
      check_against_naive(at_load(problem, answer.result.load), solved(at_load(problem, answer.result.load), pair));
    }
}

}  // namespace

std::vector<Test> symmetry_tests() {
  std::vector<Test> tests;
  const auto add = [&](std::int32_t boundary, const char* name, void (*body)(std::int32_t, const Pair&)) {
    add_for_pairs(tests, name, boundary, [=](const Pair& pair) { body(boundary, pair); });
  };
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC, RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y}) {
    add(boundary, "transposed_grid_has_transposed_pressures", transposed);
    add(boundary, "reflected_grid_has_reflected_pressures", reflected);
    add(boundary, "holes_equal_large_gaps", holes_equal_large_gaps);
    add(boundary, "cells_three_times_as_long_as_wide_are_certified_by_naive_code", long_cells);
  }
  for (const std::int32_t boundary : {RC_BOUNDARY_PERIODIC, RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y})
    add(boundary, "cyclic_translation_moves_the_pressures", cyclically_translated);
  add(RC_BOUNDARY_FREE, "translation_of_a_bump_moves_the_pressures", bump_is_free_to_move);
  return tests;
}

}  // namespace pairs
