// The greedy method: Bemporad & Paggi (2015), Algorithm 1. It starts with all points in contact, solves, drops the points that
// pull (have negative pressure) and solves again, until none pulls. No point comes back.
//
// Changes to the printed algorithm: the loop ends when a solve leaves nothing to drop; the tolerances are relative; conjugate
// gradients update their residual instead of computing it anew; and the gap of the points that were dropped is checked.
//
// The method finds the solution for every surface if and only if H^-1 has no positive entry off its diagonal (Chandrasekaran
// 1970). That holds for the kernels love and disc with free boundaries. Elsewhere dropped points may overlap: the answer is then
// not certified, or with greedy.repair is corrected by nnls.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/conjugate_gradients.h"
#include "core/stall.h"
#include "core/sums.h"
#include "core/text.h"
#include "solvers/residual.h"
#include "solvers/solver.h"

namespace rc::greedy {

namespace {

constexpr int patience = 40;                    // iterations of a solve without a new smallest residual
constexpr double accuracy = 1e-3;               // of a solve, relative to tol
constexpr double attained = 1e-15;              // least residual that products in double precision can reach
constexpr std::int64_t most_entries_of = 4096;  // most points for which Gauss & Seidel's method stores the matrix
constexpr double round_off = 1e-12;

class Greedy {
 public:
  Greedy(const Problem& problem, Vector& p)
      : problem_(problem),
        u_(problem.u()),
        n_(p.size()),
        p_(p),
        hp_(n_),
        kept_(n_, 1),
        enough_(std::max(accuracy * problem.tol(), attained)),
        inner_(problem.option_text("greedy.inner")) {
    for (double& value : p_) value = std::max(value, 0.0);
  }

  rc_status run() {
    if (start_is_solution()) return RC_OK;
    if (inner_ == "gauss-seidel") store_matrix();
    leave_null_space();
    do {
      for (std::size_t i = 0; i < n_; ++i)
        if (!kept_[i]) p_[i] = 0;
      if (inner_ == "cholesky") {
        factor();
      } else if (inner_ == "gauss-seidel") {
        sweep();
      } else {
        iterate();
      }
    } while (drop());
    return judge();
  }

 private:
  // A start helps only if it is the solution: from any other, the method begins with all points in contact.
  bool start_is_solution() {
    if (std::none_of(p_.begin(), p_.end(), [](double value) { return value > 0; })) return false;
    problem_.apply(p_, hp_);
    return residual_of(problem_, p_, hp_).worst <= problem_.tol();
  }

  // A periodic H gives 0 for uniform pressure, so full contact has no solution in approach control. The point with the
  // largest gap is then left out.
  void leave_null_space() {
    if (problem_.positive() || n_ < 2) return;
    const auto farthest = static_cast<std::size_t>(std::min_element(u_, u_ + n_) - u_);
    Vector ones(n_, 1.0), one(n_, 0.0), of_ones(n_), of_one(n_);
    one[farthest] = 1;
    problem_.apply(ones, of_ones);
    problem_.apply(one, of_one);
    const auto size = [](const Vector& v) {
      return std::abs(*std::max_element(v.begin(), v.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    };
    if (size(of_ones) <= round_off * static_cast<double>(n_) * size(of_one)) kept_[farthest] = 0;
  }

  // Conjugate gradients on the points that are kept. The residuals of the others are set to 0, so directions are 0 there.
  void iterate() {
    Vector r(n_);
    problem_.apply(p_, hp_);
    for (std::size_t i = 0; i < n_; ++i) r[i] = kept_[i] ? u_[i] - hp_[i] : 0;
    Stall stalls(1, patience);
    const auto multiply = [&](const Vector& t, Vector& q) {
      problem_.apply(t, q);
      for (std::size_t i = 0; i < n_; ++i)
        if (!kept_[i]) q[i] = 0;
      return 0;
    };
    const ConjugateGradientsEnd end = conjugate_gradients(p_, r, no_unit, sum_of, multiply, [&](int, double) {
      double largest = 0;
      for (const double value : r) largest = std::max(largest, std::abs(value));
      problem_.poll(++iterations_, largest);
      return stalls(largest) || largest <= enough_;
    });
    if (std::isnan(end.curvature)) problem_.fail("greedy: the operator returned values that are not finite");
    if (!end.definite()) problem_.fail("greedy: the operator is not positive definite: t'Ht <= 0 along a search direction t");
  }

  void store_matrix() {
    if (problem_.size() > most_entries_of)
      problem_.fail(RC_ERR_INCOMPATIBLE, join("greedy: greedy.inner = gauss-seidel stores the matrix of all candidates, ", n_,
                                              " of at most ", most_entries_of, "; use cg or cholesky, or a smaller approach")
                                             .c_str());
    Vector unit(n_, 0.0), column(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      unit[i] = 1;
      problem_.apply(unit, column);
      unit[i] = 0;
      if (!(column[i] > 0)) problem_.fail("greedy: the operator is not positive definite: a diagonal entry is not positive");
      matrix_.insert(matrix_.end(), column.begin(), column.end());
    }
  }

  void sweep() {
    for (Stall stalls(1, patience);;) {
      double largest = 0;
      for (std::size_t i = 0; i < n_; ++i) {
        if (!kept_[i]) continue;
        const double* row = matrix_.data() + i * n_;
        const double r = u_[i] - sum_of(n_, [&](std::size_t j) { return row[j] * p_[j]; });
        p_[i] += r / row[i];
        largest = std::max(largest, std::abs(r));
      }
      problem_.poll(++iterations_, largest);
      if (largest <= enough_ || stalls(largest)) return;
    }
  }

  void factor() {
    if (!problem_.has_subset())
      problem_.fail(
          RC_ERR_INCOMPATIBLE,
          "greedy: greedy.inner = cholesky needs systems on subsets, which the backend cannot factor, and allow_fallback "
          "is 0; use greedy.inner = cg or a backend that factors");
    Positions kept;
    Vector right, solution;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!kept_[i]) continue;
      kept.push_back(static_cast<std::int64_t>(i));
      right.push_back(u_[i]);
      solution.push_back(p_[i]);
    }
    check(problem_.try_subset(kept, right, solution));
    for (std::size_t k = 0; k < kept.size(); ++k) p_[static_cast<std::size_t>(kept[k])] = solution[k];
    problem_.poll(++iterations_, std::max(0.0, -*std::min_element(solution.begin(), solution.end())));
  }

  // Drops the points that pull. True if the rest must be solved again.
  bool drop() {
    bool any = false, left = false;
    for (std::size_t i = 0; i < n_; ++i) {
      if (kept_[i] && p_[i] < 0) {
        kept_[i] = 0;
        p_[i] = 0;
        any = true;
      }
      left = left || kept_[i];
    }
    return any && left;
  }

  rc_status judge() {
    problem_.apply(p_, hp_);
    std::int64_t overlapping = 0;
    double deepest = 0, open = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double gap = hp_[i] - u_[i];
      if (kept_[i]) {
        open = std::max(open, std::abs(gap));
      } else if (gap < -problem_.tol()) {
        ++overlapping;
        deepest = std::max(deepest, -gap);
      }
    }
    if (overlapping == 0) return open <= problem_.tol() ? RC_OK : RC_STOP_STALLED;
    const bool repair = problem_.option_int("greedy.repair") != 0;
    char remark[160];
    std::snprintf(remark, sizeof remark, "greedy: %lld points overlap%s, worst w = %.2g of the largest penetration; %s",
                  static_cast<long long>(overlapping), repair ? "ped" : "", -deepest,
                  repair ? "nnls has repaired it" : "set greedy.repair or use nnls");
    problem_.note(remark);
    if (!repair) return RC_UNCERTIFIED;
    return problem_.by_nnls(p_.data());
  }

  const Problem& problem_;
  const double* const u_;
  const std::size_t n_;
  Vector& p_;
  Vector hp_;                // H p
  std::vector<char> kept_;   // not dropped so far
  const double enough_;      // residual to which a set is solved
  const std::string inner_;  // greedy.inner
  Vector matrix_;            // H, row by row, for Gauss & Seidel's method
  std::int64_t iterations_ = 0;
};

constexpr rc_component inner = text_option("greedy.inner", "cg", "cg|gauss-seidel|cholesky",
                                           "how each set is solved; gauss-seidel stores the matrix, of at most 4096 candidates");
constexpr rc_component repair =
    int_option("greedy.repair", "0", 0, 1, "1: if dropped points overlap, nnls continues from the contact set found");
const rc_component* const specs[] = {&inner, &repair};

}  // namespace

const Options options = listed(specs);

rc_status solve(const Problem& problem, Vector& p, double&) { return Greedy(problem, p).run(); }

}  // namespace rc::greedy
