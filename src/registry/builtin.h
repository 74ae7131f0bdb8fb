// Components linked into the library, and those that are known but may be absent.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace rc {

std::vector<rc_plugin_query_fn> builtin_plugins();

// How to get a component that exists but is not in this library; null for unknown names.
const char* known_but_absent(std::string_view name);

// Points of a grid from which on "auto" opens the plugin of this name; 0 for unknown names.
std::int64_t auto_opens_from(std::string_view name);

}  // namespace rc
