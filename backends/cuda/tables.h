// The plugin's backend, its solver and their options.
#pragma once

#include <roughcontact/plugin.h>

namespace rc_cuda {

// name: that of the plugin's file.
rc_plugin plugin_named(const char* name);

}  // namespace rc_cuda
