// Products and solves with stored entries of H: exact, for small problems and as the reference for every other backend.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_dense {

namespace {

constexpr rc_component memory_limit =
    roughcontact::real_option(memory_limit_key, "8192", 1, 1e9, "most memory for matrix and factors together [MiB]", true);
constexpr const rc_component* options[] = {&memory_limit};
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
