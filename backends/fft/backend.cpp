// Products with H by fast Fourier transforms on the bounding box of the points that may carry pressure.
#include <roughcontact/plugin.hpp>

#include "turned.h"

namespace rc_fft {

namespace {

using Functions = roughcontact::Functions<Turned>;

const rc_option_spec precision = {.struct_size = sizeof(rc_option_spec),
                                  .key = "fft.precision",
                                  .default_value = "auto",
                                  .choices = "auto|mixed|single",
                                  .help =
                                      "single: half the memory, every product off by up to 5e-7 of its largest entry; for tol of "
                                      "1e-5 and above only. auto: single where "
                                      "option accuracy allows it, else mixed",
                                  .type = RC_TYPE_TEXT,
                                  .fixed = 1};
const rc_option_spec* const options[] = {&precision};
const rc_backend backend = {
    .struct_size = sizeof(rc_backend),
    .name = "fft",
    .summary = "fast Fourier transforms on the box of the points that may carry pressure",
    .license = "BSD-3-Clause",
    .caps = RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_THREAD_INVARIANT | RC_CAP_NORM | RC_CAP_FLOAT | RC_CAP_ROWS,
    .n_options = 1,
    .options = options,
    .create = Functions::create,
    .destroy = Functions::destroy,
    .bind = Functions::bind,
    .apply = Functions::apply,
    .field = Functions::field,
    .modelled = Functions::modelled,
    .norm = Functions::norm,
    .apply_float = Functions::apply_float,
    .forget = Functions::forget,
    .score = Functions::score,
    .rest = Functions::rest};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                          .abi_major = RC_PLUGIN_ABI_MAJOR,
                          .abi_minor = RC_PLUGIN_ABI_MINOR,
                          .name = "fft",
                          .version = "0.1.0",
                          .n_backends = 1,
                          .backends = backends};

}  // namespace

}  // namespace rc_fft

RC_PLUGIN_ENTRY(fft, , out) {
  *out = &rc_fft::plugin;
  return RC_OK;
}
