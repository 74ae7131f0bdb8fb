// Cascade multi-resolution: Bemporad & Paggi (2015), Algorithm 6. Only points near the contacts of a coarser representation of
// the surface are candidates on the next finer one.
//
// Changes to the printed algorithm: a point is kept if it is near some coarse contact (not near all); each level is compressed
// by the same amount below its own highest point; without any coarse contact all points are kept; and excluded points that
// overlap are added until none overlaps, which certifies the answer. cmr.certified = 0 leaves this last part out, as published.
//
// With cmr.select = gap the last step differs. One product with the pressure of the next coarser grid gives the gap on the given
// grid, and the tiles in which it is nearly closed are kept. This finds islands that the coarser grid did not have, and keeps
// few points that the contact does not need.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/boundary.h"
#include "core/text.h"
#include "grid/downsample.h"
#include "solvers/solver.h"

namespace rc::cmr {

namespace {

constexpr std::int64_t coarsest_side = 16;  // fewest points a side on the coarsest grid of an automatic cascade, as in the paper
constexpr int most_added_rounds = 20;       // of adding points; each adds at least one
constexpr std::int64_t most_levels = 30;

// Selection by gaps: points along the side of a tile; a gap below this share of the surface's roughness is nearly closed.
constexpr std::int64_t tile = 16;
constexpr double nearly_closed = 0.01;

using Mask = std::vector<std::uint8_t>;

class Cascade {
 public:
  Cascade(const Problem& problem, Vector& p)
      : problem_(problem),
        grid_(*problem.grid()),
        p_(p),
        n_(problem.size()),
        inner_(problem.option_text("cmr.inner")),
        certified_(problem.option_int("cmr.certified") != 0),
        by_gap_(problem.option_text("cmr.select") == "gap"),
        radius_(problem.option_real("cmr.radius") * (problem.option_text("cmr.area") == "diagonal" ? std::numbers::sqrt2 : 1.0)) {
    const std::string filter = problem.option_text("cmr.filter");
    filter_ = filter == "subsample" ? Filter::subsample : filter == "mean" ? Filter::mean : Filter::max;
  }

  rc_status run() {
    if (inner_ == "cmr") problem_.fail(RC_ERR_INCOMPATIBLE, "cmr.inner = cmr: a cascade cannot be its own inner solver");
    coarsen();
    Mask trial = descend();
    if (trial.empty()) {
      remark_ = "no usable contact on a coarser grid, so every candidate was kept";
      problem_.note("cmr: " + remark_);
      trial.assign(static_cast<std::size_t>(n_), 1);
    }
    return certified_ ? solve_certified(trial) : solve(trial, nullptr);
  }

 private:
  void coarsen() {
    const std::int64_t wanted = problem_.option_int("cmr.levels");
    std::int64_t nx = grid_.nx, ny = grid_.ny;
    GapValues gap = problem_.gap();
    std::span<const std::uint8_t> mask = problem_.mask();
    for (std::int64_t finer = 1; finer < (wanted > 0 ? wanted : most_levels); ++finer) {
      if (std::max(nx, ny) < 2 || (wanted == 0 && std::min(nx, ny) < 2 * coarsest_side)) break;
      levels_.push_back(downsample(nx, ny, gap, mask, filter_));
      nx = levels_.back().nx;
      ny = levels_.back().ny;
      gap = levels_.back().gap;
      mask = levels_.back().mask;
    }
  }

  // Solves the cascade from its coarsest grid. Returns which unknowns to keep; empty if a level failed or had no contact.
  Mask descend() {
    if (levels_.empty()) return Mask(static_cast<std::size_t>(n_), 1);
    Mask allowed;  // on the present grid; empty: every point
    for (std::size_t k = levels_.size(); k-- > 0;) {
      const CoarseGrid& level = levels_[k];
      if (!allowed.empty()) {
        for (std::size_t i = 0; i < allowed.size(); ++i) allowed[i] = allowed[i] && (level.mask.empty() || level.mask[i]);
      } else {
        allowed = level.mask;
      }
      Vector p(level.gap.size());
      const double lowest = lowest_gap(level.gap, level.mask),
                   depth = grid_.approach - lowest_gap(problem_.gap(), problem_.mask());
      rc_coarse request{};
      request.struct_size = sizeof request;
      request.nx = level.nx;
      request.ny = level.ny;
      request.factor = std::int64_t{2} << k;
      request.undeformed_gap = level.gap.data();
      request.mask = allowed.empty() ? nullptr : allowed.data();
      request.control = RC_CONTROL_APPROACH;
      request.approach = lowest + depth;
      request.solver = inner_.c_str();
      request.p = p.data();
      request.keep = 1;
      if (problem_.coarse(request) < 0) return {};
      if (k == 0 && by_gap_) return nearly_closed_tiles(level, p);
      const std::int64_t nx = k > 0 ? levels_[k - 1].nx : grid_.nx, ny = k > 0 ? levels_[k - 1].ny : grid_.ny;
      allowed = near_contacts(level, p, nx, ny);
      if (allowed.empty()) return {};
    }
    Mask keep(static_cast<std::size_t>(n_));
    for (std::int64_t i = 0; i < n_; ++i)
      keep[static_cast<std::size_t>(i)] = allowed[static_cast<std::size_t>(problem_.point(i))];
    return keep;
  }

  static double lowest_gap(const GapValues& gap, std::span<const std::uint8_t> mask) {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < gap.size(); ++i)
      if (mask.empty() || mask[i]) lowest = std::min(lowest, gap[i]);
    return lowest;
  }

  // The unknowns of tiles in which the coarser grid's pressure acts or leaves a gap nearly closed. Empty without such pressure.
  Mask nearly_closed_tiles(const CoarseGrid& level, const Vector& coarse) {
    const auto size = static_cast<std::size_t>(n_);
    Vector p(size), w(size);
    bool any = false;
    for (std::size_t i = 0; i < size; ++i) {
      const std::int64_t at = problem_.point(static_cast<std::int64_t>(i)), x = at % grid_.nx / 2, y = at / grid_.nx / 2;
      p[i] = std::max(0.0, coarse[static_cast<std::size_t>(y * level.nx + x)] / problem_.pressure_unit());
      any = any || p[i] > 0;
    }
    if (!any) return {};
    problem_.apply(p, w);
    const double limit = nearly_closed * roughness() / problem_.length_unit();
    const std::int64_t columns = (grid_.nx + tile - 1) / tile, rows = (grid_.ny + tile - 1) / tile;
    Mask active(static_cast<std::size_t>(columns * rows), 0), keep(size);
    const auto tile_of = [&](std::size_t i) {
      const std::int64_t at = problem_.point(static_cast<std::int64_t>(i));
      return static_cast<std::size_t>(at / grid_.nx / tile * columns + at % grid_.nx / tile);
    };
    for (std::size_t i = 0; i < size; ++i)
      if (p[i] > 0 || w[i] - problem_.u()[i] < limit) active[tile_of(i)] = 1;
    for (std::size_t i = 0; i < size; ++i) keep[i] = active[tile_of(i)];
    // Without a warm start the inner solver starts from the coarser grid's pressure.
    if (std::none_of(p_.begin(), p_.end(), [](double value) { return value > 0; })) p_ = p;
    return keep;
  }

  // Standard deviation of the gap [length].
  double roughness() const {
    double count = 0, mean = 0, squares = 0;  // of the deviations from the mean so far
    const GapValues gap = problem_.gap();
    for (std::size_t i = 0; i < gap.size(); ++i) {
      if (grid_.mask && !grid_.mask[i]) continue;
      const double off = gap[i] - mean;
      mean += off / ++count;
      squares += off * (gap[i] - mean);
    }
    return count > 0 ? std::sqrt(squares / count) : 0.0;
  }

  // Points of the next finer grid that lie in the area of influence of a coarse contact. Empty if there is no contact.
  Mask near_contacts(const CoarseGrid& level, const Vector& p, std::int64_t nx, std::int64_t ny) const {
    // Lengths in cells of the finer grid. A subsampled coarse point lies at its fine point, others in the middle of their block.
    const double offset = filter_ == Filter::subsample ? 0 : 0.5, reach = 2 * radius_;
    const auto rows = std::min(static_cast<std::int64_t>(std::ceil(reach + offset)), ny);
    Mask near(static_cast<std::size_t>(nx * ny), 0);
    bool any = false;
    for (std::int64_t j = 0; j < level.ny; ++j)
      for (std::int64_t i = 0; i < level.nx; ++i) {
        if (!(p[static_cast<std::size_t>(j * level.nx + i)] > 0)) continue;
        any = true;
        for (std::int64_t dy = -rows; dy <= rows; ++dy) {
          const double y = static_cast<double>(dy) - offset, squared = reach * reach * (1 + 1e-12) - y * y;
          if (squared < 0) continue;
          const double center = static_cast<double>(2 * i) + offset, half = std::sqrt(squared);
          mark_row(near, nx, ny, 2 * j + dy, static_cast<std::int64_t>(std::ceil(center - half)),
                   static_cast<std::int64_t>(std::floor(center + half)));
        }
      }
    return any ? near : Mask{};
  }

  // Marks the points first .. last of a row. Those beyond the grid are wrapped along an axis that repeats, else cut off.
  void mark_row(Mask& near, std::int64_t nx, std::int64_t ny, std::int64_t row, std::int64_t first, std::int64_t last) const {
    const auto fill = [&](std::int64_t from, std::int64_t to) {
      if (from <= to) std::fill(near.begin() + row * nx + from, near.begin() + row * nx + to + 1, std::uint8_t{1});
    };
    if (repeats_along_y(grid_.boundary)) row = (row % ny + ny) % ny;
    if (row < 0 || row >= ny) return;
    if (!repeats_along_x(grid_.boundary)) return fill(std::max<std::int64_t>(first, 0), std::min(last, nx - 1));
    if (last - first + 1 >= nx) return fill(0, nx - 1);
    first = (first % nx + nx) % nx;
    last = (last % nx + nx) % nx;
    if (first <= last) return fill(first, last);
    fill(0, last);
    fill(first, nx - 1);
  }

  // Solves with pressure on the trial set only. product: null, or receives H p over all unknowns.
  rc_status solve(const Mask& trial, Vector* product) {
    Positions kept;
    for (std::int64_t i = 0; i < n_; ++i)
      if (trial[static_cast<std::size_t>(i)]) kept.push_back(i);
    kept_ = kept.size();
    const rc_status status = problem_.inner(inner_.c_str(), kept, p_.data(), product);
    if (status < 0) check(status);
    return status;
  }

  rc_status solve_certified(Mask trial) {
    const double* u = problem_.u();
    Vector product(static_cast<std::size_t>(n_));
    for (std::size_t i = 0; i < trial.size(); ++i) trial[i] = trial[i] || p_[i] > 0;
    std::int64_t added = 0;
    for (int round = 1;; ++round) {
      const rc_status status = solve(trial, &product);
      if (status == RC_STOP_CANCELLED || status == RC_STOP_TIME || status == RC_STOP_MAX_ITER) return status;
      double worst = 0;
      bool complete = true;
      for (std::size_t i = 0; i < trial.size(); ++i) {
        const double overlap = u[i] - product[i];
        if (trial[i]) continue;
        worst = std::max(worst, overlap);
        if (!(overlap > problem_.tol())) continue;
        trial[i] = 1;
        complete = false;
        ++added;
      }
      problem_.poll(round, worst);
      if (complete || status != RC_OK || round == most_added_rounds) {
        remark_ = join("trial set ", kept_, " of ", n_, " after ", round, " rounds",
                       added > 0 ? join(", ", added, " points added") : "", remark_.empty() ? "" : "; ", remark_);
        problem_.note("cmr: " + remark_);
        return complete ? status : RC_UNCERTIFIED;
      }
    }
  }

  const Problem& problem_;
  const rc_grid& grid_;
  Vector& p_;
  const std::int64_t n_;
  const std::string inner_;
  const bool certified_, by_gap_;
  const double radius_;  // of the area of influence, in cells of the coarse grid
  Filter filter_;
  std::vector<CoarseGrid> levels_;  // [0] is half as fine as the problem's grid
  std::size_t kept_ = 0;
  std::string remark_;
};

constexpr rc_component inner = text_option("cmr.inner", "auto", nullptr, "solver on every level, by name");
constexpr rc_component levels =
    int_option("cmr.levels", "0", 0, most_levels, "grids of the cascade, the given one included; 0: down to 16 points a side");
constexpr rc_component radius = real_option("cmr.radius", "2", 1, 1000, "h: radius of the area of influence in coarse cells");
constexpr rc_component area =
    text_option("cmr.area", "diagonal", "diagonal|side",
                "the radius is h diagonals of a coarse cell (Bemporad & Paggi's text) or h sides (their Algorithm 6)");
constexpr rc_component filter = text_option("cmr.filter", "max", "subsample|mean|max",
                                            "what a coarse point takes from its four heights: one, their mean or the highest");
constexpr rc_component certified = int_option(
    "cmr.certified", "1", 0, 1, "1: add points that overlap and solve again until none does; 0: as published, may be wrong");
constexpr rc_component select = text_option("cmr.select", "influence", "influence|gap",
                                            "points of the given grid that are kept: those near contact on the coarser one, "
                                            "or tiles whose gap under the coarser pressure nearly closes");
constexpr const rc_component* specs[] = {&inner, &levels, &radius, &area, &filter, &certified, &select};

}  // namespace

const Options options = listed(specs);

rc_status solve(const Problem& problem, Vector& p, double&) { return Cascade(problem, p).run(); }

}  // namespace rc::cmr
