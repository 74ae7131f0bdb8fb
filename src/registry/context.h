// The registry: backends, solvers and kernels known to a context, whether linked in, registered by the host program or loaded
// from disk.
#pragma once

#include <roughcontact/plugin.h>

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/options.h"
#include "registry/shared_objects.h"

namespace rc {

class Context;
class SystemKernel;

// The services handed to components: rc_host's functions find their context behind it, and the kernel of the system that a
// component works for.
struct Host : rc_host {
  // identity: the same text for systems whose components may share objects.
  explicit Host(const Context& context, const SystemKernel* kernel = nullptr, std::string identity = "");
  const Context* context;
  const SystemKernel* kernel;
  const std::string identity;

  // The shared objects that its components use.
  struct Holdings {
    std::mutex mutex;
    std::multimap<void*, std::shared_ptr<void>> objects;
    std::set<std::shared_ptr<void>> kept;  // until the host ends
  };
  const std::unique_ptr<Holdings> holdings = std::make_unique<Holdings>();
};

inline constexpr std::string_view built_in_origin = "built-in";

template <class Vtable> struct Component {
  Vtable vtable;  // members that an older plugin lacks are null
  std::string origin;
  bool plugin;  // from a file

  bool built_in() const { return origin == built_in_origin; }
};

struct ContextConfig {
  std::uint32_t flags = 0;
  std::string plugin_path;
  rc_log_fn log = nullptr;
  void* log_user = nullptr;
};

// Shared between threads; components are added under a lock and never move or go away.
class Context {
 public:
  explicit Context(const ContextConfig& config);
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The context behind null arguments, made at first use.
  static const std::shared_ptr<Context>& standard();

  void add(const rc_plugin& plugin, const std::string& origin);

  // By exact name, loading rcb_<name>.so if needed. Throw Error(NO_BACKEND, NO_SOLVER, OPTION, PLUGIN).
  const rc_backend& backend(std::string_view name);
  const rc_solver& solver(std::string_view name);
  const Component<rc_kernel>& kernel(std::string_view name);

  // Everything that can be found, sorted by name; refused files are logged.
  std::vector<const Component<rc_backend>*> backends();
  std::vector<const Component<rc_solver>*> solvers();
  std::vector<const Component<rc_kernel>*> kernels();
  // The components among which "auto" chooses on a grid of this many points, sorted by name: built-in ones, and those of plugins
  // that it opens for such grids; points = 0: only built-in ones. The list does not depend on plugins opened before.
  std::vector<const Component<rc_backend>*> backends_for_auto(std::int64_t points) { return for_auto(backends_, points); }
  std::vector<const Component<rc_solver>*> solvers_for_auto(std::int64_t points) { return for_auto(solvers_, points); }

  // The objects that its contacts share.
  SharedObjects& shared() const { return shared_; }

  // Throws Error(RC_ERR_OPTION) with the nearest key. A dotted key loads its component.
  const OptionSpec& option(std::string_view key);
  std::vector<const OptionSpec*> options();
  std::vector<const OptionSpec*> known_options() const;  // of the core and of components that are loaded

  const Host& host() const { return host_; }
  void log(std::int32_t level, const std::string& message) const;

 private:
  template <class Vtable>
  const Component<Vtable>* find(const std::deque<Component<Vtable>>& components, std::string_view name) const;
  bool knows(std::string_view name) const { return find(backends_, name) || find(solvers_, name) || find(kernels_, name); }
  template <class Vtable>
  void add_component(std::deque<Component<Vtable>>& components, const Vtable* vtable, const std::string& origin);
  template <class Vtable>
  const Component<Vtable>& get(const std::deque<Component<Vtable>>& components, std::string_view name, rc_status missing,
                               const char* kind);
  template <class Vtable>
  std::vector<const Component<Vtable>*> for_auto(const std::deque<Component<Vtable>>& components, std::int64_t points);
  bool load(const std::string& name);      // true if a file of that name was loaded now or before
  void open_plugins(std::int64_t points);  // that "auto" opens there
  void load_all();

  const ContextConfig config_;
  mutable SharedObjects shared_;
  Host host_;
  mutable std::recursive_mutex mutex_;
  std::deque<Component<rc_backend>> backends_;
  std::deque<Component<rc_solver>> solvers_;
  std::deque<Component<rc_kernel>> kernels_;
  std::vector<std::string> loaded_;
  Schema schema_;
  std::vector<std::string> closed_;             // names of plugins that "auto" has not tried to open
  std::map<std::string, std::string> refused_;  // plugins, and why
  bool looked_ = false, all_loaded_ = false;
};

}  // namespace rc
