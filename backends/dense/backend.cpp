// Products and solves with stored entries of H: exact, for small problems and as the reference for every other backend.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_dense {

namespace {

using Functions = roughcontact::Functions<Operator>;

const rc_option_spec memory_limit = {sizeof(rc_option_spec),
                                     memory_limit_key,
                                     "8192",
                                     nullptr,
                                     "most memory for matrix and factors together [MiB]",
                                     RC_TYPE_REAL,
                                     1,
                                     1.0,
                                     1e9};
const rc_option_spec* const options[] = {&memory_limit};
const rc_backend backend = {
    sizeof(rc_backend),
    "dense",
    "stored matrix with an updatable Cholesky factor",
    "BSD-3-Clause AND MPL-2.0",
    RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_DENSE_INPUT | RC_CAP_SUBSET | RC_CAP_THREAD_INVARIANT | RC_CAP_SHIFTED | RC_CAP_NORM,
    1,
    options,
    Functions::create,
    Functions::destroy,
    Functions::bind,
    Functions::apply,
    Functions::field,
    Functions::modelled,
    Functions::subset,
    Functions::shifted,
    Functions::norm,
    nullptr,
    nullptr,
    nullptr};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "dense", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

}  // namespace rc_dense

RC_PLUGIN_ENTRY(dense, , out) {
  *out = &rc_dense::plugin;
  return RC_OK;
}
