// The solvers of this source tree as one built-in plugin, through the same vtable as those from outside.
#include <algorithm>
#include <new>

#include "solvers/solver.h"

namespace rc {

std::int64_t Problem::option_int(const char* key) const {
  std::int64_t value = 0;
  check(host_.option_int(&host_, &options_, key, &value));
  return value;
}

double Problem::option_real(const char* key) const {
  double value = 0;
  check(host_.option_real(&host_, &options_, key, &value));
  return value;
}

std::string Problem::option_text(const char* key) const {
  const char* value = "";
  check(host_.option_text(&host_, &options_, key, &value));
  return value;
}

namespace {

using Function = rc_status (*)(const Problem&, Vector&, double&);
using InPlace = rc_status (*)(const Problem&, std::span<double>, double&);

template <Function function>
rc_status solve(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  Vector pressure;
  rc_status status;
  try {
    pressure.assign(p, p + problem->n);
    status = function(Problem(*host, *problem, *options), pressure, *d);
  } catch (const Leave& leave) {
    status = leave.status;
  } catch (const std::bad_alloc&) {
    return host->fail(host, RC_ERR_MEMORY, "out of memory in the solver's vectors");
  }
  if (status >= 0)
    for (std::int64_t i = 0; i < problem->n; ++i)
      p[i] = std::max(pressure[static_cast<std::size_t>(i)], 0.0);  // negative where a stop came between a step and its cut
  return status;
}

template <InPlace function>
rc_status solve(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  rc_status status;
  try {
    status = function(Problem(*host, *problem, *options), {p, static_cast<std::size_t>(problem->n)}, *d);
  } catch (const Leave& leave) {
    status = leave.status;
  } catch (const std::bad_alloc&) {
    return host->fail(host, RC_ERR_MEMORY, "out of memory in the solver's vectors");
  }
  if (status > 0)
    for (std::int64_t i = 0; i < problem->n; ++i) p[i] = std::max(p[i], 0.0);  // negative before a cut
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
