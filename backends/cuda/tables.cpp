#include "tables.h"

#include "names.h"
#include "operator.h"
#include "small/many.h"
#include "solver.h"

namespace rc_cuda {

namespace {

constexpr char license[] = "BSD-3-Clause";

const rc_option_spec index = {.struct_size = sizeof(rc_option_spec),
                              .key = names::index,
                              .default_value = "0",
                              .help = "number of the device, as the driver counts them",
                              .type = RC_TYPE_INT,
                              .fixed = 1,
                              .minimum = 0,
                              .maximum = 1023};
const rc_option_spec memory_limit = {.struct_size = sizeof(rc_option_spec),
                                     .key = names::memory_limit,
                                     .default_value = "1048576",
                                     .help = "memory on the device that a contact may take [MiB]",
                                     .type = RC_TYPE_REAL,
                                     .fixed = 1,
                                     .minimum = 0,
                                     .maximum = 1e12};
const rc_option_spec* const options[] = {&index, &memory_limit};

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
