// Products and solves with stored entries of H: exact, for small problems and as the reference for every other backend.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_dense {

namespace {

const rc_option_spec memory_limit = {.struct_size = sizeof(rc_option_spec),
                                     .key = memory_limit_key,
                                     .default_value = "8192",
                                     .help = "most memory for matrix and factors together [MiB]",
                                     .type = RC_TYPE_REAL,
                                     .fixed = 1,
                                     .minimum = 1.0,
                                     .maximum = 1e9};
const rc_option_spec* const options[] = {&memory_limit};
constexpr rc_backend backend = roughcontact::backend<Operator>(
    "stored matrix with an updatable Cholesky factor", "BSD-3-Clause AND MPL-2.0",
    RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_SEMI_PERIODIC | RC_CAP_DENSE_INPUT | RC_CAP_THREAD_INVARIANT, options);
constexpr const rc_backend* backends[] = {&backend};
constexpr rc_plugin plugin = roughcontact::plugin("dense", "0.1.0", backends);

}  // namespace

}  // namespace rc_dense

RC_PLUGIN_ENTRY(dense, , out) {
  *out = &rc_dense::plugin;
  return RC_OK;
}
