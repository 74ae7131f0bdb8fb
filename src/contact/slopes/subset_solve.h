// A x = b on a set of points S, A = H[S,S] + mean() 11', for every system: preconditioned where the operator multiplies without
// factors on a half-space, else by Operator::subset.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/problem.h"
#include "contact/slopes/contact_set_solve.h"
#include "operator/operator.h"

namespace rc {

class SubsetSolve {
 public:
  // set: ascending positions in the operator's trial set, at least one. problem and op must outlive it.
  SubsetSolve(const GridProblem& problem, Operator& op, std::span<const std::int64_t> set);

  // A zero mode of the trial set counts, and what ContactSetSolve adds.
  double mean() const { return mean_; }
  // No eigenvalue of A is smaller; 0 if no bound is known.
  double lowest() const { return lowest_; }
  // Whether `tol` decides how exact an answer is: else factors do, or a fixed residual.
  bool iterates() const { return preconditioned_.has_value(); }

  // Until |b - A x| <= tol |b|. x: a start in, the answer out. Throws what fails; RC_STOP_STALLED if round-off may keep a
  // larger residual.
  rc_status operator()(std::span<const double> b, double tol, std::span<double> x, ContactSetBound& bound);
  // bound.form: 2 b'x - x'Ax, close to s = b'A^-1 b. Until s / (1 - mean() s) is known to tol.
  rc_status form(std::span<const double> b, double tol, std::span<double> x, ContactSetBound& bound);
  // The bound of an answer that came without one: NaN if lowest() is 0. Where the solve does not iterate, one product.
  rc_status prove(std::span<const double> b, std::span<const double> x, ContactSetBound& bound);

 private:
  Operator& op_;
  std::vector<std::int64_t> set_;
  std::optional<ContactSetSolve> preconditioned_;
  double mean_ = 0, lowest_ = 0;
};

// Positions of ascending points in a trial set; nothing if one of them is not in it.
std::optional<std::vector<std::int64_t>> positions_in(const TrialSet& trial, std::span<const std::int64_t> points);

}  // namespace rc
