#include "solvers/haar_cg/starts.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/chunks.h"
#include "core/start_terms.h"
#include "core/sums.h"
#include "grid/downsample.h"

namespace rc {

namespace {

constexpr std::int64_t coarsest_side = 64;
constexpr double coarse_tol = 1e-2;    // spreading the pressures to the finer grid loses further digits
constexpr double farthest = 1.25;      // ratio of two loads: beyond, coarser grids tell more than the other load's pressures
constexpr std::size_t few_loaded = 4;  // points that carry a load each by itself: then the others start without pressure
constexpr std::int64_t remembered = 256 * 256;  // most points of a coarse grid that is kept for later steps as it is

// Whether any chunk's most(begin, count) is positive; of all ranks, if the problem is shared.
template <class Most> bool some_positive(const Problem& problem, const Most& most) {
  const auto positive = [&](std::int64_t begin, std::int64_t count) { return most(begin, count) > 0; };
  return reduce<char>(problem.size(), problem.team(), positive, 0, std::logical_or<>(),
                      Chunks::of(problem.ranks(), problem.grid()->nx)) != 0;
}

// Every point takes the pressure of the coarse cell in which it lies. Returns whether any is positive.
bool spread(const Problem& problem, std::int64_t coarse_nx, const Vector& pressure, std::span<double> p) {
  const rc_grid& grid = *problem.grid();
  const double unit = problem.pressure_unit();
  return some_positive(problem, [&](std::int64_t begin, std::int64_t count) {
    double most = 0;
    std::int64_t row = -1, first = 0;
    const double* coarse = nullptr;
    for (std::int64_t i = begin; i < begin + count; ++i) {
      const std::int64_t point = problem.point(i);
      if (point >= first + grid.nx || row < 0) {
        row = point / grid.nx;
        first = row * grid.nx;
        coarse = pressure.data() + row / 2 * coarse_nx;
      }
      const double value = coarse[(point - first) / 2] / unit;
      p[static_cast<std::size_t>(i)] = value;
      most = std::max(most, value);
    }
    return most;
  });
}

bool nests(const rc_grid& grid) { return std::min(grid.nx, grid.ny) >= 2 * coarsest_side; }

// A start from the solution on a grid of half the resolution, which starts from a still coarser grid. p and d stay as they are
// where the grid is too small, or its coarse problem cannot be solved. Returns whether some pressure is positive.
bool start_nested(const Problem& problem, const CoarseSolver& solver, std::span<double> p, double& d) {
  const rc_grid& grid = *problem.grid();
  if (!nests(grid)) return false;
  const Ranks* const ranks = problem.ranks();
  CoarseGrid coarse;
  Vector pressure;
  on_all(ranks, [&] {
    coarse = downsample(grid.nx, ranks ? ranks->rows() : grid.ny, problem.gap(), problem.mask(), Filter::mean,
                        [&](std::int64_t rows, const auto& act) {
                          roughcontact::for_each(problem.team(), rows, rows * grid.nx >= least_shared_values,
                                                 [&](std::int64_t row, std::int64_t) { act(row); });
                        });
    coarse.gap.reserve(1);  // a rank without rows also gives arrays
    pressure.reserve(1);
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
  request.control = problem.load_control() ? RC_CONTROL_LOAD : RC_CONTROL_APPROACH;
  request.approach = grid.approach;
  request.load = problem.load() * problem.pressure_unit() * grid.hx * grid.hy;
  request.solver = solver.name;
  request.p = pressure.data();
  const bool small = coarse.nx * coarse.ny <= remembered;
  request.keep = ranks ? 0 : small ? 1 : solver.set_up_is_kept ? 2 : 0;
  request.tol = std::max(coarse_tol, problem.tol());
  if (problem.coarse(request) < 0) return false;

  const bool positive = spread(problem, coarse.nx, pressure, p);
  if (!problem.load_control()) return positive;
  // The datum from u = (datum - gap) / length.
  const double datum =
      problem.u() ? problem.gap()[static_cast<std::size_t>(problem.point(0))] + problem.u()[0] * length : grid.approach;
  d = std::max(0.0, (request.approach - datum) / length);
  return positive;
}

// Pressures that carry the load on few points, each as if it were alone: then others hardly matter. False if that takes more.
bool start_few(const Problem& problem, std::span<double> p) {
  Vector alone;
  problem.coefficients(1, 1, alone);
  std::vector<std::pair<double, std::size_t>> highest;  // penetration and unknown, the highest first
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::pair<double, std::size_t> next{-problem.penetration(static_cast<std::int64_t>(i)), i};
    if (highest.size() > few_loaded && !(next < highest.back())) continue;
    highest.insert(std::upper_bound(highest.begin(), highest.end(), next), next);
    if (highest.size() > few_loaded + 1) highest.pop_back();
  }
  double sum = 0;
  for (std::size_t k = 0; k < std::min(few_loaded, highest.size()); ++k) {
    sum += highest[k].first;
    const double datum = (alone[0] * problem.load() + sum) / static_cast<double>(k + 1);
    if (k + 1 < highest.size() && datum > highest[k + 1].first) continue;
    if ((datum - highest[0].first) / alone[0] > problem.cap()) return false;
    for (std::size_t j = 0; j <= k; ++j) p[highest[j].second] = (datum - highest[j].first) / alone[0];
    return true;
  }
  return false;
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
  if (!ranks && start_few(problem, p)) return;
  const auto carries = [&, mask = problem.mask()](std::size_t i) { return !ranks || mask.empty() || mask[i] != 0; };
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    Part part;
    for (std::int64_t i = begin; i < begin + count; ++i) {
      double& value = p[static_cast<std::size_t>(i)];
      value = cold_pressure(problem.penetration(i));
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
  const bool everywhere = starts_everywhere(static_cast<double>(all.within), n, all.most, all.sum, problem.load(), problem.cap());
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = !everywhere ? p[i] * (problem.load() / all.sum) : carries(i) ? problem.load() / n : 0;
}

}  // namespace

HaarTask task_of(const Problem& problem, const TreeInputs& inputs) {
  return {.by_load = problem.load_control(),
          .load = problem.load(),
          .cap = problem.cap(),
          .tol = problem.tol(),
          .least_scale = problem.least_scale(),
          .periodic_mean = inputs.table.mean,
          .elongated = inputs.elongated,
          .patience = static_cast<int>(problem.option_int("haar-cg.patience"))};
}

bool serves(const Problem& problem, const char* solver, std::span<const double> p) {
  const auto sum = [&](std::int64_t begin, std::int64_t count) {
    return sum_of(static_cast<std::size_t>(count),
                  [&](std::size_t i) { return std::max(p[static_cast<std::size_t>(begin) + i], 0.0); });
  };
  const double load =
      reduce<double>(problem.size(), problem.team(), sum, 0, std::plus<>(), Chunks::of(problem.ranks(), problem.grid()->nx));
  const rc_grid& grid = *problem.grid();
  // If few points may touch, a coarse grid of all points would cost more than the steps.
  const bool sparse = grid.index && problem.size() < grid.nx * grid.ny / 8;
  if (!problem.load_control() || !solver || !nests(grid) || sparse) return load > 0;
  return load * farthest > problem.load() && load < problem.load() * farthest;
}

void start_haar_cg(const Problem& problem, const CoarseSolver& solver, std::span<double> p, double& d) {
  if (solver.name && start_nested(problem, solver, p, d)) return;
  std::ranges::fill(p, 0.0);
  if (problem.load_control()) start_cold(problem, p);
}

}  // namespace rc
