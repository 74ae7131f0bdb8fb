#include "common/influence.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "common/coefficients.h"

namespace rc_common {

namespace {

// H(i, j) depends on |xi - xj| and |yi - yj| only: one table of offsets holds all of it.
class HalfSpace final : public Influence {
 public:
  HalfSpace(const rc_host* host, const rc_operator_spec& spec, const roughcontact::Component& component)
      : system_(spec.system), table_(host, spec, component) {}

  void prepare(std::int64_t mx, std::int64_t my) override { table_.cover(mx, my); }

  // The table has zero mode 0. Adding zero_mode / n to every entry gives the constant vector the eigenvalue zero_mode.
  void set_zero_mode(double zero_mode) override {
    const double points = static_cast<double>(system_->nx) * static_cast<double>(system_->ny);
    shift_ = system_->boundary == RC_BOUNDARY_PERIODIC ? zero_mode / points : 0.0;
  }

  void column(std::span<const Point> rows, Point column, double* out) const override {
    for (const Point& row : rows) *out++ = shift_ + table_row(row.y - column.y)[std::abs(row.x - column.x)];
  }

  // Runs are the outer loop: a run of y and the table's row for all loads of one grid row stay in cache.
  void multiply(std::span<const Point> points, const double* x, std::span<const Run> targets, double* y) const override {
    const double mean = shift_ * std::accumulate(x, x + points.size(), 0.0);
    for (const Run& run : targets) {
      double* const out = y + run.position;
      std::fill_n(out, run.count, mean);
      for (std::size_t j = 0; j < points.size(); ++j)
        if (x[j] != 0.0) add_load(x[j], points[j].x - run.first.x, table_row(run.first.y - points[j].y), run.count, out);
    }
  }

 private:
  const double* table_row(std::int64_t dy) const { return table_.row(std::abs(dy)); }

  // Adds the deflection of a load at x cells from the run's first point, in two contiguous parts, left of the load and from it
  // on, so that both are vector loops.
  static void add_load(double p, std::int64_t x, const double* __restrict h, std::int64_t count, double* __restrict out) {
    const std::int64_t left = std::clamp<std::int64_t>(x, 0, count);
    for (std::int64_t k = 0; k < left; ++k) out[k] += p * h[x - k];
    for (std::int64_t k = left; k < count; ++k) out[k] += p * h[k - x];
  }

  const rc_system* system_;
  double shift_ = 0.0;
  Coefficients table_;
};

// The caller's symmetric matrix. Columns are read as rows, which are contiguous.
class CallersMatrix final : public Influence {
 public:
  explicit CallersMatrix(const rc_system& system) : system_(system) {}

  void prepare(std::int64_t, std::int64_t) override {}
  void set_zero_mode(double) override {}

  void column(std::span<const Point> rows, Point column, double* out) const override {
    const double* h = matrix_row(column);
    for (const Point& row : rows) *out++ = h[number(row)];
  }

  void multiply(std::span<const Point> points, const double* x, std::span<const Run> targets, double* y) const override {
    for (const Run& run : targets) std::fill_n(y + run.position, run.count, 0.0);
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (x[j] == 0.0) continue;
      const double* h = matrix_row(points[j]);
      for (const Run& run : targets) add_scaled(x[j], h + number(run.first), run.count, y + run.position);
    }
  }

 private:
  std::int64_t number(Point point) const { return point.y * system_.nx + point.x; }
  const double* matrix_row(Point point) const { return system_.dense + number(point) * system_.dense_ld; }

  static void add_scaled(double p, const double* __restrict h, std::int64_t n, double* __restrict y) {
    for (std::int64_t i = 0; i < n; ++i) y[i] += p * h[i];
  }

  const rc_system& system_;
};

}  // namespace

ColumnSource Influence::between(std::span<const Point> points) const {
  return [this, points](std::int64_t first_row, std::int64_t rows, std::int64_t number, double* out) {
    column(points.subspan(static_cast<std::size_t>(first_row), static_cast<std::size_t>(rows)),
           points[static_cast<std::size_t>(number)], out);
  };
}

std::vector<Run> runs_of(std::span<const Point> points) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point point = points[i];
    if (!runs.empty() && runs.back().first.y == point.y && runs.back().first.x + runs.back().count == point.x)
      ++runs.back().count;
    else
      runs.push_back({point, 1, static_cast<std::int64_t>(i)});
  }
  return runs;
}

std::unique_ptr<Influence> make_influence(const rc_host* host, const rc_operator_spec& spec,
                                          const roughcontact::Component& component) {
  switch (spec.system->op) {
    case RC_OPERATOR_HALFSPACE:
      return std::make_unique<HalfSpace>(host, spec, component);
    case RC_OPERATOR_DENSE:
      return std::make_unique<CallersMatrix>(*spec.system);
    default:
      roughcontact::fail(component, RC_ERR_INCOMPATIBLE, "the operator has no entries; only half-space grids and matrices do");
  }
}

}  // namespace rc_common
