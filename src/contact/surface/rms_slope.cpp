#include "contact/surface/rms_slope.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/chunks.h"

namespace rc {

namespace {

struct Squares {
  double sum = 0, count = 0;
  Squares operator+(const Squares& b) const { return {sum + b.sum, count + b.count}; }
  void add(double slope) {
    if (std::isnan(slope)) return;
    sum += slope * slope;
    ++count;
  }
};

struct FirstRow {
  std::int64_t row;
  double gap;
};

double gap_or_nan(const StepSurface& surface, std::int64_t point) {
  const auto i = static_cast<std::size_t>(point);
  return surface.included(i) ? surface.gap_at(i) : std::numeric_limits<double>::quiet_NaN();
}

// The row after this process's rows, of the process that has it; empty if there is none.
std::vector<double> row_below(const StepSurface& surface) {
  const SurfacePoints& points = surface.points();
  const Rows& rows = points.rows();
  std::vector<double> row;
  if (!rows.shared()) return row;
  std::vector<FirstRow> mine;
  rows.on_all([&] {
    for (std::int64_t x = 0; x < std::min(points.nx(), points.count()); ++x)
      mine.push_back({rows.first(), gap_or_nan(surface, x)});
  });
  const std::int64_t next = rows.first() + points.count() / points.nx();
  const std::vector<FirstRow> all = rows.joined(std::move(mine));
  rows.on_all([&] {
    for (const FirstRow& each : all)
      if (each.row == next) row.push_back(each.gap);
  });
  return row;
}

}  // namespace

double rms_slope(const StepSurface& surface, double hx, double hy) {
  const SurfacePoints& points = surface.points();
  const std::int64_t nx = points.nx(), n = points.count();
  const std::vector<double> below = row_below(surface);
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    Squares part;
    for (std::int64_t i = begin; i < begin + count; ++i) {
      const double here = gap_or_nan(surface, i);
      if (i % nx + 1 < nx) part.add((gap_or_nan(surface, i + 1) - here) / hx);
      if (i + nx < n)
        part.add((gap_or_nan(surface, i + nx) - here) / hy);
      else if (!below.empty())
        part.add((below[static_cast<std::size_t>(i % nx)] - here) / hy);
    }
    return part;
  };
  const Squares all = reduce<Squares>(n, points.team(), body, {}, {}, points.chunks());
  return all.count > 0 ? std::sqrt(2 * all.sum / all.count) : 0;
}

}  // namespace rc
