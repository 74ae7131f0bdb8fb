// Products with H for a contact that is small against the grid: their cost follows the contact.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_split {

namespace {

const rc_option_spec spacing = {.struct_size = sizeof(rc_option_spec),
                                .key = "split.spacing",
                                .default_value = "auto",
                                .choices = "auto|4|8|16",
                                .help = "cells of the grid to a cell of the coarse one; auto: what costs least",
                                .type = RC_TYPE_TEXT,
                                .fixed = 1};
const rc_option_spec* const options[] = {&spacing};
constexpr rc_backend backend = roughcontact::backend<Operator>(
    "short range summed directly, the rest over a coarse grid (FFTW): for dilute contact, to about 1e-11", "GPL-2.0-or-later",
    RC_CAP_FREE | RC_CAP_FAR_FIELD | RC_CAP_THREAD_INVARIANT | RC_CAP_APPROXIMATE, options);
constexpr const rc_backend* backends[] = {&backend};
constexpr rc_plugin plugin = roughcontact::plugin("split", "0.1.0", backends);

}  // namespace

}  // namespace rc_split

RC_PLUGIN_ENTRY(split, , out) {
  *out = &rc_split::plugin;
  return RC_OK;
}
