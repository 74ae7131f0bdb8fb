// The solvers of this source tree as one built-in plugin, through the same vtable as those from outside.
#include <algorithm>
#include <type_traits>

#include "solvers/solver.h"

namespace rc {

namespace {

using InPlace = rc_status (*)(const Problem&, std::span<double>, double&);

// function: one that takes a Vector, or that.
template <auto function>
rc_status solve(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  constexpr bool in_place = std::is_convertible_v<decltype(function), InPlace>;
  std::conditional_t<in_place, std::span<double>, Vector> pressure;
  const rc_status status = roughcontact::guard(host, {"solvers", "use a coarser grid"}, [&] {
    pressure = {p, p + problem->n};
    check(function(Problem(*host, *problem, *options), pressure, *d));
  });
  if (status > 0 || (status == 0 && !in_place))
    for (std::int64_t i = 0; i < problem->n; ++i)
      p[i] = std::max(pressure[static_cast<std::size_t>(i)], 0.0);  // negative where a stop came between a step and its cut
  return status;
}

const char license[] = "BSD-3-Clause";

// Built at the first query, because the options of other files are not constant expressions here.
const rc_plugin& plugin() {
#define RC_SOLVER(function, name, summary, needs, controls)                                                     \
  static const rc_solver function##_entry = {                                                                   \
      sizeof(rc_solver),        name,           summary, license, needs, controls, 0, function##_options.count, \
      function##_options.specs, solve<function>};
#define RC_SOLVER_IN_PLACE RC_SOLVER
#include "solvers/solvers.def"
#undef RC_SOLVER
  static const rc_solver* const entries[] = {
#define RC_SOLVER(function, name, summary, needs, controls) &function##_entry,
#include "solvers/solvers.def"
#undef RC_SOLVER
#undef RC_SOLVER_IN_PLACE
  };
  static const rc_plugin all = {
      sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "solvers", "0.1.0", 0, std::size(entries), nullptr, entries};
  return all;
}

}  // namespace

}  // namespace rc

extern "C" rc_status rc_builtin_solvers(const rc_host*, const rc_plugin** out) {
  *out = &rc::plugin();
  return RC_OK;
}
