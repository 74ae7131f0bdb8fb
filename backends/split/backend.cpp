// Products with H for a contact that is small against the grid: their cost follows the contact.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_split {

namespace {

using Functions = roughcontact::Functions<Operator>;

const rc_option_spec spacing = {.struct_size = sizeof(rc_option_spec),
                                .key = "split.spacing",
                                .default_value = "auto",
                                .choices = "auto|4|8|16",
                                .help = "cells of the grid to a cell of the coarse one; auto: what costs least",
                                .type = RC_TYPE_TEXT,
                                .fixed = 1};
const rc_option_spec* const options[] = {&spacing};
const rc_backend backend = {
    .struct_size = sizeof(rc_backend),
    .name = "split",
    .summary = "short range summed directly, the rest over a coarse grid (FFTW): for dilute contact, to about 1e-11",
    .license = "GPL-2.0-or-later",
    .caps = RC_CAP_FREE | RC_CAP_THREAD_INVARIANT | RC_CAP_FLOAT | RC_CAP_SCREEN | RC_CAP_APPROXIMATE | RC_CAP_FAR_FIELD |
            RC_CAP_SINGLE_GAP | RC_CAP_SCREEN_ROWS,
    .n_options = 1,
    .options = options,
    .create = Functions::create,
    .destroy = Functions::destroy,
    .bind = Functions::bind,
    .apply = Functions::apply,
    .field = Functions::field,
    .modelled = Functions::modelled,
    .apply_float = Functions::apply_float,
    .screen = Functions::screen,
    .score = Functions::score};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                          .abi_major = RC_PLUGIN_ABI_MAJOR,
                          .abi_minor = RC_PLUGIN_ABI_MINOR,
                          .name = "split",
                          .version = "0.1.0",
                          .n_backends = 1,
                          .backends = backends};

}  // namespace

}  // namespace rc_split

RC_PLUGIN_ENTRY(split, , out) {
  *out = &rc_split::plugin;
  return RC_OK;
}
