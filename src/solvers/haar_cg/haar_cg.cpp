// The solver haar-cg: projected conjugate gradients on the free set, preconditioned by two multilevel trees. README.md has the
// method, iteration.h its control flow. This file runs it on the threads of this process, and of others with which it shares the grid.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "grid/downsample.h"
#include "solvers/haar_cg/iteration.h"
#include "solvers/haar_cg/regular_start.h"
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

constexpr std::int64_t coarsest_side = 64;
constexpr std::int64_t chunk = 8192;
constexpr double coarse_tol = 1e-2;             // spreading the pressures to the finer grid loses further digits
constexpr double many = 0.25;                   // of the points: within the length unit where a load starts everywhere
constexpr std::int64_t few_overlaps = 16;       // points without a gap at the approach: then all products are in double precision
constexpr std::int64_t remembered = 256 * 256;  // most points of a coarse grid whose operator is kept for later steps

// Every point takes the pressure of the coarse cell in which it lies.
void spread(const Problem& problem, std::int64_t coarse_nx, const Vector& pressure, std::span<double> p) {
  const rc_grid& grid = *problem.grid();
  const double unit = problem.pressure_unit();
  const auto n = static_cast<std::int64_t>(p.size());
  roughcontact::for_each(problem.team(), (n + chunk - 1) / chunk, n >= 4 * chunk, [&](std::int64_t item, std::int64_t) {
    for (std::int64_t i = item * chunk; i < std::min((item + 1) * chunk, n); ++i) {
      const std::int64_t point = problem.point(i), x = point % grid.nx, y = point / grid.nx;
      p[static_cast<std::size_t>(i)] = pressure[static_cast<std::size_t>(y / 2 * coarse_nx + x / 2)] / unit;
    }
  });
}

// A start from the solution on a grid of half the resolution, which starts from a still coarser grid. p and d stay as they are
// where the grid is too small, or its coarse problem cannot be solved.
void start_nested(const Problem& problem, std::span<double> p, double& d) {
  const rc_grid& grid = *problem.grid();
  if (std::min(grid.nx, grid.ny) < 2 * coarsest_side) return;
  const Ranks* const ranks = problem.ranks();
  CoarseGrid coarse;
  Vector pressure;
  on_all(ranks, [&] {
    coarse = downsample(grid.nx, ranks ? ranks->rows() : grid.ny, problem.gap(), problem.mask(), Filter::mean);
    pressure.resize(static_cast<std::size_t>(coarse.nx * coarse.ny));
  });
  const double length = problem.length_unit();

  rc_coarse request{};
  request.struct_size = sizeof request;
  request.nx = coarse.nx;
  request.ny = (grid.ny + 1) / 2;
  request.factor = 2;
  request.undeformed_gap = coarse.gap.data();
  request.mask = coarse.mask.empty() ? nullptr : coarse.mask.data();
  request.control = problem.load_control() ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
  request.approach = grid.approach;
  request.load = problem.load() * problem.pressure_unit() * grid.hx * grid.hy;
  request.solver = "haar-cg";
  request.p = pressure.data();
  request.keep = !ranks && coarse.nx * coarse.ny <= remembered;
  request.tol = std::max(coarse_tol, problem.tol());
  if (problem.coarse(request) < 0) return;

  spread(problem, coarse.nx, pressure, p);
  if (!problem.load_control()) return;
  // The datum from u = (datum - gap) / length.
  const double datum =
      problem.u() ? problem.gap()[static_cast<std::size_t>(problem.point(0))] + problem.u()[0] * length : grid.approach;
  d = std::max(0.0, (request.approach - datum) / length);
}

// Pressures that carry the load. Nearly full contact begins with the same pressure everywhere; where only few points lie within
// the length unit, which then is an estimate of the approach, pressures grow with the overlap at that approach.
void start_cold(const Problem& problem, std::span<double> p) {
  struct Part {
    double sum = 0, most = 0;
    std::int64_t within = 0, n = 0;
    Part operator+(const Part& b) const { return {sum + b.sum, std::max(most, b.most), within + b.within, n + b.n}; }
  };
  const Ranks* const ranks = problem.ranks();
  const auto carries = [&, mask = problem.mask()](std::size_t i) { return !ranks || mask.empty() || mask[i] != 0; };
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    Part part;
    for (std::int64_t i = begin; i < begin + count; ++i) {
      double& value = p[static_cast<std::size_t>(i)];
      value = std::max(0.0, 1 + problem.compenetration(i));
      part.sum += value;
      part.most = std::max(part.most, value);
      part.within += value > 0 ? 1 : 0;
      part.n += carries(static_cast<std::size_t>(i)) ? 1 : 0;
    }
    return part;
  };
  const Chunks whole{std::max<std::int64_t>(problem.size(), 1)};
  const Part all =
      reduce<Part>(problem.size(), problem.team(), body, {}, {}, ranks ? Chunks::of(ranks, problem.grid()->nx) : whole);
  const auto n = static_cast<double>(all.n);
  const bool everywhere = static_cast<double>(all.within) > many * n || all.most * problem.load() >= problem.cap() * all.sum;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = !everywhere ? p[i] * (problem.load() / all.sum) : carries(i) ? problem.load() / n : 0;
}

// Whether products in single precision save anything: not where few points overlap, which a step or two solve to all digits.
bool worth_mixing(const Problem& problem) {
  if (!problem.has_float() || problem.option_text("haar-cg.products") != "mixed") return false;
  if (problem.load_control()) return true;
  std::int64_t overlaps = 0;
  for (std::int64_t i = 0; i < problem.size() && overlaps <= few_overlaps; ++i) overlaps += problem.compenetration(i) > 0 ? 1 : 0;
  if (const Ranks* const ranks = problem.ranks()) {
    const std::vector<std::int64_t> all = ranks->of_each(overlaps);
    overlaps = std::accumulate(all.begin(), all.end(), std::int64_t{0});
  }
  return overlaps > few_overlaps;
}

template <class Real> rc_status iterate(const Problem& problem, std::span<double> p, double& d) {
  TreeInputs inputs = tree_inputs(*problem.grid(), problem.size(),
                                  [&](std::int64_t mx, std::int64_t my, Vector& out) { problem.coefficients(mx, my, out); });
  const HaarTask task{.by_load = problem.load_control(),
                      .load = problem.load(),
                      .cap = problem.cap(),
                      .tol = problem.tol(),
                      .least_scale = problem.least_scale(),
                      .periodic_mean = inputs.mean,
                      .elongated = inputs.elongated,
                      .patience = static_cast<int>(problem.option_int("haar-cg.patience")),
                      .poll = [&](std::int64_t steps, double residual) { problem.poll(steps, residual); }};
  const Ranks* const ranks = problem.ranks();
  std::unique_ptr<ThreadMachine<Real>> machine;
  on_all(ranks, [&] {
    machine = std::make_unique<ThreadMachine<Real>>(problem, p, HaarTreePair(std::move(inputs.cells), inputs.table, 1, ranks), ranks);
  });
  const HaarOutcome outcome = HaarIteration(*machine, task).run(d);
  if (outcome.ending == HaarEnding::not_finite) problem.fail("haar-cg: the operator returned values that are not finite");
  if (problem.load_control()) d = outcome.approach;
  return outcome.ending == HaarEnding::solved ? RC_OK : RC_STOP_STALLED;
}

}  // namespace

const Options haar_cg_options = listed(specs);

rc_status haar_cg(const Problem& problem, std::span<double> p, double& d) {
  const auto cold = [&] { return !any_positive(problem, p); };
  // A regular surface shows in the values of the whole grid.
  if (cold() && (problem.ranks() || !start_regular(problem, p)) && problem.option_int("haar-cg.nested") != 0)
    start_nested(problem, p, d);
  if (problem.load_control() && cold()) start_cold(problem, p);
  const rc_status status = worth_mixing(problem) ? iterate<float>(problem, p, d) : iterate<double>(problem, p, d);
  if (status != RC_STOP_STALLED || problem.load_control() || !problem.has_subset()) return status;
  problem.note("haar-cg: stalled; nnls finished");
  return problem.by_nnls(p.data());
}

rc_status haar_cg_score(const rc_facts* facts, rc_estimate* estimate) {
  estimate->seconds = with_the_rest(*facts, iterating(*facts, 40));
  estimate->bytes = 10 * sizeof(double) * static_cast<double>(facts->n);
  return RC_OK;
}

}  // namespace rc
