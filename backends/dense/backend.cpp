// Products and solves with stored entries of H: exact, for small problems and as the reference for every other backend.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_dense {

namespace {

using Functions = roughcontact::Functions<Operator>;

const rc_option_spec memory_limit = {.struct_size = sizeof(rc_option_spec),
                                     .key = memory_limit_key,
                                     .default_value = "8192",
                                     .help = "most memory for matrix and factors together [MiB]",
                                     .type = RC_TYPE_REAL,
                                     .fixed = 1,
                                     .minimum = 1.0,
                                     .maximum = 1e9};
const rc_option_spec* const options[] = {&memory_limit};
const rc_backend backend = {.struct_size = sizeof(rc_backend),
                            .name = "dense",
                            .summary = "stored matrix with an updatable Cholesky factor",
                            .license = "BSD-3-Clause AND MPL-2.0",
                            .caps = RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_DENSE_INPUT | RC_CAP_SUBSET | RC_CAP_THREAD_INVARIANT |
                                    RC_CAP_SHIFTED | RC_CAP_NORM,
                            .n_options = 1,
                            .options = options,
                            .create = Functions::create,
                            .destroy = Functions::destroy,
                            .bind = Functions::bind,
                            .apply = Functions::apply,
                            .field = Functions::field,
                            .modelled = Functions::modelled,
                            .subset = Functions::subset,
                            .shifted = Functions::shifted,
                            .norm = Functions::norm,
                            .forget = Functions::forget,
                            .score = Functions::score,
                            .rest = Functions::rest};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                          .abi_major = RC_PLUGIN_ABI_MAJOR,
                          .abi_minor = RC_PLUGIN_ABI_MINOR,
                          .name = "dense",
                          .version = "0.1.0",
                          .n_backends = 1,
                          .backends = backends};

}  // namespace

}  // namespace rc_dense

RC_PLUGIN_ENTRY(dense, , out) {
  *out = &rc_dense::plugin;
  return RC_OK;
}
