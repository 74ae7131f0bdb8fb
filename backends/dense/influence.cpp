#include "influence.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "failure.h"

namespace rc_dense {

namespace {

// H(i, j) depends on |xi - xj| and |yi - yj| only: one table of offsets holds all of it.
class HalfSpace final : public Influence {
 public:
  HalfSpace(const rc_host* host, const rc_operator_spec& spec) : host_(host), system_(spec.system), kernel_(spec.kernel) {}

  void prepare(std::int64_t mx, std::int64_t my) override {
    if (mx <= mx_ && my <= my_) return;
    mx = std::max(mx, mx_);
    my = std::max(my, my_);
    mx_ = my_ = 0;
    table_.resize(static_cast<std::size_t>(mx) * static_cast<std::size_t>(my));
    const rc_status status = host_->coefficients(host_, system_, kernel_, mx, my, table_.data());
    if (status != RC_OK) throw Failure{status, {}};
    mx_ = mx;
    my_ = my;
  }

  // The table is that of zero mode 0. The matrix zero_mode / n * 1 1^T has eigenvalue zero_mode for the constant vector.
  void set_zero_mode(double zero_mode) override {
    const double points = static_cast<double>(system_->nx) * static_cast<double>(system_->ny);
    shift_ = system_->boundary == RC_BOUNDARY_PERIODIC ? zero_mode / points : 0.0;
  }

  void column(std::span<const Point> rows, Point column, double* out) const override {
    for (const Point& row : rows) *out++ = shift_ + table_row(row.y - column.y)[std::abs(row.x - column.x)];
  }

  // Rows of y are the outer loop: a row of y and the table's row for all loads of one grid row stay in cache.
  void field(std::span<const Point> points, const double* x, double* y) override {
    prepare(system_->nx, system_->ny);
    const double mean = shift_ * std::accumulate(x, x + points.size(), 0.0);
    for (std::int64_t iy = 0; iy < system_->ny; ++iy) {
      double* row = y + iy * system_->nx;
      std::fill_n(row, system_->nx, mean);
      for (std::size_t j = 0; j < points.size(); ++j)
        if (x[j] != 0.0) add_load(x[j], points[j].x, table_row(iy - points[j].y), row);
    }
  }

 private:
  const double* table_row(std::int64_t dy) const { return table_.data() + std::abs(dy) * mx_; }

  // Two contiguous halves, to the right of the load and to its left, so that both are vector loops.
  void add_load(double p, std::int64_t x, const double* __restrict h, double* __restrict row) const {
    const std::int64_t right = system_->nx - x;
    for (std::int64_t k = 0; k < right; ++k) row[x + k] += p * h[k];
    for (std::int64_t k = 0; k < x; ++k) row[k] += p * h[x - k];
  }

  const rc_host* host_;
  const rc_system* system_;
  const char* kernel_;
  double shift_ = 0.0;
  std::int64_t mx_ = 0, my_ = 0;
  std::vector<double> table_;
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

  void field(std::span<const Point> points, const double* x, double* y) override {
    const std::int64_t n = system_.nx * system_.ny;
    std::fill_n(y, n, 0.0);
    for (std::size_t j = 0; j < points.size(); ++j)
      if (x[j] != 0.0) add_scaled(x[j], matrix_row(points[j]), n, y);
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

std::unique_ptr<Influence> make_influence(const rc_host* host, const rc_operator_spec& spec) {
  switch (spec.system->op) {
    case RC_OPERATOR_HALFSPACE:
      return std::make_unique<HalfSpace>(host, spec);
    case RC_OPERATOR_DENSE:
      return std::make_unique<CallersMatrix>(*spec.system);
    default:
      fail(RC_ERR_INCOMPATIBLE, "the operator has no entries; only half-space grids and matrices do");
  }
}

}  // namespace rc_dense
