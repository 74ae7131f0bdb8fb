#include "tables.h"

#include "names.h"
#include "operator.h"
#include "small/many.h"
#include "solver.h"

namespace rc_cuda {

namespace {

constexpr char license[] = "BSD-3-Clause";

constexpr rc_component index =
    roughcontact::int_option(names::index, "0", 0, 1023, "number of the device, as the driver counts them", true);
constexpr rc_component memory_limit = roughcontact::real_option(names::memory_limit, "1048576", 0, 1e12,
                                                                "memory on the device that a contact may take [MiB]", true);
constexpr const rc_component* options[] = {&index, &memory_limit};

constexpr rc_backend backend = roughcontact::backend<Operator>("fast Fourier transforms on a CUDA device", license,
                                                               RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_THREAD_INVARIANT, options);
const rc_solver solver = {.struct_size = sizeof(rc_solver),
                          .name = names::solver,
                          .summary = "haar-cg with all its vectors on a CUDA device; options haar-cg.* are its own, too",
                          .license = license,
                          .needs = RC_NEEDS_GRID | RC_WANTS_BOX | RC_READS_GAP | RC_TAKES_CAP | RC_READS_SINGLE_GAP,
                          .controls = RC_CONTROL_APPROACH | RC_CONTROL_LOAD,
                          .solve = solve,
                          .score = score,
                          .solve_many = solve_many};
constexpr const rc_backend* backends[] = {&backend};
const rc_solver* const solvers[] = {&solver};

}  // namespace

rc_plugin plugin_named(const char* name) {
  rc_plugin made = roughcontact::plugin(name, "0.1.0", backends);
  made.n_solvers = 1;
  made.solvers = solvers;
  return made;
}

}  // namespace rc_cuda
