#include <iterator>

#include "core/limits.h"
#include "core/options.h"

namespace rc {

namespace {

constexpr rc_component core_specs[] = {
    text_option(RC_OPT_SOLVER, "auto", nullptr, "solver by name; auto: the one with the least estimated time"),
    text_option(RC_OPT_BACKEND, "auto", nullptr,
                "backend by name, or a preference list \"a,b\"; auto: the one with the least estimated time"),
    text_option(RC_OPT_KERNEL, "auto", nullptr,
                "influence kernel by name; auto is love for free and spectral for periodic boundaries", true),
    real_option(RC_OPT_TOL, "1e-8", 1e-16, 0.1, "convergence tolerance: the largest relative residual of a certified answer"),
    int_option(RC_OPT_MAX_ITER, "10000", 1, 1e9, "iterations of the solver after which it stops"),
    real_option(RC_OPT_TIME_LIMIT, "0", 0, 1e9, "seconds after which a step stops; 0: no limit"),
    int_option(
        RC_OPT_THREADS, "1", 1, most_threads,
        "threads that a contact may use, or a batch of contacts; the command and Python set one for each 16384 points, up to all "
        "cores",
        true),
    int_option(RC_OPT_STIFFNESS, "0", 0, 2,
               "1: compute dW/dd of the contact set, one more linear solve; 2: prove an interval of it, up to two more"),
    int_option(RC_OPT_ALLOW_FALLBACK, "1", 0, 1,
               "1: the core may replace an operation that a backend lacks by a slower one, which the note of the result names"),
    text_option(RC_OPT_WARMUP, "none", nullptr, "solver that runs first, for warmup.iterations; none: no warm-up"),
    int_option(RC_OPT_WARMUP_ITERATIONS, "50", 1, 1e9, "iterations of the warm-up"),
    int_option(RC_OPT_RESUMABLE, "0", 0, 1,
               "1: a step depends only on the last two certified ones, so that rc_contact_restore continues with the same bits; "
               "factorisations of earlier steps are not used"),
    int_option(RC_OPT_BOUNDS, "1", 0, 1, "1: prove intervals for load and contact area from the duality gap"),
    real_option(RC_OPT_ACCURACY, "0", 0, 0.5,
                "accepted relative error of load or area: a coarser grid is used if its estimated error is below this; "
                "residuals may be as large as 1/100 of it (area: 1/1000); 0: solve the given grid to tol",
                true),
    text_option(RC_OPT_ACCURACY_OF, "load", "load|area",
                "the quantity whose error is limited; load, if you prescribe it: the load that belongs to the approach found",
                true),
    text_option(RC_OPT_CERTIFY_BACKEND, "", nullptr, "backend for the certificate's product; empty: the solving one"),
};

}  // namespace

std::vector<OptionSpec> core_options() { return {std::begin(core_specs), std::end(core_specs)}; }

}  // namespace rc
