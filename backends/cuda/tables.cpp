#include "tables.h"

#include "arrays.h"
#include "names.h"
#include "operator.h"
#include "small/many.h"
#include "solver.h"

namespace rc_cuda {

namespace {

using Functions = roughcontact::Functions<Operator>;

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

const rc_backend backend = {.struct_size = sizeof(rc_backend),
                            .name = names::backend,
                            .summary = "fast Fourier transforms on a CUDA device",
                            .license = license,
                            .caps = RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_THREAD_INVARIANT | RC_CAP_FLOAT,
                            .n_options = 2,
                            .options = options,
                            .create = Functions::create,
                            .destroy = Functions::destroy,
                            .bind = Functions::bind,
                            .apply = Functions::apply,
                            .field = Functions::field,
                            .modelled = Functions::modelled,
                            .apply_float = Functions::apply_float,
                            .score = Functions::score,
                            .fetch = fetch,
                            .store = store};
const rc_solver solver = {.struct_size = sizeof(rc_solver),
                          .name = names::solver,
                          .summary = "haar-cg with all its vectors on a CUDA device; options haar-cg.* are its own, too",
                          .license = license,
                          .needs = RC_NEEDS_GRID | RC_WANTS_BOX | RC_READS_GAP | RC_TAKES_CAP | RC_READS_SINGLE_GAP,
                          .controls = RC_CONTROL_APPROACH | RC_CONTROL_LOAD,
                          .solve = solve,
                          .score = score,
                          .solve_many = solve_many};
const rc_backend* const backends[] = {&backend};
const rc_solver* const solvers[] = {&solver};

}  // namespace

rc_plugin plugin_named(const char* name) {
  return {.struct_size = sizeof(rc_plugin),
          .abi_major = RC_PLUGIN_ABI_MAJOR,
          .abi_minor = RC_PLUGIN_ABI_MINOR,
          .name = name,
          .version = "0.1.0",
          .n_backends = 1,
          .n_solvers = 1,
          .backends = backends,
          .solvers = solvers};
}

}  // namespace rc_cuda
