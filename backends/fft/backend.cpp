// Products with H by fast Fourier transforms on the bounding box of the points that may carry pressure.
#include <roughcontact/plugin.hpp>

#include "half_space.h"

namespace rc_fft {

namespace {

constexpr rc_component precision =
    roughcontact::text_option("fft.precision", "auto", "auto|mixed|single",
                              "single: half the memory for transforms, errors of products up to 5e-7 of their largest entry; "
                              "only for tol of 1e-5 and above. auto: single if option accuracy allows it, else mixed",
                              true);
constexpr const rc_component* options[] = {&precision};
constexpr rc_backend backend = roughcontact::backend<HalfSpace>(
    "fast Fourier transforms on the box of the points that may carry pressure", "BSD-3-Clause",
    RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_SEMI_PERIODIC | RC_CAP_ROWS | RC_CAP_THREAD_INVARIANT, options);
constexpr const rc_backend* backends[] = {&backend};
constexpr rc_plugin plugin = roughcontact::plugin("fft", "0.1.0", backends);

}  // namespace

}  // namespace rc_fft

RC_PLUGIN_ENTRY(fft, , out) {
  *out = &rc_fft::plugin;
  return RC_OK;
}
