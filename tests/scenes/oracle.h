// The exact solution of a step in extended precision, and what it is worth: 0 <= p <= cap, w = H p - u >= 0 where p = 0, <= 0
// where p = cap, 0 elsewhere. Takes nothing from the library.
#pragma once

#include <optional>

#include "influence.h"

namespace scenes {

/** Cholesky's factor of a symmetric matrix on a set of points. */
class Factor {
 public:
  /** Nothing if the matrix is not positive definite there, to rounding. `datum` is added to each entry. */
  static std::optional<Factor> of(const Influence& h, const std::vector<std::size_t>& set, Real datum = 0);

  Reals solve(Reals right) const;
  /** The largest sum of |H^-1| along a row; of more than 40 points three times the estimate of Hager (1984). */
  Real inverse_norm() const;

 private:
  std::size_t m_ = 0;
  Reals factor_;
};

enum class Worth {
  exact,    // every point's state is known
  ties,     // some points are at two states at once, to rounding
  soft,     // p is uncertain by more than 1e-6 of its largest
  unknown,  // no set of points solves the problem, or H is not positive definite on one
};

struct Exact {
  Worth worth = Worth::unknown;
  Reals p, w;                                                                         // w = H p - u
  std::vector<std::size_t> loose;                                                     // points with 0 < p < cap
  Real inverse = 0;                                                                   // Factor::inverse_norm on them
  Real error = 0;                                                                     // of p
  std::int64_t contacts = 0, contacts_possible = 0, capped = 0, capped_possible = 0;  // surely, at most
  Real sum = 0;                                                                       // of p
  Real functional = 0;                                                                // 1/2 p'Hp - u'p
  Real stiffness = 0;                                                                 // change of the sum of p with u

  bool usable() const { return worth == Worth::exact || worth == Worth::ties; }
};

/** u: d - h at each point; open: which points may carry pressure; cap: infinite for none. `noise`: of u, from the rounding of
 *  those who compute in double precision. `datum`: added to each entry of H. */
Exact solve_exactly(const Influence& h, const Reals& u, const std::vector<bool>& open, Real cap, Real noise, Real datum = 0);

/** The answer at this approach. `indentation` may be empty. load: with it, periodic boundaries, where the approach near full
 * contact does not determine the pressures, get a datum that ties both. */
Exact exact_at(const Scene& scene, const Influence& h, const Surface& surface, const Field& indentation, double approach,
               std::optional<double> load = {});

}  // namespace scenes
