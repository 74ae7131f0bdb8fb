// Products with H, and solves by SuiteSparse's CHOLMOD.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_cholmod {

namespace {

using Functions = roughcontact::Functions<Operator>;

const rc_option_spec memory_limit = {sizeof(rc_option_spec),
                                     memory_limit_key,
                                     "8192",
                                     nullptr,
                                     "most memory for a factor while it is made [MiB]",
                                     RC_TYPE_REAL,
                                     1,
                                     1.0,
                                     1e9};
const rc_option_spec near_field = {sizeof(rc_option_spec),
                                   near_field_key,
                                   "0",
                                   nullptr,
                                   "0: factor all entries; else: iterate, and factor those up to so many cells apart",
                                   RC_TYPE_REAL,
                                   1,
                                   0.0,
                                   1e6};
const rc_option_spec* const options[] = {&memory_limit, &near_field};
const rc_backend backend = {sizeof(rc_backend),
                            "cholmod",
                            "Cholesky factors by SuiteSparse, of all entries with rows added and deleted or of the near field",
                            "GPL-2.0-or-later AND LGPL-2.1-or-later AND MPL-2.0 AND BSD-3-Clause",
                            RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_DENSE_INPUT | RC_CAP_SUBSET | RC_CAP_SHIFTED | RC_CAP_NORM,
                            2,
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
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "cholmod", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

}  // namespace rc_cholmod

RC_PLUGIN_ENTRY(cholmod, , out) {
  *out = &rc_cholmod::plugin;
  return RC_OK;
}
