// The kernel "layer" as a component.
#pragma once

#include <roughcontact/plugin.h>

namespace rc::kernel::layer {

extern const rc_kernel component;

}  // namespace rc::kernel::layer
