// The passes over all unknowns between two products, each fused, in a fixed order of partial sums.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "solvers/haar_cg/threads/pass_loops.h"

namespace rc {

// u as the problem has it, or from the gap where it has none.
struct Compenetration {
  const double* u;
  const rc_grid* grid;
  double length;

  // `count` values from `begin` on; `room` holds them where they are made.
  const double* values(std::int64_t begin, std::int64_t count, double* room) const;
};

// The state of an iteration: w = H p - u - d, a direction with its product, and the contact set. Residuals and directions are
// in single or double precision. The spare memory holds two vectors of Real, or one of doubles, or one of Real and what `trees`
// bytes hold: these come after it.
template <class Real> struct HaarState {
  std::int64_t n;
  Compenetration u;
  double* p;
  Real *w, *t, *q;
  std::uint8_t* active;
  std::byte* spare;
  std::unique_ptr<std::byte[]> memory;

  // All in the contact set, no direction.
  HaarState(std::int64_t size, const Compenetration& compenetration, double* pressure, std::size_t trees, const rc_team& team);

  Real* first_spare() { return reinterpret_cast<Real*>(spare); }
  Real* second_spare() { return first_spare() + n; }
  double* double_spare() { return reinterpret_cast<double*>(spare); }
  std::byte* tree_spare() { return reinterpret_cast<std::byte*>(second_spare()); }
};

// Cuts negative pressures off.
template <class Real> HaarStart begin(HaarState<Real>& s, const rc_team& team);
// p *= factor
template <class Real> void multiply(HaarState<Real>& s, double factor, const rc_team& team);
// t = z + beta t on the contact set, 0 elsewhere. Returns (w, t).
template <class Real> double turn(HaarState<Real>& s, const Real* z, Real beta, const rc_team& team);
// p -= length t, w -= length q. With `cut` given, negative pressures are cut off into it: returns whether there were any.
template <class Real> bool advance(HaarState<Real>& s, double length, Real* cut, const rc_team& team);
// w += change - shift, where given.
template <class Real> HaarMeasure add_and_measure(HaarState<Real>& s, const Real* change, double shift, const rc_team& team);
// w = product - u - shift; without a product that of no pressure.
template <class Real>
HaarMeasure replace_and_measure(HaarState<Real>& s, const double* product, double shift, const rc_team& team);
// Points with pressure, and those that overlap by more than the threshold. Returns whether the set changed.
template <class Real> bool choose_set(HaarState<Real>& s, double threshold, const rc_team& team);

// (a, b), where a is 0 off the contact set
template <class Real> double inner(const HaarState<Real>& s, const Real* a, const Real* b, const rc_team& team);
template <class Value> double total(std::int64_t n, const Value* x, const rc_team& team);
template <class Value> void raise(std::int64_t n, double by, Value* x, const rc_team& team);
bool any_positive(std::int64_t n, const double* x, const rc_team& team);

}  // namespace rc
