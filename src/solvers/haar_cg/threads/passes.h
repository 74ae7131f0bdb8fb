// The passes over all unknowns between two products. Each is one fused loop, with partial sums in a fixed order.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "solvers/haar_cg/threads/pass_loops.h"

namespace rc {

// The compenetration u: the problem's, or computed from the gap where the problem has none.
struct Compenetration {
  const double* u;
  const rc_grid* grid;
  double length;

  // `count` values from `begin` on; `room` holds them if they are computed.
  const double* values(std::int64_t begin, std::int64_t count, double* room) const;
};

// The vectors of an iteration: w = H p - u - datum, a direction t with its product q, and the contact set. w, t and q are in
// single or double precision. The spare memory holds two vectors of Real, or one of double, or one of Real and after it the
// `trees` bytes of the trees.
template <class Real> struct HaarState {
  std::int64_t n;
  Compenetration u;
  double* p;
  Real *w, *t, *q;
  std::uint8_t* active;
  std::byte* spare;
  std::unique_ptr<std::byte[]> memory;

  // Every unknown is in the contact set; t = 0.
  HaarState(std::int64_t size, const Compenetration& compenetration, double* pressure, std::size_t trees, const rc_team& team);

  Real* first_spare() { return reinterpret_cast<Real*>(spare); }
  Real* second_spare() { return first_spare() + n; }
  double* double_spare() { return reinterpret_cast<double*>(spare); }
  std::byte* tree_spare() { return reinterpret_cast<std::byte*>(second_spare()); }
};

// p = max(p, 0).
template <class Real> HaarStart begin(HaarState<Real>& s, const rc_team& team);
// p *= factor
template <class Real> void multiply(HaarState<Real>& s, double factor, const rc_team& team);
// t = z + beta t on the contact set, 0 elsewhere. Returns (w, t).
template <class Real> double turn(HaarState<Real>& s, const Real* z, Real beta, const rc_team& team);
// p -= length t, w -= length q. With `cut`: p = max(p, 0), and cut is what that added to p; returns whether it added any.
template <class Real> bool advance(HaarState<Real>& s, double length, Real* cut, const rc_team& team);
// w += change, and shift is not used; without a change: w -= shift.
template <class Real> HaarMeasure add_and_measure(HaarState<Real>& s, const Real* change, double shift, const rc_team& team);
// w = product - u - shift; without a product: w = -u - shift, for p = 0.
template <class Real>
HaarMeasure replace_and_measure(HaarState<Real>& s, const double* product, double shift, const rc_team& team);
// The contact set becomes the unknowns with p > 0 or w < -threshold. Returns whether it changed.
template <class Real> bool choose_set(HaarState<Real>& s, double threshold, const rc_team& team);

// (a, b), where a is 0 off the contact set
template <class Real> double inner(const HaarState<Real>& s, const Real* a, const Real* b, const rc_team& team);
template <class Value> double total(std::int64_t n, const Value* x, const rc_team& team);
template <class Value> void raise(std::int64_t n, double by, Value* x, const rc_team& team);
bool any_positive(std::int64_t n, const double* x, const rc_team& team);

}  // namespace rc
