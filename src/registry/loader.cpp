#include "registry/loader.h"

#include <algorithm>

#include "core/error.h"
#include "platform/libraries.h"
#include "platform/threads.h"
#include "registry/context.h"

namespace rc {

namespace {

using namespace rc_platform;

constexpr std::string_view prefix = "rcb_";

// The folder beside the shared library with this code, so that an installed tree can be moved; for a program that links the
// static library, the configured installation.
std::string installed_directory() {
  const std::string file = file_of(reinterpret_cast<void*>(&is_component_name));
  const std::size_t name = file.find_last_of("/\\") + 1;  // 0 if there is no directory
  if (name > 0 && file.compare(name, own_library.size(), own_library) == 0)
    return join(std::string_view(file).substr(0, name), RC_PLUGIN_SUBDIRECTORY);
  return RC_INSTALLED_PLUGIN_DIRECTORY;
}

void append(std::vector<std::string>& directories, std::string_view path, const char* source, const Context& context) {
  for (const std::string& directory : split(path, path_separator)) {
    if (is_absolute(directory))
      directories.push_back(directory);
    else if (!directory.empty())
      context.log(RC_LOG_WARNING, join("plugin directory \"", directory, "\" from ", source, " ignored: it is not absolute"));
  }
}

}  // namespace

bool is_component_name(std::string_view name) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && name.size() <= 31 && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::vector<std::string> plugin_directories(const ContextConfig& config, const Context& context) {
  std::vector<std::string> directories;
  append(directories, config.plugin_path, "the context's plugin_path", context);
  if (!(config.flags & RC_CONTEXT_NO_ENVIRONMENT))
    if (const char* path = trusted_environment("RC_PLUGIN_PATH")) append(directories, path, "RC_PLUGIN_PATH", context);
  append(directories, installed_directory(), "the installation", context);
  return directories;
}

std::string find_plugin(const std::vector<std::string>& directories, std::string_view name) {
  for (const std::string& directory : directories) {
    std::string path = join(directory, "/", prefix, name, library_suffix);
    if (exists(path)) return path;
  }
  return {};
}

std::vector<std::string> plugin_names(const std::vector<std::string>& directories) {
  std::vector<std::string> names;
  for (const std::string& directory : directories) {
    for (const std::string& entry : names_in(directory)) {
      const std::string_view file = entry;
      const std::size_t around = prefix.size() + library_suffix.size();
      if (!file.starts_with(prefix) || !file.ends_with(library_suffix) || file.size() <= around) continue;
      const std::string_view name = file.substr(prefix.size(), file.size() - around);
      if (is_component_name(name)) names.emplace_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

const rc_plugin* load_plugin(const std::string& path, const std::string& name, const rc_host& host) {
  const rc_platform::SignalsBlocked its_threads_take_no_signals;
  const OpenedPlugin opened = open_plugin(path);
  if (!opened.code) fail(RC_ERR_PLUGIN, opened.error);
  const auto query = reinterpret_cast<rc_plugin_query_fn>(symbol_of(opened.code, "rc_plugin_query"));
  if (!query) fail(RC_ERR_PLUGIN, "plugin refused: ", path, " does not export rc_plugin_query");
  const rc_plugin* plugin = nullptr;
  clear_message();
  if (const rc_status status = query(&host, &plugin); status < 0)
    throw Refusal(
        RC_ERR_PLUGIN,
        join("plugin ", path, " refuses to be used: ", last_message()[0] != '\0' ? last_message() : rc_status_text(status)));
  if (!plugin) fail(RC_ERR_PLUGIN, "plugin refused: ", path, " describes nothing");
  if (!plugin->name || name != plugin->name)
    fail(RC_ERR_PLUGIN, "plugin refused: ", path, " calls itself \"", plugin->name ? plugin->name : "", "\", not \"", name, "\"");
  return plugin;
}

}  // namespace rc
