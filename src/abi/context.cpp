// rc_context_*, rc_component_*, rc_pair_supported, rc_kernel_coefficients.
#include <algorithm>
#include <string>
#include <vector>

#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/sized_struct.h"
#include "abi/steps.h"
#include "contact/calls/controls.h"
#include "contact/choice.h"
#include "core/usable_cores.h"

namespace {

using namespace rc;

template <class Vtable> rc_component described(const Component<Vtable>& each) {
  const Vtable& of = each.vtable;
  return {.struct_size = sizeof(rc_component),
          .name = of.name,
          .summary = of.summary,
          .license = of.license,
          .origin = each.origin.c_str()};
}

rc_component described(const OptionSpec& option) {
  return {.struct_size = sizeof(rc_component),
          .name = option.key.c_str(),
          .summary = option.help.c_str(),
          .license = "",
          .origin = "",
          .default_value = option.default_value.c_str(),
          .choices = option.choices.empty() ? nullptr : option.choices_text.c_str(),
          .type = option.type,
          .fixed = option.fixed,
          .minimum = option.minimum,
          .maximum = option.maximum};
}

// Calls body with the list of a kind, of pointers that last as long as the context.
template <class Body> void with_list(rc_context* handle, std::int32_t kind, const Body& body) {
  Context& context = *context_of(handle);
  switch (kind) {
    case RC_COMPONENT_SOLVER:
      return body(context.solvers());
    case RC_COMPONENT_BACKEND:
      return body(context.backends());
    case RC_COMPONENT_KERNEL:
      return body(context.kernels());
    case RC_COMPONENT_OPTION:
      return body(context.options());
    default:
      fail(RC_ERR_ARGUMENT, "kind = ", kind,
           " is none of RC_COMPONENT_SOLVER (1), RC_COMPONENT_BACKEND (2), RC_COMPONENT_KERNEL (3), RC_COMPONENT_OPTION (4)");
  }
}

}  // namespace

extern "C" {

rc_status rc_context_create(uint32_t flags, const char* plugin_path, rc_log_fn log, void* log_user, rc_context** out) {
  return guard("rc_context_create", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    if (flags & ~static_cast<std::uint32_t>(RC_CONTEXT_NO_PLUGINS | RC_CONTEXT_NO_ENVIRONMENT))
      fail(RC_ERR_ARGUMENT, "flags = ", flags,
           " has unknown bits; there are RC_CONTEXT_NO_PLUGINS (1) and RC_CONTEXT_NO_ENVIRONMENT (2)");
    *out = new rc_context{std::make_shared<Context>(ContextConfig{flags, plugin_path ? plugin_path : "", log, log_user})};
    return RC_OK;
  });
}

void rc_context_destroy(rc_context* context) {
  const HostsCall call;
  delete context;
}

int64_t rc_usable_cores(int64_t allowed) {
  int64_t cores = 1;
  guard("rc_usable_cores", [&] {
    cores = usable_cores(allowed);
    return RC_OK;
  });
  return cores;
}

rc_status rc_context_register(rc_context* context, const rc_plugin* plugin) {
  return guard("rc_context_register", [&] {
    if (!plugin) fail(RC_ERR_ARGUMENT, "plugin is null");
    context_of(context)->add(*plugin, "registered");
    return RC_OK;
  });
}

int64_t rc_component_count(rc_context* context, int32_t kind) {
  int64_t count = 0;
  guard("rc_component_count", [&] {
    with_list(context, kind, [&](const auto& list) { count = static_cast<int64_t>(list.size()); });
    return RC_OK;
  });
  return count;
}

rc_status rc_component_describe(rc_context* context, int32_t kind, int64_t i, rc_component* out) {
  return guard("rc_component_describe", [&] {
    check_size(out, "rc_component");
    with_list(context, kind, [&](const auto& list) {
      if (i < 0 || i >= static_cast<int64_t>(list.size()))
        fail(RC_ERR_ARGUMENT, "i = ", i, ": there are ", list.size(), ", numbered from 0");
      write(out, described(*list[static_cast<std::size_t>(i)]));
    });
    return RC_OK;
  });
}

rc_status rc_pair_supported(rc_context* context, const char* solver, const char* backend, const rc_system* system,
                            int32_t control, const rc_options* options) {
  return guard("rc_pair_supported", [&] {
    if (!solver || !backend) fail(RC_ERR_ARGUMENT, "solver or backend is null");
    check_control(control, "control");
    const std::int32_t solved = control == RC_CONTROL_APPROACH ? RC_CONTROL_APPROACH : RC_CONTROL_LOAD;
    const rc_options given = options ? *options : rc_options{context_of(context), {}};
    const System checked = checked_system(read_system(system), given, false);
    Context& registry = *context_of(context);
    const std::string reason =
        obstacle(registry.solver(solver), registry.backend(backend), checked, solved, given.integer(RC_OPT_ALLOW_FALLBACK) != 0);
    if (!reason.empty()) fail(RC_ERR_INCOMPATIBLE, reason);
    return RC_OK;
  });
}

rc_status rc_kernel_coefficients(const char* name, double hx, double hy, int64_t nx, int64_t ny, double* out) {
  return guard("rc_kernel_coefficients", [&] {
    if (!name || !out) fail(RC_ERR_ARGUMENT, "kernel or out is null");
    const rc_system system = free_half_space(nx, ny, hx, hy, 1);
    rc_options options{context_of(nullptr), {}};
    options.set(RC_OPT_KERNEL, name);
    const System checked = checked_system(system, options, false);
    const SystemKernel kernel(options.context->kernel(checked.kernel.name), options, 1, 1);
    // out stays as it is where a value is refused.
    std::vector<double> values(kernel.built_in() ? 0 : static_cast<std::size_t>(nx * ny));
    kernel.coefficients(system, nx, ny, values.empty() ? out : values.data());
    std::copy(values.begin(), values.end(), out);
    return RC_OK;
  });
}

}  // extern "C"
