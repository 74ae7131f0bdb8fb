// Products with H, and solves by SuiteSparse's CHOLMOD.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_cholmod {

namespace {

constexpr rc_component memory_limit =
    roughcontact::real_option(memory_limit_key, "8192", 1, 1e9, "most memory for a factor while it is made [MiB]", true);
constexpr rc_component near_field = roughcontact::real_option(
    near_field_key, "0", 0, 1e6, "0: factor all entries; else: iterate, and factor those up to so many cells apart", true);
constexpr const rc_component* options[] = {&memory_limit, &near_field};
constexpr rc_backend backend = roughcontact::backend<Operator>(
    "Cholesky factors by SuiteSparse, of all entries with rows added and deleted or of the near field",
    "GPL-2.0-or-later AND LGPL-2.1-or-later AND MPL-2.0 AND BSD-3-Clause",
    RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_SEMI_PERIODIC | RC_CAP_DENSE_INPUT, options);
constexpr const rc_backend* backends[] = {&backend};
constexpr rc_plugin plugin = roughcontact::plugin("cholmod", "0.1.0", backends);

}  // namespace

}  // namespace rc_cholmod

RC_PLUGIN_ENTRY(cholmod, , out) {
  *out = &rc_cholmod::plugin;
  return RC_OK;
}
