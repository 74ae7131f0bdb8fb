// Plugins on disk: where they may lie, which are refused, and the one place that loads code.
#pragma once

#include <roughcontact/plugin.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace rc {

class Context;
struct ContextConfig;

// [a-z][a-z0-9_-]{0,30}: no path can hide in a name.
bool is_component_name(std::string_view name);

// Configured, RC_PLUGIN_PATH, installed: absolute directories in the order they are searched. Others are logged and dropped.
std::vector<std::string> plugin_directories(const ContextConfig& config, const Context& context);

// The first directory's rcb_<name>.so, or what this system calls it; "" if there is none.
std::string find_plugin(const std::vector<std::string>& directories, std::string_view name);

// Names of all plugins in these directories, sorted, each once.
std::vector<std::string> plugin_names(const std::vector<std::string>& directories);

// Thrown if the plugin itself refuses, for example because the machine has no device.
class Refusal : public Error {
  using Error::Error;
};

// Loads and queries. The code stays in the process for good. Throws Error(RC_ERR_PLUGIN) and Refusal.
const rc_plugin* load_plugin(const std::string& path, const std::string& name, const rc_host& host);

}  // namespace rc
