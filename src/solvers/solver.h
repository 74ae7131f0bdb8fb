// The interface that the solvers of this source tree use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/options.h"
#include "solvers/problem.h"

namespace rc {

// A solver's options, keys "<name>.<key>".
struct Options {
  const rc_component* const* specs = nullptr;
  std::int64_t count = 0;
};
template <std::size_t count> constexpr Options listed(const rc_component* const (&specs)[count]) {
  return {specs, static_cast<std::int64_t>(count)};
}

// Seconds for the products of iterations that take `usual` of them on a half-space, where little depends on the grid. Near
// round-off they go on until they stall, and of the caller's own matrix or product nothing is known but that each unknown may
// take one.
inline double iterating(const rc_facts& facts, double usual) {
  constexpr double near_round_off = 1e-12, until_they_stall = 250;
  const bool grid = facts.system->op == RC_OPERATOR_HALFSPACE;
  return facts.backend->product * (!grid                        ? static_cast<double>(facts.n)
                                   : facts.tol < near_round_off ? until_they_stall * usual
                                                                : usual);
}
inline double with_the_rest(const rc_facts& facts, double solving) {
  return facts.backend->seconds + solving + facts.backend->field;
}

// The score of a solver that is chosen by its name alone.
rc_status by_name_only(const rc_facts* facts, rc_estimate* estimate);

// Declares the namespace of every line of solvers.def. `solve` improves p (and, in load control, d) until problem.tol() is met.
// With IN_PLACE it works on the caller's array. `score` is that of rc_solver; a solver whose line has by_name_only does not
// define it.
#define RC_SOLVER_NAMESPACE(name, Pressures)                       \
  namespace name {                                                 \
  rc_status solve(const Problem& problem, Pressures p, double& d); \
  rc_status score(const rc_facts* facts, rc_estimate* estimate);   \
  extern const Options options;                                    \
  }
#define RC_SOLVER(space, name, summary, needs, controls, score) RC_SOLVER_NAMESPACE(space, Vector&)
#define RC_SOLVER_IN_PLACE(space, name, summary, needs, controls, score) RC_SOLVER_NAMESPACE(space, std::span<double>)
#include "solvers/solvers.def"
#undef RC_SOLVER
#undef RC_SOLVER_IN_PLACE
#undef RC_SOLVER_NAMESPACE

}  // namespace rc
