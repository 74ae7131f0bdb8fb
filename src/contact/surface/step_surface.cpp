#include "contact/surface/step_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <roughcontact/plugin.hpp>

#include "core/error.h"
#include "core/large_memory.h"
#include "core/limits.h"

namespace rc {

namespace {

constexpr std::int64_t tile = StepSurface::tile;

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

StepSurface::StepSurface(const GivenSurface& given, const rc_team& team, const Company& company)
    : team_(&team), company_(company), nx_(given.nx), ny_(given.ny), all_points_(nx_ * company.all_rows(ny_)) {
  const std::int64_t columns = tiles_x(), rows = (ny_ + tile - 1) / tile;
  std::vector<Summary> summaries;
  const auto own = [&]<class Real>(std::unique_ptr<Real[]>& values) {
    values = std::make_unique_for_overwrite<Real[]>(given.gap.size());
    prefer_large(values.get(), given.gap.size() * sizeof(Real));
    return GapValues(std::span<const Real>(values.get(), given.gap.size()));
  };
  company.on_all([&] {
    tile_lowest_.assign(static_cast<std::size_t>(columns * rows), infinite);
    summaries.resize(static_cast<std::size_t>(rows));
    if (!given.borrowed) own_mask_.assign(given.mask.begin(), given.mask.end());
    gap_ = given.borrowed ? given.gap : given.gap.in_single() ? own(own_single_gap_) : own(own_gap_);
    mask_ = given.borrowed ? given.mask : own_mask_;
  });
  roughcontact::for_each(team, rows, threaded(), [&](std::int64_t row, std::int64_t) {
    Summary& summary = summaries[static_cast<std::size_t>(row)];
    for (std::int64_t y = row * tile; y < std::min((row + 1) * tile, ny_); ++y) {
      if (own_gap_) std::copy_n(given.gap.in_double() + y * nx_, nx_, own_gap_.get() + y * nx_);
      if (own_single_gap_) std::copy_n(given.gap.in_single() + y * nx_, nx_, own_single_gap_.get() + y * nx_);
      for (std::int64_t column = 0; column < columns; ++column) {
        double& lowest = tile_lowest_[static_cast<std::size_t>(row * columns + column)];
        const std::int64_t begin = y * nx_ + column * tile, end = y * nx_ + std::min((column + 1) * tile, nx_);
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
  if (whole.bad > 0) whole.first_bad += first_row() * nx_;
  whole = united(whole);
  if (whole.bad > 0)
    fail(RC_ERR_ARGUMENT, "gap has ", whole.bad, " value(s) that are not finite, first at index ", whole.first_bad, " (",
         whole.bad_value, "); exclude them with rc_step.mask");
  included_points_ = whole.included;
  lowest_ = whole.lowest;
  highest_ = whole.highest;
}

StepSurface::StepSurface(const StepSurface& shared, const rc_team& team)
    : team_(&team),
      tiles_(std::make_unique<GatheredTiles>(shared)),
      nx_(shared.nx_),
      ny_(shared.company_.all_rows(shared.ny_)),
      all_points_(shared.all_points_),
      included_points_(shared.included_points_),
      lowest_(shared.lowest_),
      highest_(shared.highest_) {}

void StepSurface::fill_masked(double side) {
  if (mask_.empty()) return;
  const double far = highest_ + 1e6 * std::max(range(), side);
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

bool StepSurface::equals(const StepSurface& other, const rc_team& team) const {
  if (gap_.is_array_of(other.gap_) && mask_.data() == other.mask_.data()) return true;
  if (gap_.size() != other.gap_.size() || mask_.size() != other.mask_.size() || lowest_ != other.lowest_ ||
      tile_lowest_ != other.tile_lowest_)
    return false;
  std::vector<std::uint8_t> differs(static_cast<std::size_t>(ny_), 0);
  roughcontact::for_each(team, ny_, threaded(), [&](std::int64_t y, std::int64_t) {
    for (auto i = static_cast<std::size_t>(y * nx_); i < static_cast<std::size_t>((y + 1) * nx_); ++i)
      if (included(i) != other.included(i) || (included(i) && gap_[i] != other.gap_[i])) {
        differs[static_cast<std::size_t>(y)] = 1;
        return;
      }
  });
  return std::find(differs.begin(), differs.end(), 1) == differs.end();
}

namespace {

// act(point, x, y) for the points of tile number `index`, row by row.
template <class Action>
void visit_tile(std::int64_t index, std::int64_t nx, std::int64_t ny, std::int64_t columns, const Action& act) {
  const std::int64_t left = index % columns * tile, low = index / columns * tile;
  for (std::int64_t y = low; y < std::min(low + tile, ny); ++y)
    for (std::int64_t x = left; x < std::min(left + tile, nx); ++x) act(y * nx + x, x, y);
}

}  // namespace

namespace {

// Adds the points with gap < limit in columns begin .. end-1 of row y. gap: of that row.
template <class Value>
void add_below(double limit, const Value* gap, std::int64_t begin, std::int64_t end, std::int64_t y, Extent& extent) {
  const auto below = [&](std::int64_t x) { return static_cast<double>(gap[x]) < limit; };
  std::int64_t n = 0;
  for (std::int64_t x = begin; x < end; ++x) n += below(x);
  if (n == 0) return;
  std::int64_t left = begin, right = end - 1;  // looked for where they widen the extent
  while (left < extent.left && !below(left)) ++left;
  while (right > extent.right && !below(right)) --right;
  extent = extent + Extent{n, left, right, y, y};
}

}  // namespace

// Of each row of tiles.
std::vector<Extent> StepSurface::extents_below(double limit) const {
  std::vector<Extent> rows(static_cast<std::size_t>((ny_ + tile - 1) / tile));
  const std::int64_t columns = tiles_x();
  const auto unmasked = [&](std::int64_t row, Extent& extent) {
    gap_.visit([&](const auto* gap) {
      for (std::int64_t y = row * tile; y < std::min((row + 1) * tile, ny_); ++y)
        for (std::int64_t column = 0; column < columns; ++column)
          if (tile_lowest_[static_cast<std::size_t>(row * columns + column)] < limit)
            add_below(limit, gap + y * nx_, column * tile, std::min((column + 1) * tile, nx_), y, extent);
    });
  };
  roughcontact::for_each(*team_, static_cast<std::int64_t>(rows.size()), threaded(), [&](std::int64_t row, std::int64_t) {
    Extent& extent = rows[static_cast<std::size_t>(row)];
    if (mask_.empty()) return unmasked(row, extent);
    visit_below(limit, row, [&](std::int64_t, std::int64_t x, std::int64_t y) { extent.add(x, y); });
  });
  return rows;
}

Extent StepSurface::own_extent_below(double limit) const {
  Extent extent;
  for (const Extent& row : extents_below(limit)) extent = extent + row;
  if (extent.n > 0) {
    extent.low += first_row();
    extent.high += first_row();
  }
  return extent;
}

Extent StepSurface::extent_below(double limit) const {
  return tiles_ ? tiles_->shared().extent_below(limit) : united(own_extent_below(limit));
}

TrialSet StepSurface::below(double limit) const {
  TrialSet trial;
  if (tiles_) {
    const StepSurface& shared = tiles_->shared();
    const TrialSet own = shared.below(limit);
    std::vector<std::int64_t> mine(static_cast<std::size_t>(own.n));
    for (std::int64_t i = 0; i < own.n; ++i) mine[static_cast<std::size_t>(i)] = own.point(i) + shared.first_row() * nx_;
    trial.index = shared.company().joined(std::move(mine));
    trial.n = static_cast<std::int64_t>(trial.index.size());
    tiles_->hold_tiles_of(trial.index);
    return trial;
  }
  const std::vector<Extent> rows = extents_below(limit);
  std::vector<std::int64_t> begin;
  for (const Extent& row : rows) {
    begin.push_back(trial.n);
    trial.n += row.n;
  }
  if (trial.n == static_cast<std::int64_t>(gap_.size())) return trial;
  trial.index = large_vector<std::int64_t>(static_cast<std::size_t>(trial.n));
  roughcontact::for_each(*team_, static_cast<std::int64_t>(rows.size()), threaded(), [&](std::int64_t row, std::int64_t) {
    std::int64_t* to = trial.index.data() + begin[static_cast<std::size_t>(row)];
    visit_below(limit, row, [&](std::int64_t point, std::int64_t, std::int64_t) { *to++ = point; });
  });
  return trial;
}

TrialSet StepSurface::below(double limit, std::span<const std::int64_t> tiles) const {
  TrialSet trial;
  if (tiles_) tiles_->hold(tiles);
  for (const std::int64_t each : tiles)
    visit_tile(each, nx_, ny_, tiles_x(), [&](std::int64_t point, std::int64_t, std::int64_t) {
      if (included(static_cast<std::size_t>(point)) && gap_at(static_cast<std::size_t>(point)) < limit)
        trial.index.push_back(point);
    });
  std::sort(trial.index.begin(), trial.index.end());
  trial.n = static_cast<std::int64_t>(trial.index.size());
  if (trial.n == points()) trial.index.clear();
  return trial;
}

const double* StepSurface::gap_in_double() const {
  if (gap_.in_double() || gap_.empty()) return gap_.in_double();
  if (gap_in_double_.empty()) gap_in_double_.assign(gap_.in_single(), gap_.in_single() + gap_.size());
  return gap_in_double_.data();
}

void StepSurface::heights(const TrialSet& of, std::size_t first, std::size_t n, double* to) const {
  if (tiles_) {
    for (std::size_t k = 0; k < n; ++k) to[k] = height(static_cast<std::size_t>(of.point(static_cast<std::int64_t>(first + k))));
    return;
  }
  gap_.visit([&](const auto* gap) {
    const std::int64_t* const index = of.index.empty() ? nullptr : of.index.data() + first;
    for (std::size_t k = 0; k < n; ++k) to[k] = static_cast<double>(index ? gap[index[k]] : gap[first + k]) - lowest_;
  });
}

namespace {

// Of a number of heights; joins those of two sets without cancellation.
struct Moments {
  double n = 0, mean = 0, square = 0;  // square: the sum of squared differences to the mean

  Moments operator+(const Moments& b) const {
    if (b.n == 0) return *this;
    const double all = n + b.n, apart = b.mean - mean;
    return {all, mean + apart * (b.n / all), square + b.square + apart * apart * (n / all * b.n)};
  }
};

// The sum of term(0) .. term(n-1).
template <class Term> double sum_of_points(std::int64_t n, const Term& term) {
  constexpr std::int64_t lanes = 8;
  double sum[lanes] = {};
  std::int64_t k = 0;
  for (; k + lanes <= n; k += lanes)
    for (std::int64_t lane = 0; lane < lanes; ++lane) sum[lane] += term(k + lane);
  for (; k < n; ++k) sum[0] += term(k);
  return std::accumulate(sum, sum + lanes, 0.0);
}

}  // namespace

const StepSurface::HeightMoments& StepSurface::height_moments() const {
  if (tiles_) return tiles_->shared().height_moments();
  if (height_moments_) return *height_moments_;
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    constexpr std::int64_t together = 512;
    double height[together];
    Moments all;
    for (std::int64_t first = begin; first < begin + count; first += together) {
      std::int64_t n = std::min(together, begin + count - first);
      heights({}, static_cast<std::size_t>(first), static_cast<std::size_t>(n), height);
      if (!whole()) {
        const std::int64_t read = n;
        n = 0;
        for (std::int64_t k = 0; k < read; ++k)
          if (included(static_cast<std::size_t>(first + k))) height[n++] = height[k];
      }
      const double mean =
          sum_of_points(n, [&](std::int64_t k) { return height[k]; }) / static_cast<double>(std::max<std::int64_t>(n, 1));
      all = all + Moments{static_cast<double>(n), mean,
                          sum_of_points(n, [&](std::int64_t k) { return (height[k] - mean) * (height[k] - mean); })};
    }
    return all;
  };
  const Moments all = reduce<Moments>(points(), team(), body, {}, {}, chunks());
  height_moments_ = {all.mean, all.square};
  return *height_moments_;
}

double StepSurface::limit_of(double height) const {
  const double limit = lowest_ + height;
  return limit - lowest_ < height ? std::nextafter(limit, infinite) : limit;
}

namespace {

Extent extent_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  if (trial.index.empty()) return {nx * ny, 0, nx - 1, 0, ny - 1};
  Extent extent;
  extent.n = trial.n;
  extent.low = trial.index.front() / nx;
  extent.high = trial.index.back() / nx;
  for (auto at = trial.index.begin(); at != trial.index.end();) {  // once for each row, from its first point to its last
    const std::int64_t row = *at / nx * nx;
    const auto next = std::lower_bound(at, trial.index.end(), row + nx);
    extent.left = std::min(extent.left, *at - row);
    extent.right = std::max(extent.right, *(next - 1) - row);
    at = next;
  }
  return extent;
}

}  // namespace

std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny) { return extent_of(trial, nx, ny).box(); }

TrialSet box_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  const Extent box = extent_of(trial, nx, ny);
  TrialSet all{box.box(), {}, trial.zero_mode};
  if (all.n == nx * ny) return all;
  all.index.reserve(static_cast<std::size_t>(all.n));
  for (std::int64_t y = box.low; y <= box.high; ++y)
    for (std::int64_t x = box.left; x <= box.right; ++x) all.index.push_back(y * nx + x);
  return all;
}

}  // namespace rc
