// Products with H for a contact that is small against the grid: their cost follows the contact.
#include <roughcontact/plugin.hpp>

#include "operator.h"

namespace rc_split {

namespace {

constexpr rc_component spacing = roughcontact::text_option(
    "split.spacing", "auto", "auto|4|8|16", "cells of the grid to a cell of the coarse one; auto: what costs least", true);
constexpr const rc_component* options[] = {&spacing};
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
