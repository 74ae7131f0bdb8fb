// Cases that need no plugin to be built for them; the others are in tests/plugins.
#include <roughcontact/plugin.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "errors/case.h"
#include "errors/scene.h"

namespace errors {

namespace {

rc_status name_backend(const char* plugin_path, std::uint32_t flags, const char* backend) {
  rc_context_config config = RC_CONTEXT_CONFIG_INIT;
  config.flags = flags;
  config.plugin_path = plugin_path;
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(&config, &context), RC_OK);
  const ContextHandle keep(context);
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context, &options), RC_OK);
  const OptionsHandle keep_options(options);
  assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, backend), RC_OK);
  return create(Scene(), options);
}

// A directory with one file, rcb_spoilt.so, that is not a plugin.
Outcome plugin_file(mode_t directory_mode, mode_t file_mode) {
  char current[4096];
  assert_non_null(getcwd(current, sizeof current));
  std::string directory = std::string(current) + "/errors-XXXXXX";
  assert_non_null(mkdtemp(directory.data()));
  const std::string path = directory + "/rcb_spoilt.so";
  std::FILE* file = std::fopen(path.c_str(), "w");
  assert_non_null(file);
  std::fputs("not a shared object", file);
  std::fclose(file);
  chmod(path.c_str(), file_mode);
  chmod(directory.c_str(), directory_mode);
  const Outcome outcome = name_backend(directory.c_str(), RC_CONTEXT_NO_ENVIRONMENT, "spoilt");
  unlink(path.c_str());
  rmdir(directory.c_str());
  return outcome;
}

template <class Change> auto registering(const Change& change) {
  return [change] {
    rc_plugin plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "mine", "1.0", 0, 0, nullptr, nullptr};
    change(plugin);
    rc_context* context = nullptr;
    assert_int_equal(rc_context_create(nullptr, &context), RC_OK);
    const ContextHandle keep(context);
    return Outcome(rc_context_register(context, &plugin));
  };
}

}  // namespace

Section plugins() {
  const rc_status refused = RC_ERR_PLUGIN;
  return {
      "Plugins",
      {
          {"plugin that is in no directory",
           RC_ERR_NO_BACKEND,
           {"rc_contact_create: backend \"fft\" is not installed: its plugin rcb_fft.so is in no plugin directory (built by "
            "default)",
            "available: "},
           [] { return name_backend(nullptr, RC_CONTEXT_NO_PLUGINS, "fft"); },
           "fft"},
          {"name with a path in it",
           RC_ERR_NO_BACKEND,
           {"backend \"../x\" not found"},
           [] { return name_backend("/tmp", 0, "../x"); }},
          {"file that is world-writable",
           refused,
           {"rc_contact_create: plugin refused: ", "/rcb_spoilt.so is world-writable; chmod o-w it"},
           [] { return plugin_file(0755, 0666); }},
          {"directory that is world-writable",
           refused,
           {"rc_contact_create: plugin refused: ", " is world-writable; chmod o-w it"},
           [] { return plugin_file(0777, 0644); }},
          {"file that is not a shared object",
           refused,
           {"plugin refused: ", "/rcb_spoilt.so is not a shared object of this machine"},
           [] { return plugin_file(0755, 0644); }},
          {"wrong plugin ABI",
           refused,
           {"rc_context_register: plugin \"mine\" (registered) has plugin ABI 99, this library has 1; rebuild it against the "
            "installed headers"},
           registering([](rc_plugin& plugin) { plugin.abi_major = 99; })},
          {"description without a name", refused, {"or it has no name"}, registering([](rc_plugin& plugin) {
             plugin.name = nullptr;
           })},
          {"description with struct_size = 0", refused, {"struct_size 0 is smaller than 64"}, registering([](rc_plugin& plugin) {
             plugin.struct_size = 0;
           })},
          {"list of components that is null", refused, {"a list of components is null"}, registering([](rc_plugin& plugin) {
             plugin.n_solvers = 1;
           })},
      }};
}

}  // namespace errors
