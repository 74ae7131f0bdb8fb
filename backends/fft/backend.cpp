// Products with H by fast Fourier transforms on the bounding box of the points that may carry pressure.
#include <roughcontact/plugin.hpp>

#include "turned.h"

namespace rc_fft {

namespace {

using Functions = roughcontact::Functions<Turned>;

const rc_option_spec planning = {
    sizeof(rc_option_spec),
    "fft.planning",
    "auto",
    "auto|estimate|measure",
    "measure: time FFTW's plans first, so that the last bits may differ from run to run; auto: only where deterministic is 0",
    RC_TYPE_TEXT,
    1,
    0.0,
    0.0};
const rc_option_spec wisdom = {
    sizeof(rc_option_spec),
    "fft.wisdom",
    "",
    nullptr,
    "file of FFTW's measurements, read before plans are made, written after measuring; single precision: with .float appended",
    RC_TYPE_TEXT,
    1,
    0.0,
    0.0};
const rc_option_spec precision = {sizeof(rc_option_spec),
                                  "fft.precision",
                                  "auto",
                                  "auto|mixed|single",
                                  "single: half the memory, every product off by up to 5e-7 of its largest entry; for tol of "
                                  "1e-5 and above only. auto: single where "
                                  "option accuracy allows it, else mixed",
                                  RC_TYPE_TEXT,
                                  1,
                                  0.0,
                                  0.0};
const rc_option_spec* const options[] = {&planning, &wisdom, &precision};
const rc_backend backend = {sizeof(rc_backend),
                            "fft",
                            "fast Fourier transforms (FFTW) on the box of the points that may carry pressure",
                            "GPL-2.0-or-later",
                            RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_THREAD_INVARIANT | RC_CAP_NORM | RC_CAP_FLOAT,
                            3,
                            options,
                            Functions::create,
                            Functions::destroy,
                            Functions::bind,
                            Functions::apply,
                            Functions::field,
                            Functions::modelled,
                            nullptr,
                            nullptr,
                            Functions::norm,
                            Functions::apply_float,
                            nullptr,
                            Functions::forget};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "fft", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

}  // namespace rc_fft

RC_PLUGIN_ENTRY(fft, , out) {
  *out = &rc_fft::plugin;
  return RC_OK;
}
