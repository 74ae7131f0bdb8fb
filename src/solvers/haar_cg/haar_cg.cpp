// The solver haar-cg: projected conjugate gradients on the contact set, preconditioned by two multilevel trees. README.md has the
// method, iteration.h its control flow. This file runs it on the threads of this process.
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "solvers/haar_cg/iteration.h"
#include "solvers/haar_cg/nested_start.h"
#include "solvers/haar_cg/threads/thread_machine.h"
#include "solvers/haar_cg/tree_inputs.h"
#include "solvers/solver.h"

namespace rc {

namespace {

constexpr rc_option_spec products =
    text_option("haar-cg.products", "mixed", "mixed|double", "mixed: single precision, corrected by some in double precision");
constexpr rc_option_spec nested = int_option("haar-cg.nested", "1", 0, 1, "1: without a start, begin on coarser grids");
constexpr rc_option_spec patience =
    int_option("haar-cg.patience", "120", 0, 1e6, "bounded steps without half the residual before the exact fallback takes over");
const rc_option_spec* const specs[] = {&products, &nested, &patience};

template <class Real> rc_status iterate(const Problem& problem, std::span<double> p, double& d) {
  TreeInputs inputs = tree_inputs(*problem.grid(), problem.size(),
                                  [&](std::int64_t mx, std::int64_t my, Vector& out) { problem.coefficients(mx, my, out); });
  const HaarTask task{.by_load = problem.load_control(),
                      .load = problem.load(),
                      .tol = problem.tol(),
                      .least_scale = problem.least_scale(),
                      .periodic_mean = inputs.mean,
                      .elongated = inputs.elongated,
                      .patience = static_cast<int>(problem.option_int("haar-cg.patience")),
                      .poll = [&](std::int64_t steps, double residual) { problem.poll(steps, residual); }};
  ThreadMachine<Real> machine(problem, p, HaarTreePair(std::move(inputs.cells), inputs.table));
  const HaarOutcome outcome = HaarIteration(machine, task).run(d);
  if (outcome.ending == HaarEnding::not_finite) problem.fail("haar-cg: the operator returned values that are not finite");
  if (problem.load_control()) d = outcome.approach;
  return outcome.ending == HaarEnding::solved ? RC_OK : RC_STOP_STALLED;
}

}  // namespace

const Options haar_cg_options = listed(specs);

rc_status haar_cg(const Problem& problem, std::span<double> p, double& d) {
  if (problem.option_int("haar-cg.nested") != 0 && !any_positive(problem.size(), p.data(), problem.team()))
    start_nested(problem, p, d);
  const bool mixed = problem.has_float() && problem.option_text("haar-cg.products") == "mixed";
  const rc_status status = mixed ? iterate<float>(problem, p, d) : iterate<double>(problem, p, d);
  if (status != RC_STOP_STALLED || problem.load_control() || !problem.has_subset()) return status;
  // nnls ends after finitely many steps on every surface.
  problem.note("haar-cg: stalled; nnls finished");
  Positions all(p.size());
  std::iota(all.begin(), all.end(), std::int64_t{0});
  const rc_status finished = problem.inner("nnls", all, problem.tol(), p.data(), nullptr);
  if (finished < 0) throw Leave{finished};
  return finished;
}

}  // namespace rc
