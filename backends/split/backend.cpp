// Products with H for a contact that is small against the grid: their cost follows the contact.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_split {

namespace {

using Functions = roughcontact::Functions<Operator>;

const rc_option_spec spacing = {sizeof(rc_option_spec),
                                "split.spacing",
                                "auto",
                                "auto|4|8|16",
                                "cells of the grid to a cell of the coarse one; auto: what costs least",
                                RC_TYPE_TEXT,
                                1,
                                0.0,
                                0.0};
const rc_option_spec* const options[] = {&spacing};
const rc_backend backend = {sizeof(rc_backend),
                            "split",
                            "short range summed directly, the rest over a coarse grid (FFTW): for dilute contact, to about 1e-11",
                            "GPL-2.0-or-later",
                            RC_CAP_FREE | RC_CAP_THREAD_INVARIANT | RC_CAP_FLOAT | RC_CAP_SCREEN | RC_CAP_APPROXIMATE,
                            1,
                            options,
                            Functions::create,
                            Functions::destroy,
                            Functions::bind,
                            Functions::apply,
                            Functions::field,
                            Functions::modelled,
                            nullptr,
                            nullptr,
                            nullptr,
                            Functions::apply_float,
                            Functions::screen,
                            nullptr};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "split", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

}  // namespace rc_split

RC_PLUGIN_ENTRY(split, , out) {
  *out = &rc_split::plugin;
  return RC_OK;
}
