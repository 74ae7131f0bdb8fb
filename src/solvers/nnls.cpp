// Non-negative least squares: Bemporad & Paggi (2015), Algorithm 3. Finite and exact: the answer solves H_CC p_C = u_C on the
// final contact set C. With a cap of the pressure (bounded-variable least squares: Stark & Parker 1995) the points of C carry
// less than the cap, others the cap itself, and their deflection is taken from u.
//
// nnls.pivoting = block exchanges all infeasible points at once (block principal pivoting: Kostreva 1978; Judice & Pires 1994).
// It needs a handful of solves. It may fail to make progress; then the other method continues from its pressures.
// nnls.pivoting = single adds the point of the largest overlap (Lawson & Hanson 1974), as published. Each solve lowers the
// energy, so no set comes twice; but every point of the contact set costs a solve. It takes points off the cap in the same way.
// Changes to the printed algorithm: the tolerances are relative; all points that reach zero leave at once and are set to zero;
// and a point that was refused, because it would pull, is not tried again before another one has been accepted.
//
// Iterations are counted in solves, each on one contact set.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/limits.h"
#include "solvers/gradient_projection.h"
#include "solvers/largest_eigenvalue.h"
#include "solvers/residual.h"
#include "solvers/solver.h"

namespace rc::nnls {

namespace {

constexpr int block_attempts = 10;           // exchanges that do not lower the number of infeasible points
constexpr std::int64_t start_directly = 64;  // most points for which the first set is {u > 0}; with more, gradient steps find it
constexpr std::int64_t gradient_steps = 30, warm_gradient_steps = 25;
constexpr double round_off = 1e-15;  // relative to the largest pressure: below, a pressure has vanished

enum class State : char { open, free, capped };

class Pivoting {
 public:
  Pivoting(const Problem& problem, Vector& p) : problem_(problem), n_(p.size()), cap_(problem.cap()), p_(p), w_(n_), state_(n_) {
    // A twentieth of what is asked, but no less than the round-off of an exact solve.
    tolerance_ = std::clamp(0.05 * problem.tol(), 2e-14, 1e-9);
    clip(problem, p_);
  }

  rc_status by_blocks() {
    first_set();
    std::size_t fewest = n_ + 1;
    for (int attempts = block_attempts; attempts > 0;) {
      if (const rc_status status = solve_on_contact_set(); status != RC_OK) return status;
      for (std::size_t i = 0; i < n_; ++i) p_[i] = state_[i] == State::capped ? cap_ : 0;
      for (std::size_t k = 0; k < contact_.size(); ++k) p_[static_cast<std::size_t>(contact_[k])] = solution_[k];
      find_gap();
      const std::size_t infeasible = find_infeasible();
      problem_.poll(++solves_, worst_);
      if (infeasible == 0) return RC_OK;
      --attempts;
      if (infeasible < fewest) {
        fewest = infeasible;
        attempts = block_attempts;
      }
      exchange();
    }
    clip(problem_, p_);
    return one_by_one();
  }

  rc_status one_by_one() {
    std::size_t entered = n_;
    for (std::size_t i = 0; i < n_; ++i) state_[i] = state_of(p_[i]);
    std::vector<char> refused(n_, 0);
    while (true) {
      if (entered < n_ || std::any_of(p_.begin(), p_.end(), [](double value) { return value > 0; })) {
        bool accepted = true;
        if (const rc_status status = settle(entered, accepted); status != RC_OK) return status;
        if (accepted) std::fill(refused.begin(), refused.end(), char{0});
        if (!accepted) refused[entered] = 1;
      }
      find_gap();
      entered = n_;
      bool any_refused = false;
      for (std::size_t i = 0; i < n_; ++i) {
        if (state_[i] == State::free || violation(i) <= tolerance_) continue;
        if (refused[i]) {
          any_refused = true;
        } else if (entered == n_ || violation(i) > violation(entered)) {
          entered = i;
        }
      }
      if (entered == n_) return any_refused ? RC_STOP_STALLED : RC_OK;
      worst_ = violation(entered);
      state_[entered] = State::free;
    }
  }

 private:
  void first_set() {
    const double* u = problem_.u();
    const bool cold = std::none_of(p_.begin(), p_.end(), [](double value) { return value > 0; });
    // If a solve costs many products, gradient steps save time even from a warm start.
    if ((cold || !problem_.factors()) && problem_.size() > start_directly) {
      gradient_projection::Settings settings;
      settings.lipschitz = largest_eigenvalue(problem_);
      settings.steps = cold ? gradient_steps : warm_gradient_steps;
      settings.polls = false;
      double unused = 0;
      if (settings.lipschitz > 0) gradient_projection::descend(problem_, p_, unused, settings);
    }
    const bool directly = cold && problem_.size() <= start_directly;
    for (std::size_t i = 0; i < n_; ++i) state_[i] = !directly ? state_of(p_[i]) : u[i] > 0 ? State::free : State::open;
  }

  State state_of(double p) const { return p >= cap_ ? State::capped : p > 0 ? State::free : State::open; }
  // The overlap of a point at zero, the gap of a point at the cap.
  double violation(std::size_t i) const { return state_[i] == State::capped ? w_[i] : -w_[i]; }

  // Moves p towards the solution on the contact set. Points whose pressure vanishes or meets the cap on the way leave the set,
  // and the rest is solved again, until no point is beyond its bounds. `entered` is the point just added, or n.
  rc_status settle(std::size_t entered, bool& accepted) {
    for (bool first = true;; first = false) {
      if (const rc_status status = solve_on_contact_set(); status != RC_OK) return status;
      problem_.poll(++solves_, worst_);
      double length = 1;
      for (std::size_t k = 0; k < contact_.size(); ++k) {
        const auto i = static_cast<std::size_t>(contact_[k]);
        if (is_between(solution_[k])) continue;
        const double to_go = solution_[k] > 0 ? cap_ - p_[i] : p_[i], change = std::abs(solution_[k] - p_[i]);
        if (first && i == entered &&
            to_go == 0) {  // round-off: by its gap it must leave its bound, by the solution it goes beyond
          state_[i] = state_of(p_[i]);
          accepted = false;
          return RC_OK;
        }
        length = std::min(length, change > 0 ? to_go / change : 0.0);
      }
      bool left = false;
      double largest = 0;
      for (const double value : solution_) largest = std::max(largest, value);
      for (std::size_t k = 0; k < contact_.size(); ++k) {
        const auto i = static_cast<std::size_t>(contact_[k]);
        p_[i] += length * (solution_[k] - p_[i]);
        if (length == 1 && is_between(solution_[k])) p_[i] = solution_[k];
        const bool up = solution_[k] > 0;
        if (is_between(solution_[k]) || (up ? cap_ - p_[i] > round_off * cap_ : p_[i] > round_off * largest)) continue;
        p_[i] = up ? cap_ : 0;
        state_[i] = up ? State::capped : State::open;
        left = true;
      }
      if (!left) return RC_OK;
    }
  }

  bool is_between(double p) const { return p > 0 && p < cap_; }

  // u less the deflection by the points at the cap.
  void find_right() {
    right_.clear();
    const double* u = problem_.u();
    const bool any = std::any_of(state_.begin(), state_.end(), [](State state) { return state == State::capped; });
    if (any && !contact_.empty()) {
      Vector at_cap(n_, 0.0);
      for (std::size_t i = 0; i < n_; ++i)
        if (state_[i] == State::capped) at_cap[i] = cap_;
      problem_.apply(at_cap, w_);
    }
    for (const std::int64_t i : contact_) right_.push_back(any ? u[i] - w_[static_cast<std::size_t>(i)] : u[i]);
  }

  rc_status solve_on_contact_set() {
    const double* u = problem_.u();
    while (true) {
      contact_.clear();
      for (std::size_t i = 0; i < n_; ++i)
        if (state_[i] == State::free) contact_.push_back(static_cast<std::int64_t>(i));
      find_right();
      solution_.clear();
      for (const std::int64_t i : contact_)
        solution_.push_back(p_[static_cast<std::size_t>(i)]);  // the start of an iterative solve
      const rc_status status = contact_.empty() && cap_ < infinite ? RC_OK : problem_.try_subset(contact_, right_, solution_);
      if (status == RC_OK) return RC_OK;
      // A periodic operator gives 0 for uniform pressure, so full contact has no solution in approach control: the point with
      // the largest gap must stay out or, above the mean plane, the one with the largest overlap at the cap. Where it keeps
      // coming back, the operator is indefinite.
      const bool singular = status == RC_ERR_NUMERIC || status == RC_STOP_STALLED;
      if (!singular || contact_.size() != n_ || n_ < 2 || ++full_sets_ > block_attempts) return status;
      const bool above = cap_ < infinite && std::accumulate(u, u + n_, 0.0) > 0;
      const auto farthest = static_cast<std::size_t>((above ? std::max_element(u, u + n_) : std::min_element(u, u + n_)) - u);
      state_[farthest] = above ? State::capped : State::open;
      p_[farthest] = above ? cap_ : 0;
    }
  }

  void find_gap() {
    problem_.apply(p_, w_);
    for (std::size_t i = 0; i < n_; ++i) w_[i] -= problem_.u()[i];
  }

  // How far a free pressure is beyond its bounds.
  double excess(std::size_t i) const { return std::max(-p_[i], p_[i] - cap_); }
  bool is_infeasible(std::size_t i) const {
    return state_[i] == State::free ? excess(i) > tolerance_ * largest_ : violation(i) > tolerance_;
  }

  std::size_t find_infeasible() {
    largest_ = 0;
    for (const double value : p_) largest_ = std::max(largest_, value);
    std::size_t count = 0;
    worst_ = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!is_infeasible(i)) continue;
      ++count;
      worst_ = std::max(worst_, state_[i] == State::free ? excess(i) / (largest_ > 0 ? largest_ : 1) : violation(i));
    }
    return count;
  }

  void exchange() {
    for (std::size_t i = 0; i < n_; ++i)
      if (is_infeasible(i)) state_[i] = state_[i] != State::free ? State::free : p_[i] > 0 ? State::capped : State::open;
  }

  const Problem& problem_;
  const std::size_t n_;
  const double cap_;  // of the pressures
  Vector& p_;
  Vector w_;  // H p - u
  std::vector<State> state_;
  Positions contact_;  // the free points
  Vector right_, solution_;
  double tolerance_ = 0, largest_ = 0, worst_ = 1;
  std::int64_t solves_ = 0;
  int full_sets_ = 0;  // failed solves with all points in contact
};

constexpr rc_component pivoting =
    text_option("nnls.pivoting", "block", "block|single",
                "block: all infeasible points at once, a handful of solves; single: one point a solve, as published");
const rc_component* const specs[] = {&pivoting};

}  // namespace

const Options options = listed(specs);

rc_status solve(const Problem& problem, Vector& p, double&) {
  Pivoting pivoting_method(problem, p);
  return problem.option_text("nnls.pivoting") == "single" ? pivoting_method.one_by_one() : pivoting_method.by_blocks();
}

// About six contact sets, of about a third of the points.
rc_status score(const rc_facts* facts, rc_estimate* estimate) {
  if (facts->partial) return facts->host->fail(facts->host, RC_ERR_INCOMPATIBLE, "its answer comes with the last contact set");
  const double one = (facts->caps & RC_CAP_SUBSET) != 0 ? facts->backend->factor : iterating(*facts, 7);
  estimate->seconds = with_the_rest(*facts, 6 * one);
  estimate->bytes = 5 * sizeof(double) * static_cast<double>(facts->n);
  return RC_OK;
}

}  // namespace rc::nnls
