#include "registry/context.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/first_size.h"
#include "platform/libraries.h"
#include "registry/builtin.h"
#include "registry/loader.h"

namespace rc {

Context::Context(const ContextConfig& config) : config_(config), host_(*this) {
  for (const OptionSpec& spec : core_options()) schema_.add(spec);
  for (const rc_plugin_query_fn query : builtin_plugins()) {
    const rc_plugin* plugin = nullptr;
    raise_if_failed(query(&host_, &plugin), "a built-in component");
    add(*plugin, std::string(built_in_origin));
  }
}

const std::shared_ptr<Context>& Context::standard() {
  // Never destroyed: the program's last static destructors may still solve.
  static const auto& context = *new std::shared_ptr<Context>(std::make_shared<Context>(ContextConfig{}));
  return context;
}

void Context::log(std::int32_t level, const std::string& message) const {
  if (config_.log) config_.log(level, message.c_str(), config_.log_user);
}

namespace {

const char* kind_of(const rc_backend&) { return "backend"; }
const char* kind_of(const rc_solver&) { return "solver"; }
const char* kind_of(const rc_kernel&) { return "kernel"; }

// The members that the plugin's header has, the rest null.
template <class Table> Table zero_filled(const Table& table) {
  Table copy{};
  std::memcpy(&copy, &table, std::min(table.struct_size, sizeof copy));
  return copy;
}

// A function and its bit in caps go together.
template <class Vtable> void check_bit(const Vtable& component, std::uint64_t bit, bool present, const char* function) {
  if (((component.caps & bit) != 0) != present)
    fail(RC_ERR_PLUGIN, kind_of(component), " \"", component.name, "\" has ", present ? "" : "no ", function,
         "() but its caps say otherwise");
}

void check_members(const rc_backend& backend, const std::string&) {
  if (!backend.create || !backend.destroy || !backend.bind || !backend.apply || !backend.field || !backend.modelled)
    fail(RC_ERR_PLUGIN, "backend \"", backend.name, "\" lacks one of create, destroy, bind, apply, field, modelled");
  if (!backend.fetch != !backend.store)
    fail(RC_ERR_PLUGIN, "backend \"", backend.name, "\" has one of fetch and store; they go together");
  check_bit(backend, RC_CAP_SUBSET, backend.subset != nullptr, "subset");
  check_bit(backend, RC_CAP_SHIFTED, backend.shifted != nullptr, "shifted");
  check_bit(backend, RC_CAP_NORM, backend.norm != nullptr, "norm");
  check_bit(backend, RC_CAP_FLOAT, backend.apply_float != nullptr, "apply_float");
  check_bit(backend, RC_CAP_SCREEN, backend.screen != nullptr, "screen");
}

void check_members(const rc_solver& solver, const std::string& origin) {
  if (!solver.solve || (solver.controls & RC_CONTROL_APPROACH) == 0)
    fail(RC_ERR_PLUGIN, "solver \"", solver.name, "\" lacks solve or approach control");
  if ((solver.needs & RC_TAKES_ROWS) && origin != built_in_origin)
    fail(RC_ERR_PLUGIN, "solver \"", solver.name, "\" takes rows, which only solvers built into the library can");
}

void check_members(const rc_kernel& kernel, const std::string&) {
  check_bit(kernel, RC_KERNEL_FREE | RC_KERNEL_SEMI_PERIODIC, kernel.window != nullptr, "window");
  check_bit(kernel, RC_KERNEL_PERIODIC, kernel.symbol != nullptr, "symbol");
  if (!kernel.window && !kernel.symbol) fail(RC_ERR_PLUGIN, "kernel \"", kernel.name, "\" lacks window and symbol");
}

// A kernel is chosen when a contact is made, and its values with it.
OptionSpec option_of(const rc_kernel& kernel, const rc_component& given) {
  OptionSpec spec = checked_spec(given, kernel.name);
  spec.fixed = true;
  return spec;
}
template <class Vtable> OptionSpec option_of(const Vtable& component, const rc_component& given) {
  return checked_spec(given, component.name);
}

}  // namespace

template <class Vtable>
const Component<Vtable>* Context::find(const std::deque<Component<Vtable>>& components, std::string_view name) const {
  const auto it = std::find_if(components.begin(), components.end(), [&](const auto& c) { return name == c.vtable.name; });
  return it == components.end() ? nullptr : &*it;
}

template <class Vtable>
void Context::add_component(std::deque<Component<Vtable>>& components, const Vtable* vtable, const std::string& origin) {
  if (!vtable) fail(RC_ERR_PLUGIN, "a component is null");
  if (vtable->struct_size < first_size<Vtable>)
    fail(RC_ERR_PLUGIN, "a ", kind_of(*vtable), " has struct_size ", vtable->struct_size, ", smaller than ", first_size<Vtable>);
  const Vtable copy = zero_filled(*vtable);
  if (!copy.name || !is_component_name(copy.name))
    fail(RC_ERR_PLUGIN, "a component is named \"", copy.name ? copy.name : "",
         "\"; names are [a-z][a-z0-9_-]*, at most 31 characters");
  if (!copy.summary || !copy.license) fail(RC_ERR_PLUGIN, "component \"", copy.name, "\" lacks a summary or a licence");
  if (knows(copy.name)) fail(RC_ERR_PLUGIN, "a component named \"", copy.name, "\" is registered already");
  check_members(copy, origin);
  if (copy.n_options > 0 && !copy.options) fail(RC_ERR_PLUGIN, "component \"", copy.name, "\" has options, but the list is null");
  for (std::int64_t i = 0; i < copy.n_options; ++i) {
    if (!copy.options[i]) fail(RC_ERR_PLUGIN, "component \"", copy.name, "\": option ", i, " is null");
    schema_.add(option_of(copy, *copy.options[i]));
  }
  components.push_back({copy, origin, origin.starts_with('/')});
}

void Context::add(const rc_plugin& given, const std::string& origin) {
  const std::lock_guard lock(mutex_);
  if (given.struct_size < first_size<rc_plugin> || !given.name)
    fail(RC_ERR_PLUGIN, "plugin ", origin, ": struct_size ", given.struct_size, " is smaller than ", first_size<rc_plugin>,
         ", or it has no name");
  if (given.abi_major != RC_PLUGIN_ABI_MAJOR)
    fail(RC_ERR_PLUGIN, "plugin \"", given.name, "\" (", origin, ") has plugin ABI ", given.abi_major, ", this library has ",
         RC_PLUGIN_ABI_MAJOR, "; rebuild it against the installed headers");
  const rc_plugin plugin = zero_filled(given);
  if ((plugin.n_backends > 0 && !plugin.backends) || (plugin.n_solvers > 0 && !plugin.solvers) ||
      (plugin.n_kernels > 0 && !plugin.kernels))
    fail(RC_ERR_PLUGIN, "plugin \"", plugin.name, "\" (", origin, "): a list of components is null");
  // All or nothing.
  const std::size_t backends = backends_.size(), solvers = solvers_.size(), kernels = kernels_.size(), options = schema_.size();
  const auto undo = [&] {
    while (backends_.size() > backends) backends_.pop_back();
    while (solvers_.size() > solvers) solvers_.pop_back();
    while (kernels_.size() > kernels) kernels_.pop_back();
    schema_.shrink(options);
  };
  try {
    for (std::int64_t i = 0; i < plugin.n_backends; ++i) add_component(backends_, plugin.backends[i], origin);
    for (std::int64_t i = 0; i < plugin.n_solvers; ++i) add_component(solvers_, plugin.solvers[i], origin);
    for (std::int64_t i = 0; i < plugin.n_kernels; ++i) add_component(kernels_, plugin.kernels[i], origin);
  } catch (const Error& error) {
    undo();
    fail(error.code(), "plugin \"", plugin.name, "\" (", origin, "): ", error.what());
  } catch (...) {
    undo();
    throw;
  }
}

bool Context::load(const std::string& name) {
  if (std::find(loaded_.begin(), loaded_.end(), name) != loaded_.end()) return true;
  if (config_.flags & RC_CONTEXT_NO_PLUGINS) return false;
  const std::string path = find_plugin(plugin_directories(config_, *this), name);
  if (path.empty()) return false;
  loaded_.reserve(loaded_.size() + 1);
  std::string mark = name;
  add(*load_plugin(path, name, host_), path);
  loaded_.push_back(std::move(mark));
  return true;
}

void Context::open_plugins(std::int64_t points) {
  if (config_.flags & RC_CONTEXT_NO_PLUGINS) return;
  if (!looked_) closed_ = plugin_names(plugin_directories(config_, *this));
  looked_ = true;
  for (std::size_t i = 0; i < closed_.size();) {
    if (auto_opens_from(closed_[i]) > points) {
      ++i;
      continue;
    }
    const auto place = closed_.begin() + static_cast<std::ptrdiff_t>(i);
    std::string name = std::move(*place);
    closed_.erase(place);  // before the log is called, which may enumerate too
    try {
      if (!knows(name)) load(name);
    } catch (const Error& error) {
      refused_[name] = error.what();
      // A plugin that cannot serve on this machine is not a fault.
      log(dynamic_cast<const Refusal*>(&error) ? RC_LOG_INFO : RC_LOG_WARNING, error.what());
    } catch (...) {
      closed_.insert(closed_.begin(), std::move(name));  // there is room for it
      throw;
    }
  }
}

void Context::load_all() {
  if (all_loaded_) return;
  all_loaded_ = true;
  looked_ = false;
  try {
    open_plugins(std::numeric_limits<std::int64_t>::max());
  } catch (...) {
    all_loaded_ = false;
    throw;
  }
}

template <class Vtable>
const Component<Vtable>& Context::get(const std::deque<Component<Vtable>>& components, std::string_view name, rc_status missing,
                                      const char* kind) {
  const std::lock_guard lock(mutex_);
  if (const auto* component = find(components, name)) return *component;
  if (is_component_name(name) && load(std::string(name)))
    if (const auto* component = find(components, name)) return *component;
  load_all();  // its plugin may have another name
  if (const auto* component = find(components, name)) return *component;
  std::vector<std::string> known;
  for (const auto& component : components) known.push_back(component.vtable.name);
  std::sort(known.begin(), known.end());
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  if (const char* hint = known_but_absent(name))
    fail(missing, kind, " \"", name, "\" is not installed: ",
         rc_platform::loads_plugins()
             ? hint
             : "this program is linked statically (-static) and loads no plugins; build the backend into "
               "the library (RC_BUILTIN_BACKENDS)",
         "; available: ", list);
  std::string refused;  // a plugin of which it may be
  for (const auto& [plugin, why] : refused_)
    if (name.find(plugin) != std::string_view::npos) refused = "; " + why;
  fail(missing, kind, " \"", name, "\" not found", refused.empty() ? suggestion(name, known) : refused, "; available: ", list);
}

const rc_backend& Context::backend(std::string_view name) { return get(backends_, name, RC_ERR_NO_BACKEND, "backend").vtable; }
const rc_solver& Context::solver(std::string_view name) { return get(solvers_, name, RC_ERR_NO_SOLVER, "solver").vtable; }
const Component<rc_kernel>& Context::kernel(std::string_view name) { return get(kernels_, name, RC_ERR_OPTION, "kernel"); }

namespace {

template <class Vtable> std::vector<const Component<Vtable>*> sorted(const std::deque<Component<Vtable>>& components) {
  std::vector<const Component<Vtable>*> result;
  for (const auto& component : components) result.push_back(&component);
  std::sort(result.begin(), result.end(),
            [](const auto* a, const auto* b) { return std::strcmp(a->vtable.name, b->vtable.name) < 0; });
  return result;
}

}  // namespace

std::vector<const Component<rc_backend>*> Context::backends() {
  const std::lock_guard lock(mutex_);
  load_all();
  return sorted(backends_);
}

template <class Vtable>
std::vector<const Component<Vtable>*> Context::for_auto(const std::deque<Component<Vtable>>& components, std::int64_t points) {
  const std::lock_guard lock(mutex_);
  if (points > 0) open_plugins(points);
  auto all = sorted(components);
  std::erase_if(all,
                [&](const auto* each) { return each->plugin && (points == 0 || auto_opens_from(each->vtable.name) > points); });
  return all;
}
template std::vector<const Component<rc_backend>*> Context::for_auto(const std::deque<Component<rc_backend>>&, std::int64_t);
template std::vector<const Component<rc_solver>*> Context::for_auto(const std::deque<Component<rc_solver>>&, std::int64_t);

std::vector<const Component<rc_solver>*> Context::solvers() {
  const std::lock_guard lock(mutex_);
  load_all();
  return sorted(solvers_);
}

std::vector<const Component<rc_kernel>*> Context::kernels() {
  const std::lock_guard lock(mutex_);
  load_all();
  return sorted(kernels_);
}

const OptionSpec& Context::option(std::string_view key) {
  const std::lock_guard lock(mutex_);
  if (const OptionSpec* spec = schema_.find(key)) return *spec;
  if (const size_t dot = key.find('.'); dot != std::string_view::npos && is_component_name(key.substr(0, dot))) {
    load(std::string(key.substr(0, dot)));
    if (const OptionSpec* spec = schema_.find(key)) return *spec;
  }
  load_all();
  if (const OptionSpec* spec = schema_.find(key)) return *spec;
  fail(RC_ERR_OPTION, "option \"", key, "\" is unknown", suggestion(key, schema_.keys()));
}

std::vector<const OptionSpec*> Context::options() {
  const std::lock_guard lock(mutex_);
  load_all();
  return known_options();
}

std::vector<const OptionSpec*> Context::known_options() const {
  const std::lock_guard lock(mutex_);
  std::vector<const OptionSpec*> result;
  for (size_t i = 0; i < schema_.size(); ++i) result.push_back(&schema_[i]);
  return result;
}

}  // namespace rc
