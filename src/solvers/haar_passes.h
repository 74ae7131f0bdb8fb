// The passes over all unknowns between two products, each fused, in a fixed order of partial sums.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solvers/haar_loops.h"

namespace rc {

// The state of an iteration: w = H p - u - d, a direction with its product, and the contact set. Residuals and directions are
// in single or double precision.
template <class Real> struct HaarState {
  std::int64_t n;
  const double* u;
  double* p;
  std::vector<Real> w, t, q;
  std::vector<std::uint8_t> active;
  std::unique_ptr<std::byte[]> spare;  // two vectors of Real, or one of doubles

  explicit HaarState(std::int64_t size, const double* compenetration, double* pressure)
      : n(size),
        u(compenetration),
        p(pressure),
        w(static_cast<std::size_t>(size)),
        t(w.size()),
        q(w.size()),
        active(w.size(), 0),
        spare(new std::byte[w.size() * 2 * sizeof(Real)]) {}

  Real* first_spare() { return reinterpret_cast<Real*>(spare.get()); }
  Real* second_spare() { return first_spare() + n; }
  double* double_spare() { return reinterpret_cast<double*>(spare.get()); }
};

// t = z + beta t on the contact set, 0 elsewhere. Returns (w, t).
template <class Real> double turn(HaarState<Real>& s, const Real* z, Real beta, const rc_team& team);
// (t, q)
template <class Real> double curvature(const HaarState<Real>& s, const rc_team& team);
// p -= length t, w -= length q. With `cut` given, negative pressures are cut off into it: returns whether there were any.
template <class Real> bool advance(HaarState<Real>& s, double length, Real* cut, const rc_team& team);
// w += change - shift, where given.
template <class Real> HaarMeasure add_and_measure(HaarState<Real>& s, const Real* change, double shift, const rc_team& team);
// w = product - u - shift
template <class Real>
HaarMeasure replace_and_measure(HaarState<Real>& s, const double* product, double shift, const rc_team& team);
// Points with pressure, and those that overlap by more than the threshold. Returns whether the set changed.
template <class Real> bool choose_set(HaarState<Real>& s, double threshold, const rc_team& team);

}  // namespace rc
