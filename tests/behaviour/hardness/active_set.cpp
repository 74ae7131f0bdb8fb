#include "active_set.h"

#include <algorithm>
#include <cmath>

namespace pairs {

namespace {

enum class At { zero, free, cap };

class ActiveSet {
 public:
  ActiveSet(const Field& matrix, const Field& u, double cap, const std::vector<bool>& skip)
      : matrix_(matrix), u_(u), cap_(cap), skip_(skip), n_(u.size()), p_(n_, 0.0), at_(n_, At::zero) {}

  Field solve() {
    const double least = 1e-13 * largest(u_);
    for (std::size_t rounds = 0; rounds < 50 * n_; ++rounds) {
      const Field w = gap();
      std::size_t worst = n_;
      double violation = least;
      for (std::size_t i = 0; i < n_; ++i) {
        if (skip_[i] || at_[i] == At::free) continue;
        const double by = at_[i] == At::zero ? -w[i] : w[i];
        if (by <= violation) continue;
        violation = by;
        worst = i;
      }
      if (worst == n_) return p_;
      at_[worst] = At::free;
      settle();
    }
    throw Failure("the active set does not settle");
  }

 private:
  Field gap() const {
    Field w = product(matrix_, p_);
    for (std::size_t i = 0; i < n_; ++i) w[i] -= u_[i];
    return w;
  }

  // Solves on the free points, and stops at the first bound on the way, until no bound is in the way.
  void settle() {
    while (true) {
      std::vector<std::size_t> free;
      for (std::size_t i = 0; i < n_; ++i)
        if (at_[i] == At::free) free.push_back(i);
      Field block, right;
      const Field w = gap();
      for (const std::size_t i : free) {
        right.push_back(-w[i]);
        for (const std::size_t j : free) block.push_back(matrix_[i * n_ + j]);
      }
      const Field change = solve_linear(block, right);
      double length = 1;
      std::size_t first = n_;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double room = change[k] < 0 ? p_[free[k]] : cap_ - p_[free[k]];
        if (std::abs(change[k]) * length <= room) continue;
        length = room / std::abs(change[k]);
        first = k;
      }
      for (std::size_t k = 0; k < free.size(); ++k) p_[free[k]] = std::clamp(p_[free[k]] + length * change[k], 0.0, cap_);
      if (first == n_) return;
      at_[free[first]] = change[first] < 0 ? At::zero : At::cap;
      p_[free[first]] = change[first] < 0 ? 0 : cap_;
    }
  }

  const Field& matrix_;
  const Field& u_;
  const double cap_;
  const std::vector<bool>& skip_;
  const std::size_t n_;
  Field p_;
  std::vector<At> at_;
};

}  // namespace

Field solve_in_box(const Field& matrix, const Field& u, double cap, const std::vector<bool>& skip) {
  return ActiveSet(matrix, u, cap, skip).solve();
}

Field pressures_at(const Problem& problem, const Field& matrix, const Field& gap, double approach) {
  Field u;
  std::vector<bool> skip;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    skip.push_back(!problem.included(i));
    u.push_back(skip.back() ? 0 : approach - gap[i]);
  }
  return solve_in_box(matrix, u, problem.system.hardness, skip);
}

}  // namespace pairs
