#include "core/options.h"
#include "core/text.h"

namespace rc {

namespace {

OptionSpec text(const char* key, const char* value, const char* help) {
  OptionSpec spec;
  spec.key = key;
  spec.default_value = value;
  spec.help = help;
  return spec;
}

OptionSpec choice(const char* key, const char* value, const char* choices, const char* help) {
  OptionSpec spec = text(key, value, help);
  spec.choices = split(choices, '|');
  spec.choices_text = choices;
  return spec;
}

OptionSpec number(int type, const char* key, const char* value, double minimum, double maximum, const char* help) {
  OptionSpec spec = text(key, value, help);
  spec.type = type;
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

OptionSpec fixed(OptionSpec spec) {
  spec.fixed = true;
  return spec;
}

}  // namespace

const std::vector<OptionSpec>& core_options() {
  static const std::vector<OptionSpec> specs = {
      text(RC_OPT_SOLVER, "auto", "solver by name; auto: the one that needs least time, by its own estimate"),
      text(RC_OPT_BACKEND, "auto",
           "backend by name, or a preference list \"a,b\"; auto: the one that needs least time, by its own estimate"),
      fixed(text(RC_OPT_KERNEL, "auto", "influence kernel by name; auto is love for free and spectral for periodic boundaries")),
      number(RC_TYPE_REAL, RC_OPT_TOL, "1e-8", 1e-16, 0.1, "largest relative residual of a certified answer"),
      number(RC_TYPE_INT, RC_OPT_MAX_ITER, "10000", 1, 1e9, "iterations of the solver after which it stops"),
      number(RC_TYPE_REAL, RC_OPT_TIME_LIMIT, "0", 0, 1e9, "seconds after which a step stops; 0: no limit"),
      fixed(number(RC_TYPE_INT, RC_OPT_THREADS, "1", 1, 1024, "threads that a contact may use, or a batch of contacts")),
      fixed(number(RC_TYPE_INT, RC_OPT_DETERMINISTIC, "1", 0, 1,
                   "1: the same bits in every run and for every number of threads; 0: components may trade them for speed")),
      number(RC_TYPE_INT, RC_OPT_STIFFNESS, "0", 0, 1, "1: compute dW/dd of the contact set, one more linear solve"),
      number(RC_TYPE_INT, RC_OPT_ALLOW_FALLBACK, "1", 0, 1,
             "1: the core may replace an operation that a backend lacks by a slower one, named in the result"),
      text(RC_OPT_WARMUP, "none", "solver that runs first, for warmup.iterations; none: no warm-up"),
      number(RC_TYPE_INT, RC_OPT_WARMUP_ITERATIONS, "50", 1, 1e9, "iterations of the warm-up"),
      number(RC_TYPE_INT, RC_OPT_RESUMABLE, "0", 0, 1,
             "1: a step depends on the last two certified ones alone, so that rc_contact_restore continues with the same bits; "
             "factors and other leftovers of earlier steps are made anew"),
      number(RC_TYPE_INT, RC_OPT_BOUNDS, "1", 0, 1, "1: prove intervals for load and contact area from the duality gap"),
      fixed(number(
          RC_TYPE_REAL, RC_OPT_ACCURACY, "0", 0, 0.5,
          "relative error that load or area may have: a coarser grid is solved where that will do, to a hundredth of it at "
          "most; 0: the given grid to tol")),
      fixed(choice(RC_OPT_ACCURACY_OF, "load", "load|area",
                   "what accuracy is of; in load control, load: the load that belongs to the approach found")),
      text(RC_OPT_CERTIFY_BACKEND, "", "backend for the certificate's product; empty: the solving one"),
  };
  return specs;
}

}  // namespace rc
