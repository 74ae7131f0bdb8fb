// Non-negative least squares: Bemporad & Paggi (2015), Algorithm 3, with all infeasible points exchanged at once (block principal
// pivoting: Kostreva 1978; Judice & Pires 1994) and single least-index pivots (Murty 1974) when the blocks stop making progress.
// Finite and exact: the answer solves H_CC p_C = u_C on the final contact set C.
#include <algorithm>
#include <cmath>

#include "solvers/gradient_projection.h"
#include "solvers/solver.h"

namespace rc {

namespace {

constexpr int block_attempts = 10;           // block exchanges without a smaller number of infeasible points before single pivots
constexpr std::int64_t start_directly = 64;  // up to so many points the first set is {u > 0}; beyond, gradient steps find it
constexpr int gradient_steps = 30;

class Pivoting {
 public:
  Pivoting(const Problem& problem, Vector& p) : problem_(problem), n_(p.size()), p_(p), w_(n_), in_contact_(n_) {
    // Round-off of an exact solve, or a twentieth of what is asked.
    tolerance_ = std::clamp(0.05 * problem.tol(), 2e-14, 1e-9);
  }

  rc_status run() {
    first_set();
    std::size_t fewest = n_ + 1;
    int attempts = block_attempts;
    for (std::int64_t solves = 1;; ++solves) {
      if (const rc_status status = solve_on_contact_set(); status != RC_OK) return status;
      const std::size_t infeasible = find_infeasible();
      problem_.poll(solves, worst_);
      if (infeasible == 0) break;
      if (infeasible < fewest) {
        fewest = infeasible;
        attempts = block_attempts;
      } else {
        --attempts;
      }
      exchange(attempts > 0);
    }
    for (double& value : p_) value = std::max(value, 0.0);
    return RC_OK;
  }

 private:
  void first_set() {
    const double* u = problem_.u();
    const bool cold = std::none_of(p_.begin(), p_.end(), [](double value) { return value > 0; });
    if (cold && problem_.size() > start_directly) gradient_projection(problem_, p_, gradient_steps);
    for (std::size_t i = 0; i < n_; ++i) in_contact_[i] = cold && problem_.size() <= start_directly ? u[i] > 0 : p_[i] > 0;
  }

  rc_status solve_on_contact_set() {
    const double* u = problem_.u();
    while (true) {
      contact_.clear();
      for (std::size_t i = 0; i < n_; ++i)
        if (in_contact_[i]) contact_.push_back(static_cast<std::int64_t>(i));
      right_.clear();
      for (const std::int64_t i : contact_) right_.push_back(u[i]);
      solution_.resize(contact_.size());
      const rc_status status = problem_.try_subset(contact_, right_, solution_);
      if (status == RC_OK) break;
      // The mean of a periodic operator is its null space: full contact has no solution in displacement control, so the point
      // with the largest gap must stay out. Where it keeps coming back, the operator is indefinite.
      const bool singular = status == RC_ERR_NUMERIC || status == RC_STOP_STALLED;
      if (!singular || contact_.size() != n_ || n_ < 2 || ++full_sets_ > block_attempts) return status;
      in_contact_[static_cast<std::size_t>(std::min_element(u, u + n_) - u)] = false;
    }
    std::fill(p_.begin(), p_.end(), 0.0);
    for (std::size_t k = 0; k < contact_.size(); ++k) p_[static_cast<std::size_t>(contact_[k])] = solution_[k];
    problem_.apply(p_, w_);
    for (std::size_t i = 0; i < n_; ++i) w_[i] -= u[i];
    return RC_OK;
  }

  bool is_infeasible(std::size_t i) const { return in_contact_[i] ? p_[i] < -tolerance_ * largest_ : w_[i] < -tolerance_; }

  std::size_t find_infeasible() {
    largest_ = 0;
    for (const double value : p_) largest_ = std::max(largest_, value);
    std::size_t count = 0;
    worst_ = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!is_infeasible(i)) continue;
      ++count;
      worst_ = std::max(worst_, in_contact_[i] ? -p_[i] / (largest_ > 0 ? largest_ : 1) : -w_[i]);
    }
    return count;
  }

  void exchange(bool all) {
    for (std::size_t i = n_; i-- > 0;) {
      if (!is_infeasible(i)) continue;
      in_contact_[i] = !in_contact_[i];
      if (!all) return;
    }
  }

  const Problem& problem_;
  const std::size_t n_;
  Vector& p_;
  Vector w_;  // H p - u
  std::vector<char> in_contact_;
  Positions contact_;
  Vector right_, solution_;
  double tolerance_ = 0, largest_ = 0, worst_ = 0;
  int full_sets_ = 0;  // of all points, which could not be solved
};

}  // namespace

const Options nnls_options{};

rc_status nnls(const Problem& problem, Vector& p, double&) { return Pivoting(problem, p).run(); }

}  // namespace rc
