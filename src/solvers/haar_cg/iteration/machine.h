// The requirements of haar-cg's iteration on a machine: the place where vectors are stored and sums are computed.
//
// A machine holds one contact problem: the pressures p in double precision, at most cap; w = H p - u - datum, a direction t, its
// product q = H t and two spare vectors z and y, all of type Real; the free set; and the preconditioner M, two multilevel trees.
// The iteration decides from sums alone and never reads a vector's values.
//
// The free set is where steps change the pressures. Without a cap it is the contact set.
#pragma once

#include <concepts>
#include <cstddef>

namespace rc {

// Sums over all unknowns, of the pressures p and the vector w.
struct HaarMeasure {
  double largest = 0;      // violation of the complementarity conditions: -w where p = 0, w where p = cap, |w| in between
  double load = 0;         // sum of p
  double merit = 0;        // sum of p (w - u) / 2, the functional that the solution minimises
  double moment = 0;       // sum of p w
  double free_load = 0;    // sum of p below the cap
  double free_moment = 0;  // sum of p w where p is below the cap
};

// A strip is so many neighbouring points in a line, or fewer at its end. Where it keeps its load, its pressures are multiplied by
// one factor, at least this share. Strips with a point at the cap do not keep theirs.
constexpr int haar_strip = 64;
constexpr double least_kept_share = 0.5;

struct HaarStart {
  double highest;  // largest u
  bool warm;       // some pressure is positive
};

// Vector and Wide are handles that are cheap to copy: a pointer, or an index into a device's memory. nullptr is the handle of no
// vector. Every sum is computed in double precision, in an order that does not change between runs.
template <class M>
concept Machine = std::floating_point<typename M::Real> && std::constructible_from<typename M::Vector, std::nullptr_t> &&
    std::constructible_from<typename M::Wide, std::nullptr_t> &&
    requires(M& m, typename M::Vector a, typename M::Vector b, typename M::Wide wide, double number, double* level, bool yes) {
  // Vectors of Real.
  { m.w() } -> std::same_as<typename M::Vector>;
  { m.t() } -> std::same_as<typename M::Vector>;
  { m.q() } -> std::same_as<typename M::Vector>;
  { m.z() } -> std::same_as<typename M::Vector>;
  { m.y() } -> std::same_as<typename M::Vector>;
  // Vectors of double: the pressures, and a spare one. The spare one may lie in the memory of z and y, and the trees in that of
  // y: the iteration calls set_up_trees() after every change of y or of the spare vector.
  { m.p() } -> std::same_as<typename M::Wide>;
  { m.wide_spare() } -> std::same_as<typename M::Wide>;

  // b = H a, in the precision of the vectors.
  m.product(a, b);
  m.product(wide, wide);
  // a += number, in every component.
  m.raise(a, number);
  m.raise(wide, number);
  // The sum of all components; the inner product (a, b), where a is 0 off the free set.
  { m.total(a) } -> std::same_as<double>;
  { m.total(wide) } -> std::same_as<double>;
  { m.inner(a, b) } -> std::same_as<double>;

  // Sets up the trees for the free set. number: by how much every entry of the trees' table exceeds that of the operator.
  m.set_up_trees(number);
  // z = M a on the free set, 0 elsewhere; without a: z = M 1. With a level: z = M (a - level), and the level is set so that the
  // sum of z is 0. Returns (z, b); without b: 0.
  { m.apply_trees(a, b, level) } -> std::same_as<double>;

  // p = max(p, 0), and cap where it is that but for rounding or more; every unknown is in the free set; t = 0.
  { m.begin() } -> std::same_as<HaarStart>;
  // p *= number. With yes: only where p is below the cap, and no further than the cap.
  m.multiply(number, yes);
  // p *= number where p is below the cap, and up to the cap; z is what that added to p; with yes it is added to z. Like advance()
  // it is called while z is 0 off the free set, as apply_trees() leaves it.
  m.scale(number, yes);
  // t = z + number t on the free set, 0 elsewhere. Returns (w, t).
  { m.turn(number) } -> std::same_as<double>;
  // p -= number t and w -= number q. With the first yes: p = min(max(p, 0), cap), and z is what that added to p; returns whether
  // it added anything. With the second as well: the strips keep the loads that they had before, and z has that, too.
  { m.advance(number, yes, yes) } -> std::same_as<bool>;
  // w += a and w -= number; without a: w -= number.
  { m.add_and_measure(a, number) } -> std::same_as<HaarMeasure>;
  // w = wide - u - number; without wide: w = -u - number, for p = 0.
  { m.replace_and_measure(wide, number) } -> std::same_as<HaarMeasure>;
  // w += number (w + u): by so much H p grows where p has grown by that share and the datum is 0.
  { m.grow_and_measure(number) } -> std::same_as<HaarMeasure>;
  // The free set becomes the unknowns with 0 < p < cap, p = 0 and w < -number, or p = cap and w > number. Returns whether it
  // changed.
  { m.choose_set(number) } -> std::same_as<bool>;
  // The least |w| where p = 0 (with yes) or where p = cap (without).
  { m.nearest(yes) } -> std::same_as<double>;
};

}  // namespace rc
