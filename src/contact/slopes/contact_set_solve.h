// A x = b on the contact set C of a half-space, A = H[C,C] + mean() 11', for operators that multiply but cannot factor: conjugate
// gradients with the trees of haar-cg. Processes that share the grid by rows each have the points of their rows, and make three
// sums together an iteration.
#pragma once

#include <roughcontact/plugin.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "core/rows.h"
#include "operator/operator.h"
#include "trees/tree_inputs.h"
#include "trees/tree_pair.h"

namespace rc {

struct ConjugateGradientsEnd;

// Allowance for the rounding of products in double precision, as a share of |b|: a solve adds it to its residual before a bound
// of the stiffness is proven.
inline constexpr double product_rounding = 1e-12;

// Bounds on a solution x.
struct ContactSetBound {
  double residual = 0;  // |b - A x| is at most that
  double form = 0;      // b'A^-1 b
  double error = 0;     // of the form, at most: that of x in the norm of the energy, squared, and round-off

  // Whether form / (1 - mean form) is known to a share of `tol`. NaN: never.
  bool settles(double tol, double mean) const { return error <= tol * form * (1 - mean * (form + error)); }
};

class ContactSetSolve {
 public:
  // set: ascending positions in the operator's trial set. grid: the operator's, without an index. lowest: a bound from below of
  // the eigenvalues of H, > 0; where it is periodic, of those of all waves but the mean. By rows the operator has
  // all points of this process. `op` and `team` must outlive it.
  ContactSetSolve(Operator& op, std::span<const std::int64_t> set, const rc_grid& grid, double lowest, const rc_team& team,
                  const Coefficients& coefficients, const Rows& rows = {});

  // 0 unless the grid is periodic: a periodic operator may lack a mean, and hardly resists one where nearly all points touch.
  double mean() const { return mean_; }
  // No eigenvalue of A is smaller.
  double lowest() const { return lowest_; }

  // For as many right-hand sides as there are bounds, one after the other in b: until |b - A x| <= tol |b|. x: starts in, zeros
  // where none is known; answers out. RC_STOP_STALLED if round-off may keep a residual larger, or a status with which a
  // product ended. Throws if H is not positive definite (NUMERIC).
  rc_status operator()(std::span<const double> b, double tol, std::span<double> x, std::span<ContactSetBound> bounds);
  // Until form / (1 - mean form) is known to tol: the form is exact to twice the digits of x. x: a multiple of it is the start.
  rc_status form(std::span<const double> b, double tol, double mean, std::span<double> x, ContactSetBound& bound);

 private:
  // Two trees over every cell of the grid, or over the points of the set alone.
  struct Trees {
    HaarTreePair pair;
    std::vector<std::size_t> place;  // of each point of the set
    std::vector<std::uint8_t> active;
    std::vector<float> g, p;  // what they are given, and what they make of it
    std::size_t before = 0;   // values before the first, which belong to processes before this one
    std::unique_ptr<std::byte[]> memory;
  };
  template <class Real> struct Vectors {
    std::vector<Real> t, q;  // on the trial set

    void resize(const TrialSet& trial) {
      t.resize(static_cast<std::size_t>(trial.n));
      q.resize(t.size());
    }
  };

  Trees trees_at(const TreeInputs& inputs, std::int64_t x, std::int64_t y) const;
  // The sums of several terms over the set, piece of rows by piece.
  template <class... Terms> std::array<double, sizeof...(Terms)> sums(const Terms&... terms) const;
  double dot(std::span<const double> a, std::span<const double> b) const;
  rc_status solve(std::span<const double> b, double tol, std::span<double> x, ContactSetBound& bound);
  rc_status rough_start(std::span<const double> b, std::span<double> x, std::span<double> r);
  template <class Enough>
  ConjugateGradientsEnd descend(std::span<double> x, std::vector<double>& r, std::vector<double>& z, double size,
                                const bool& single, const Enough& enough);
  double largest_of(std::span<const double> x) const;
  template <class Real> rc_status multiply(std::span<const double> t, std::span<double> q);
  void precondition(std::span<const double> r, double unit, std::span<double> z);

  Operator& op_;
  const rc_team& team_;
  const Rows rows_;
  std::vector<std::int64_t> set_;
  std::vector<std::size_t> pieces_;  // where in the set each piece of rows begins, and the last ends; alone: one
  double mean_ = 0, lowest_ = 0;     // lowest_: bound of the eigenvalues of A
  std::vector<Trees> trees_;
  std::tuple<Vectors<float>, Vectors<double>> vectors_;
};

}  // namespace rc
