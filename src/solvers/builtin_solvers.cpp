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
    try {
      check(function(Problem(*host, *problem, *options), pressure, *d));
    } catch (const Error& error) {  // that ranks have agreed upon
      throw roughcontact::Failure{error.code(), error.what()};
    }
  });
  if (status > 0 || (status == 0 && !in_place))
    for (std::int64_t i = 0; i < problem->n; ++i)
      p[i] = std::min(std::max(pressure[static_cast<std::size_t>(i)], 0.0),
                      problem->cap);  // beyond where a stop came between a step and its cut
  return status;
}

const char license[] = "BSD-3-Clause";

// Built at the first query, because the options of other files are not constant expressions here.
const rc_plugin& plugin() {
#define RC_SOLVER(space, solver, text, operations, controlled, scored)               \
  static const rc_solver space##_entry = {.struct_size = sizeof(rc_solver),          \
                                          .name = solver,                            \
                                          .summary = text,                           \
                                          .license = license,                        \
                                          .needs = operations | RC_READS_SINGLE_GAP, \
                                          .controls = controlled,                    \
                                          .n_options = space::options.count,         \
                                          .options = space::options.specs,           \
                                          .solve = solve<space::solve>,              \
                                          .score = scored};
#define RC_SOLVER_IN_PLACE RC_SOLVER
#include "solvers/solvers.def"
#undef RC_SOLVER
  static const rc_solver* const entries[] = {
#define RC_SOLVER(space, solver, text, operations, controlled, scored) &space##_entry,
#include "solvers/solvers.def"
#undef RC_SOLVER
#undef RC_SOLVER_IN_PLACE
  };
  static const rc_plugin all = {.struct_size = sizeof(rc_plugin),
                                .abi_major = RC_PLUGIN_ABI_MAJOR,
                                .abi_minor = RC_PLUGIN_ABI_MINOR,
                                .name = "solvers",
                                .version = "0.1.0",
                                .n_solvers = std::size(entries),
                                .solvers = entries};
  return all;
}

}  // namespace

rc_status by_name_only(const rc_facts* facts, rc_estimate*) {
  return facts->host->fail(facts->host, RC_ERR_INCOMPATIBLE, "by name only: a method of the paper that others are faster than");
}

}  // namespace rc

extern "C" rc_status rc_builtin_solvers(const rc_host*, const rc_plugin** out) {
  *out = &rc::plugin();
  return RC_OK;
}
