#include "contact/surface/bearing.h"

#include <algorithm>
#include <cmath>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "contact/surface/step_surface.h"
#include "core/rows.h"
#include "core/start_terms.h"

namespace rc {

namespace {

constexpr std::size_t bins = 1024;
constexpr std::size_t histograms = 16;  // each of a part of the surface, whatever the number of threads
constexpr double fine = 1 << 16;        // steps of a range: sums of whole steps do not depend on who adds them

// Counts and sums of heights by bins of equal width over [0, range).
struct Histogram {
  explicit Histogram(double over) : range(over), count(bins, 0.0), sum(bins, 0.0) {}
  void add(double height) {
    if (!(height < range)) return;
    const auto bin = std::min(static_cast<std::size_t>(height / range * static_cast<double>(bins)), bins - 1);
    count[bin] += 1;
    sum[bin] += height;
  }
  // The upper edge of the first bin at which the bed of springs carries the load; range if none does.
  double reach(double target) const {
    double points = 0, heights = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      points += count[bin];
      heights += sum[bin];
      const double edge = range * static_cast<double>(bin + 1) / static_cast<double>(bins);
      if (bed_carries(target, edge, points, heights)) return edge;
    }
    return range;
  }
  void add(const Histogram& other) {
    for (std::size_t bin = 0; bin < bins; ++bin) {
      count[bin] += other.count[bin];
      sum[bin] += other.sum[bin];
    }
  }
  // Adds the histograms of all processes.
  void unite(const Rows& rows) {
    for (std::vector<double>* const values : {&count, &sum}) {
      const std::vector<double> all = rows.joined(*values);
      std::fill(values->begin(), values->end(), 0.0);
      for (std::size_t i = 0; i < all.size(); ++i) (*values)[i % bins] += all[i];
    }
  }
  // To another range, in proportion.
  void scale(double to) {
    for (double& value : sum) value *= to / range;
    range = to;
  }
  double range;
  std::vector<double> count, sum;
};

}  // namespace

double bearing_height(double target, const StepSurface& surface) {
  const SurfacePoints& points = surface.points();
  const Rows& rows = points.rows();
  const double all = full_bed_height(target, static_cast<double>(surface.range().included), surface.moments().mean);
  double range = surface.range().width();
  const bool exact_sums = rows.shared();  // whole numbers: the bits do not depend on whose rows the points are in
  if (all >= range) return all;
  // Narrows the range until the bins resolve the answer.
  for (int round = 0;; ++round) {
    std::vector<Histogram> parts(points.threaded() ? histograms : 1, Histogram(exact_sums ? fine : range));
    const auto count = static_cast<std::int64_t>(parts.size()), tile_rows = surface.tiles().rows();
    roughcontact::for_each(points.team(), count, count > 1, [&](std::int64_t part, std::int64_t) {
      for (std::int64_t row = part * tile_rows / count; row < (part + 1) * tile_rows / count; ++row)
        surface.each_below(surface.range().limit_of(range), row, [&](std::int64_t point, std::int64_t, std::int64_t) {
          const double exact = surface.height(static_cast<std::size_t>(point));
          parts[static_cast<std::size_t>(part)].add(exact_sums ? std::floor(exact / range * fine) : exact);
        });
    });
    for (std::size_t part = 1; part < parts.size(); ++part) parts.front().add(parts[part]);
    if (exact_sums) {
      parts.front().unite(rows);
      parts.front().scale(range);
    }
    const double height = parts.front().reach(target);
    if (height > bed_resolution * range || round == 6) return height;
    range = 2 * height;
  }
}

}  // namespace rc
