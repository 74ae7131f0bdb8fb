#include "contact/step/contact_set_solve.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/stall.h"
#include "core/sums.h"

namespace rc {

namespace {

constexpr int patience = 20;     // steps without a smaller residual, after which round-off is all that is left
constexpr double smaller = 0.9;  // of the smallest residual before

double dot(std::span<const double> a, std::span<const double> b) {
  return sum_of(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

}  // namespace

ContactSetSolve::ContactSetSolve(Operator& op, std::span<const std::int64_t> set, rc_grid grid, double lowest,
                                 const rc_team& team, const Coefficients& coefficients)
    : op_(op),
      team_(team),
      set_(set.begin(), set.end()),
      active_(set.size(), 1),
      spread_(static_cast<std::size_t>(op.trial().n), 0.0),
      product_(spread_.size()) {
  std::vector<std::int64_t> points(set.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = op.trial().point(set[i]);
  grid.index = points.data();
  const TreeInputs on = tree_inputs(grid, static_cast<std::int64_t>(points.size()), coefficients);
  mean_ = on.mean;
  lowest_ = mean_ > 0 ? std::min(lowest, mean_ * static_cast<double>(grid.nx * grid.ny)) : lowest;
  trees_.emplace(on.cells, on.table);
  memory_.reset(new std::byte[trees_->bytes()]);
  trees_->place(memory_.get());
  trees_->set_up(active_.data(), 0, team_);
}

// q = A t
rc_status ContactSetSolve::multiply(const std::vector<double>& t, std::vector<double>& q) {
  for (std::size_t k = 0; k < t.size(); ++k) spread_[static_cast<std::size_t>(set_[k])] = t[k];
  if (const rc_status status = op_.apply(spread_.data(), product_.data()); status != RC_OK) return status;
  const double shift = mean_ > 0 ? mean_ * sum_of(t.size(), [&](std::size_t k) { return t[k]; }) : 0;
  for (std::size_t k = 0; k < t.size(); ++k) q[k] = product_[static_cast<std::size_t>(set_[k])] + shift;
  return RC_OK;
}

// From x = 0 every iterate has the least energy of all combinations of the directions so far, so b'x = b'A^-1 b - |e|^2 in the
// norm of the energy, e the error of x; and |e|^2 = r'A^-1 r <= r'r / lowest. What the residual r = b - A x is off by
// orthogonality lost to rounding, b'x + r'x makes good to first order.
rc_status ContactSetSolve::operator()(std::span<const double> b, const Enough& enough, std::span<double> x, double& form) {
  const std::size_t n = set_.size();
  std::vector<double> r(b.begin(), b.end()), t(n, 0.0), q(n), z(n);
  std::fill(x.begin(), x.end(), 0.0);
  Stall stalled(smaller * smaller, patience);
  double curvature = 0;
  for (;;) {
    const double rr = dot(r, r);
    form = dot(b, x) + dot(r, x);
    if (rr == 0 || enough(form, rr / lowest_)) return RC_OK;
    if (stalled(rr)) return RC_STOP_STALLED;
    // beta from the product, not from norms: the trees work in single precision, so each step is made conjugate to the last only.
    const double zq = trees_->apply(r.data(), active_.data(), z.data(), curvature > 0 ? q.data() : nullptr, team_);
    const double beta = curvature > 0 ? -zq / curvature : 0;
    for (std::size_t i = 0; i < n; ++i) t[i] = z[i] + beta * t[i];
    if (const rc_status status = multiply(t, q); status != RC_OK) return status;
    curvature = dot(t, q);
    if (!(curvature > 0))
      fail(RC_ERR_NUMERIC, "the operator is not positive definite: t'Ht = ", curvature, " on a set of ", n, " points");
    const double length = dot(r, t) / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += length * t[i];
      r[i] -= length * q[i];
    }
  }
}

}  // namespace rc
