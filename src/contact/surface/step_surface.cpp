#include "contact/surface/step_surface.h"

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "core/grid.h"
#include "core/large_memory.h"
#include "core/limits.h"

namespace rc {

namespace {

// Results of a pass over one row of tiles.
struct Summary {
  double lowest = infinite, highest = -infinite;
  std::int64_t included = 0, bad = 0, first_bad = -1;
  double bad_value = 0;

  void add(double gap, std::int64_t point) {
    ++included;
    if (!std::isfinite(gap)) {
      if (bad++ == 0) {
        first_bad = point;
        bad_value = gap;
      }
      return;
    }
    lowest = std::min(lowest, gap);
    highest = std::max(highest, gap);
  }
  friend Summary operator+(const Summary& a, const Summary& b) {
    const Summary& first = a.bad > 0 ? a : b;
    return {std::min(a.lowest, b.lowest),
            std::max(a.highest, b.highest),
            a.included + b.included,
            a.bad + b.bad,
            first.first_bad,
            first.bad_value};
  }
};

// Adds n points, none of them masked. False, with nothing added, if one is not finite: times 0 that is NaN.
template <class Real> bool add_finite(Summary& summary, const Real* gap, std::int64_t n, double& lowest) {
  Real low = std::numeric_limits<Real>::infinity(), high = -low, doubt = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    low = gap[i] < low ? gap[i] : low;
    high = gap[i] > high ? gap[i] : high;
    doubt += gap[i] * Real{0};
  }
  if (!(doubt == 0)) return false;
  summary.included += n;
  summary.lowest = std::min<double>(summary.lowest, low);
  summary.highest = std::max<double>(summary.highest, high);
  lowest = std::min<double>(lowest, low);
  return true;
}

}  // namespace

StepSurface::StepSurface(const GivenSurface& given, const rc_team& team, const Rows& rows)
    : points_(given.nx, given.nx * given.ny, team, rows), tiles_{given.nx, given.ny} {
  constexpr std::int64_t tile = TileLows::side;
  const std::int64_t nx = given.nx, columns = tiles_.columns(), tile_rows = tiles_.rows();
  std::vector<Summary> summaries;
  const auto own = [&]<class Real>(std::unique_ptr<Real[]>& values) {
    values = std::make_unique_for_overwrite<Real[]>(given.gap.size());
    prefer_large(values.get(), given.gap.size() * sizeof(Real));
    return GapValues(std::span<const Real>(values.get(), given.gap.size()));
  };
  rows.on_all([&] {
    tiles_.lowest.assign(static_cast<std::size_t>(columns * tile_rows), infinite);
    summaries.resize(static_cast<std::size_t>(tile_rows));
    if (!given.borrowed) own_mask_.assign(given.mask.begin(), given.mask.end());
    gap_ = given.borrowed ? given.gap : given.gap.in_single() ? own(own_single_gap_) : own(own_gap_);
    if (!given.mask.empty()) mask_ = given.borrowed ? given.mask : own_mask_;
  });
  points_.each(tile_rows, [&](std::int64_t row) {
    Summary& summary = summaries[static_cast<std::size_t>(row)];
    for (std::int64_t y = row * tile; y < std::min((row + 1) * tile, given.ny); ++y) {
      if (own_gap_) std::copy_n(given.gap.in_double() + y * nx, nx, own_gap_.get() + y * nx);
      if (own_single_gap_) std::copy_n(given.gap.in_single() + y * nx, nx, own_single_gap_.get() + y * nx);
      for (std::int64_t column = 0; column < columns; ++column) {
        double& lowest = tiles_.lowest[static_cast<std::size_t>(row * columns + column)];
        const std::int64_t begin = y * nx + column * tile, end = y * nx + std::min((column + 1) * tile, nx);
        const auto add = [&](const auto* gap) { return add_finite(summary, gap + begin, end - begin, lowest); };
        if (mask_.empty() && given.gap.visit(add)) continue;
        for (std::int64_t point = begin; point < end; ++point) {
          if (!included(static_cast<std::size_t>(point))) continue;
          summary.add(given.gap[static_cast<std::size_t>(point)], point);
          lowest = std::min(lowest, given.gap[static_cast<std::size_t>(point)]);
        }
      }
    }
  });
  Summary whole;
  for (const Summary& each : summaries) whole = whole + each;
  if (whole.bad > 0) whole.first_bad += rows.first() * nx;
  whole = rows.united(whole);
  if (whole.bad > 0)
    fail(RC_ERR_ARGUMENT, "gap has ", whole.bad, " value(s) that are not finite, first at ", place(whole.first_bad, nx), " (",
         whole.bad_value, "); exclude them with rc_step.mask");
  range_ = {whole.included, whole.included == nx * rows.all(given.ny), whole.lowest, whole.highest};
  if (given.roundings > 0 && whole.included > 0)
    range_.rounding = given.roundings * epsilon / 2 * std::max(std::abs(whole.lowest), std::abs(whole.highest));
  if (given.side > 0 && rows.shared()) rows.on_all([&] { fill_masked(given.side); });
}

StepSurface::StepSurface(const StepSurface& shared, const rc_team& team)
    : tiles_{shared.tiles_.nx, shared.points_.rows().all(shared.tiles_.ny)},
      gathered_(std::make_unique<GatheredTiles>(shared)),
      range_(shared.range_) {
  points_ = SurfacePoints(tiles_.nx, tiles_.nx * tiles_.ny, team);
}

void StepSurface::fill_masked(double side) {
  if (mask_.empty()) return;
  const double far = range_.highest + 1e6 * std::max(range_.width(), side);
  const auto fill = [&]<class Real>(std::vector<Real>& to, const Real* from) {
    to.assign(from, from + gap_.size());
    for (std::size_t i = 0; i < to.size(); ++i)
      if (!included(i)) to[i] = static_cast<Real>(far);
    filled_ = std::span<const Real>(to);
  };
  if (gap_.in_single())
    fill(filled_single_, gap_.in_single());
  else
    fill(filled_double_, gap_.in_double());
}

rc_const_array StepSurface::gap_for_solver(bool takes_single) const {
  if (takes_single) return (filled_.empty() ? gap_ : filled_).array();
  if (gap_.in_double() || gap_.empty()) return {gap_.in_double(), RC_NATIVE, 0, nullptr};
  if (gap_in_double_.empty()) gap_in_double_.assign(gap_.in_single(), gap_.in_single() + gap_.size());
  return {gap_in_double_.data(), RC_NATIVE, 0, nullptr};
}

const HeightMoments& StepSurface::moments() const {
  if (gathered_) return own().moments();
  if (!moments_) moments_ = moments_of(*this);
  return *moments_;
}

double GapRange::limit_of(double height) const {
  const double limit = lowest + height;
  return limit - lowest < height ? std::nextafter(limit, infinite) : limit;
}

bool same_surface(const StepSurface& a, const StepSurface& b) {
  if (a.gap().is_array_of(b.gap()) && a.mask().data() == b.mask().data()) return true;
  if (a.gap().size() != b.gap().size() || a.mask().size() != b.mask().size() || a.lowest() != b.lowest() ||
      a.tiles().lowest != b.tiles().lowest)
    return false;
  const std::int64_t nx = a.tiles().nx, ny = a.tiles().ny;
  std::vector<std::uint8_t> differs(static_cast<std::size_t>(ny), 0);
  a.points().each(ny, [&](std::int64_t y) {
    for (auto i = static_cast<std::size_t>(y * nx); i < static_cast<std::size_t>((y + 1) * nx); ++i)
      if (a.included(i) != b.included(i) || (a.included(i) && a.gap()[i] != b.gap()[i])) {
        differs[static_cast<std::size_t>(y)] = 1;
        return;
      }
  });
  return std::find(differs.begin(), differs.end(), 1) == differs.end();
}

void heights_of(const TrialSet& trial, const StepSurface& surface, std::size_t first, std::size_t n, double* to) {
  if (surface.gathered()) {
    for (std::size_t k = 0; k < n; ++k)
      to[k] = surface.height(static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(first + k))));
    return;
  }
  surface.gap().visit([&, lowest = surface.lowest()](const auto* gap) {
    const std::int64_t* const index = trial.index.empty() ? nullptr : trial.index.data() + first;
    for (std::size_t k = 0; k < n; ++k) to[k] = static_cast<double>(index ? gap[index[k]] : gap[first + k]) - lowest;
  });
}

}  // namespace rc
