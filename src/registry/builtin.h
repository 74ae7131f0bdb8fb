// Components linked into the library, and those that are known but may be absent.
#pragma once

#include <roughcontact/plugin.h>

#include <string_view>
#include <vector>

namespace rc {

std::vector<rc_plugin_query_fn> builtin_plugins();

// What to do to get a component that this library knows of but does not contain; null for unknown names.
const char* known_but_absent(std::string_view name);

// A plugin that "auto" leaves alone.
bool opened_by_name_only(std::string_view name);

}  // namespace rc
