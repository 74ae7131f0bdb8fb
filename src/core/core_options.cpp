#include "core/options.h"

namespace rc {

const std::vector<OptionSpec>& core_options() {
  static const std::vector<OptionSpec> specs = {
      {RC_OPT_SOLVER, "auto", "solver by name; auto chooses by the number of candidates and the tolerance", {}, "", RC_TYPE_TEXT, false, 0, 0, {}},
      {RC_OPT_BACKEND, "auto", "backend by name, or a preference list \"a,b\"; auto chooses by the number of candidates", {}, "",
       RC_TYPE_TEXT, false, 0, 0, {}},
      {RC_OPT_KERNEL, "auto", "influence kernel by name; auto is love for free and spectral for periodic boundaries", {}, "", RC_TYPE_TEXT,
       true, 0, 0, {}},
      {RC_OPT_TOL, "1e-8", "largest relative residual of a certified answer", {}, "", RC_TYPE_REAL, false, 1e-16, 0.1, {}},
      {RC_OPT_MAX_ITER, "10000", "iterations of the solver after which it stops", {}, "", RC_TYPE_INT, false, 1, 1e9, {}},
      {RC_OPT_TIME_LIMIT, "0", "seconds after which a step stops; 0: no limit", {}, "", RC_TYPE_REAL, false, 0, 1e9, {}},
      {RC_OPT_THREADS, "1", "threads a backend may use", {}, "", RC_TYPE_INT, true, 1, 1024, {}},
      {RC_OPT_STIFFNESS, "0", "1: compute dW/dd of the contact set, one more linear solve", {}, "", RC_TYPE_INT, false, 0, 1, {}},
      {RC_OPT_ALLOW_FALLBACK, "1", "1: the core may replace an operation that a backend lacks by a slower one, named in the result", {}, "",
       RC_TYPE_INT, false, 0, 1, {}},
      {RC_OPT_CERTIFY_BACKEND, "", "backend for the certificate's product; empty: the solving one", {}, "", RC_TYPE_TEXT, false, 0, 0, {}},
  };
  return specs;
}

}  // namespace rc
