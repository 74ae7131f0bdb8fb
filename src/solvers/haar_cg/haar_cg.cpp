// The solver haar-cg: projected conjugate gradients on the free set, preconditioned by two multilevel trees. README.md has the
// method, iteration.h its control flow. This file runs it on the threads of this process, and of others with which it shares the
// grid.
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/haar_cg/iteration/iteration.h"
#include "solvers/haar_cg/near/near_steps.h"
#include "solvers/haar_cg/single_pressures.h"
#include "solvers/haar_cg/starts.h"
#include "solvers/haar_cg/threads/thread_machine.h"
#include "solvers/solver.h"
#include "trees/tree_inputs.h"

namespace rc {

namespace {

constexpr rc_component products =
    text_option("haar-cg.products", "mixed", "mixed|double", "mixed: single precision, corrected by some in double precision");
constexpr rc_component nested = int_option("haar-cg.nested", "1", 0, 1, "1: without a start, begin on coarser grids");
constexpr rc_component patience_option =
    int_option("haar-cg.patience", "120", 0, 1e6,
               "rounds of steps that may fail to halve the residual before the exact fallback takes over");
constexpr rc_component inverse =
    int_option("haar-cg.inverse", "600", 0, 4096,
               "largest number of points in contact for which similar steps keep the inverse of H on them, 4 bytes a pair");
constexpr std::string_view mixed_products = "mixed";
const rc_component* const haar_specs[] = {&products, &nested, &patience_option, &inverse};

constexpr std::int64_t few_overlaps = 16;  // points without a gap at the approach: then all products are in double precision

// Whether products in single precision save anything: not if few points overlap, which a step or two solve to all digits.
bool worth_mixing(const Problem& problem) {
  if (!problem.has_float() || problem.option_text(products.name) != mixed_products) return false;
  if (problem.load_control()) return true;
  std::int64_t overlaps = 0;
  for (std::int64_t i = 0; i < problem.size() && overlaps <= few_overlaps; ++i) overlaps += problem.penetration(i) > 0 ? 1 : 0;
  if (const Ranks* const ranks = problem.ranks()) {
    const std::vector<std::int64_t> all = ranks->of_each(overlaps);
    overlaps = std::accumulate(all.begin(), all.end(), std::int64_t{0});
  }
  return overlaps > few_overlaps;
}

// Products and pressures in single precision have errors of some 1e-6 of the largest penetration, if no wave without
// deflection can make the pressures large.
bool single_suffices(const Problem& problem) {
  constexpr double least_tol = 0.9e-5;
  return problem.tol() >= least_tol && !problem.ranks() && problem.grid()->boundary != RC_BOUNDARY_PERIODIC;
}

// q: null, or room for a vector.
template <class Real, class Pressure> rc_status iterate(const Problem& problem, Pressure* p, double& d, Real* q = nullptr) {
  TreeInputs inputs = tree_inputs(*problem.grid(), problem.size(),
                                  [&](std::int64_t mx, std::int64_t my, Vector& out) { problem.coefficients(mx, my, out); });
  const HaarTask task = task_of(problem, inputs);
  const auto poll = [&](std::int64_t steps, double residual) {
    problem.poll(steps, residual);
    return true;
  };
  const Ranks* const ranks = problem.ranks();
  std::unique_ptr<ThreadMachine<Real, Pressure>> machine;
  on_all(ranks, [&] {
    HaarTreePair trees(std::move(inputs.cells), inputs.table, 1, Rows::of(ranks));
    machine = std::make_unique<ThreadMachine<Real, Pressure>>(problem, p, std::move(trees), ranks, q);
  });
  // All its memory is there, so that it needs no more exchanges than its own.
  const auto run = [&] {
    const Ranks::Unwatched iterating(ranks);
    return HaarIteration(*machine, task, poll).run(d);
  };
  const HaarOutcome outcome = run();
  if (outcome.ending == HaarEnding::not_finite) problem.fail("haar-cg: the operator returned values that are not finite");
  if (problem.load_control()) d = outcome.approach;
  return outcome.ending == HaarEnding::solved ? RC_OK : RC_STOP_STALLED;
}

rc_status iterate(const Problem& problem, std::span<double> p, double& d) {
  if (!worth_mixing(problem)) return iterate<double>(problem, p.data(), d);
  if (!single_suffices(problem)) return iterate<float>(problem, p.data(), d);
  const SinglePressures single(p, problem.cap(), problem.team());
  return iterate<float>(problem, single.values(), d, single.room());
}

}  // namespace

namespace haar_cg {

const Options options = listed(haar_specs);

rc_status solve(const Problem& problem, std::span<double> p, double& d) {
  const char* const coarse_solver = problem.option_int("haar-cg.nested") != 0 ? "haar-cg" : nullptr;
  NearSteps near(problem);
  if (near.solve(p, d)) return near.keep(p), RC_OK;
  if (!serves(problem, coarse_solver, p)) start_haar_cg(problem, {coarse_solver}, p, d);
  const rc_status status = iterate(problem, p, d);
  if (status == RC_OK) near.keep(p);
  if (status != RC_STOP_STALLED || problem.load_control() || !problem.has_subset()) return status;
  problem.note("haar-cg stalled; nnls completed the step");
  return problem.by_nnls(p.data());
}

rc_status score(const rc_facts* facts, rc_estimate* estimate) {
  estimate->seconds = with_the_rest(*facts, iterating(*facts, 40));
  // Five vectors and the free set; u is made where it is read. The trees lie in one of the vectors.
  const bool mixed = (facts->caps & RC_CAP_FLOAT) != 0 &&
                     roughcontact::option_text(facts->host, facts->options, products.name) == mixed_products;
  estimate->bytes = (5 * (mixed ? sizeof(float) : sizeof(double)) + 4) * static_cast<double>(facts->n);
  return RC_OK;
}

}  // namespace haar_cg

}  // namespace rc
