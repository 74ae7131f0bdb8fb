#include "contact/slopes/subset_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/operators.h"
#include "contact/spectrum.h"
#include "core/error.h"
#include "core/sums.h"

namespace rc {

namespace {

// A bound from below of the eigenvalues of H[S,S] + zero_mode/n 11', m points in S. Where H is periodic, x'Hx >= wave |x -
// mean|^2, and |x - mean|^2 >= (1 - m/n) |x|^2 because x is 0 at n - m points.
double lowest_eigenvalue(const GridProblem& problem, double zero_mode, std::size_t m) {
  const System& system = problem.system;
  if (!system.halfspace()) return problem.facts.spectrum ? problem.facts.spectrum->lowest : 0;
  if (!system.periodic()) return system.bounds.lambda_min;
  const double wave = system.bounds.lambda_wave;
  return std::max(wave * (1 - static_cast<double>(m) / static_cast<double>(system.points())), std::min(wave, zero_mode));
}

}  // namespace

SubsetSolve::SubsetSolve(const GridProblem& problem, Operator& op, std::span<const std::int64_t> set)
    : op_(op), set_(set.begin(), set.end()) {
  const System& system = problem.system;
  mean_ = op.trial().zero_mode / static_cast<double>(system.points());
  const double lowest = system.periodic() ? system.bounds.lambda_wave : system.bounds.lambda_min;
  if (!system.halfspace() || op.has_subset() || !(lowest > 0)) {
    if (problem.rows().shared())
      fail(RC_ERR_INCOMPATIBLE, "option ", RC_OPT_STIFFNESS, " = ", problem.options.integer(RC_OPT_STIFFNESS),
           ": by rows it needs a kernel with a lowest eigenvalue, which \"", system.kernel.name, "\" does not promise");
    lowest_ = lowest_eigenvalue(problem, op.trial().zero_mode, set.size());
    return;
  }
  preconditioned_.emplace(
      op, set, grid_of(problem), lowest, problem.team(),
      [&problem](std::int64_t mx, std::int64_t my, auto& out) {
        out.resize(static_cast<std::size_t>(mx * my));
        raise_if_failed(problem.operators().coefficients(mx, my, out.data()), "the solve on the contact set");
      },
      problem.rows());
  mean_ += preconditioned_->mean();
  lowest_ = preconditioned_->lowest();
}

rc_status SubsetSolve::operator()(std::span<const double> b, double tol, std::span<double> x, ContactSetBound& bound) {
  rc_status status = RC_OK;
  if (preconditioned_) {
    status = (*preconditioned_)(b, tol, x, {&bound, 1});
  } else {
    constexpr double relative_residual = 1e-12;  // of conjugate gradients without a preconditioner
    status = op_.subset(set_, b.data(), x.data(), relative_residual);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    bound = {unknown, sum_in_order(b.size(), [&](std::size_t i) { return b[i] * x[i]; }), unknown};
  }
  op_.check(status, "the solve on the contact set");
  return status;
}

rc_status SubsetSolve::form(std::span<const double> b, double tol, std::span<double> x, ContactSetBound& bound) {
  if (!preconditioned_) {
    std::fill(x.begin(), x.end(), 0.0);
    return (*this)(b, tol, x, bound);
  }
  const rc_status status = preconditioned_->form(b, tol, mean_, x, bound);
  op_.check(status, "the solve on the contact set");
  return status;
}

rc_status SubsetSolve::prove(std::span<const double> b, std::span<const double> x, ContactSetBound& bound) {
  if (preconditioned_ || !(lowest_ > 0)) return RC_OK;
  std::vector<double> spread(static_cast<std::size_t>(op_.trial().n)), product(spread.size());
  for (std::size_t k = 0; k < set_.size(); ++k) spread[static_cast<std::size_t>(set_[k])] = x[k];
  const rc_status status = op_.apply(spread.data(), product.data());
  op_.check(status, "the residual of a solve on the contact set");
  if (status != RC_OK) return status;
  const auto sum = [&](const auto& term) { return sum_of(set_.size(), term); };
  const auto left = [&](std::size_t k) { return b[k] - product[static_cast<std::size_t>(set_[k])]; };
  const double size = std::sqrt(sum([&](std::size_t k) { return b[k] * b[k]; }));
  bound.residual = std::sqrt(sum([&](std::size_t k) { return left(k) * left(k); })) + product_rounding * size;
  bound.form = sum([&](std::size_t k) { return b[k] * x[k]; }) + sum([&](std::size_t k) { return left(k) * x[k]; });
  bound.error = bound.residual * bound.residual / lowest_ +
                product_rounding * size * std::sqrt(sum([&](std::size_t k) { return x[k] * x[k]; }));
  return RC_OK;
}

std::optional<std::vector<std::int64_t>> positions_in(const TrialSet& trial, std::span<const std::int64_t> points) {
  if (trial.index.empty()) return std::vector<std::int64_t>(points.begin(), points.end());
  std::vector<std::int64_t> positions;
  std::size_t k = 0;
  for (const std::int64_t point : points) {
    while (k < trial.index.size() && trial.index[k] < point) ++k;
    if (k == trial.index.size() || trial.index[k] != point) return std::nullopt;
    positions.push_back(static_cast<std::int64_t>(k));
  }
  return positions;
}

}  // namespace rc
