// rc_context_*, the enumeration of components, rc_kernel_coefficients.
#include <algorithm>
#include <string>
#include <vector>

#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/sized_struct.h"
#include "contact/choice.h"
#include "core/usable_cores.h"

namespace {

using namespace rc;

rc_component component(const char* name, const char* summary, const char* license, const char* origin) {
  return {sizeof(rc_component), name, summary, license, origin};
}

void check_index(std::int64_t i, std::size_t count) {
  if (i < 0 || i >= static_cast<std::int64_t>(count))
    fail(RC_ERR_ARGUMENT, "i = ", i, ": there are ", count, ", numbered from 0");
}

template <class List> std::int64_t count_of(const char* where, const List& list) {
  std::int64_t count = 0;
  guard(where, [&] {
    count = static_cast<std::int64_t>(list().size());
    return RC_OK;
  });
  return count;
}

template <class List> rc_status describe(const char* where, const List& list, std::int64_t i, rc_component* out) {
  return guard(where, [&] {
    check_size(out, "rc_component");
    const auto all = list();
    check_index(i, all.size());
    const auto& each = *all[static_cast<std::size_t>(i)];
    write(out, component(each.vtable.name, each.vtable.summary, each.vtable.license, each.origin.c_str()));
    return RC_OK;
  });
}

}  // namespace

extern "C" {

rc_status rc_context_create(const rc_context_config* config, rc_context** out) {
  return guard("rc_context_create", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    ContextConfig copy;
    if (config) {
      const rc_context_config given = read<rc_context_config>(config, "rc_context_config", RC_CONTEXT_CONFIG_INIT);
      if (given.flags & ~static_cast<std::uint32_t>(RC_CONTEXT_NO_PLUGINS | RC_CONTEXT_NO_ENVIRONMENT))
        fail(RC_ERR_ARGUMENT, "rc_context_config.flags = ", given.flags, " has unknown bits");
      check_reserved(given.reserved, "rc_context_config.reserved");
      copy = {given.flags, given.plugin_path ? given.plugin_path : "", given.log, given.log_user};
    }
    *out = new rc_context{std::make_shared<Context>(copy)};
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

int64_t rc_backend_count(rc_context* context) {
  return count_of("rc_backend_count", [&] { return context_of(context)->backends(); });
}
rc_status rc_backend_describe(rc_context* context, int64_t i, rc_component* out) {
  return describe(
      "rc_backend_describe", [&] { return context_of(context)->backends(); }, i, out);
}
int64_t rc_solver_count(rc_context* context) {
  return count_of("rc_solver_count", [&] { return context_of(context)->solvers(); });
}
rc_status rc_solver_describe(rc_context* context, int64_t i, rc_component* out) {
  return describe(
      "rc_solver_describe", [&] { return context_of(context)->solvers(); }, i, out);
}
int64_t rc_kernel_count(rc_context* context) {
  return count_of("rc_kernel_count", [&] { return context_of(context)->kernels(); });
}
rc_status rc_kernel_describe(rc_context* context, int64_t i, rc_component* out) {
  return describe(
      "rc_kernel_describe", [&] { return context_of(context)->kernels(); }, i, out);
}

rc_status rc_pair_supported(rc_context* context, const char* solver, const char* backend, const rc_system* system,
                            int32_t control, const rc_options* options) {
  return guard("rc_pair_supported", [&] {
    if (!solver || !backend) fail(RC_ERR_ARGUMENT, "solver or backend is null");
    if (control != RC_CONTROL_APPROACH && control != RC_CONTROL_LOAD)
      fail(RC_ERR_ARGUMENT, "control = ", control, " is neither 1 nor 2");
    const rc_options given = options ? *options : rc_options{context_of(context), {}};
    const System checked = checked_system(read<rc_system>(system, "rc_system", RC_SYSTEM_INIT), given, false);
    Context& registry = *context_of(context);
    const std::string reason =
        obstacle(registry.solver(solver), registry.backend(backend), checked, control, given.integer(RC_OPT_ALLOW_FALLBACK) != 0);
    if (!reason.empty()) fail(RC_ERR_INCOMPATIBLE, reason);
    return RC_OK;
  });
}

rc_status rc_kernel_coefficients(const char* name, double hx, double hy, int64_t nx, int64_t ny, double* out) {
  return guard("rc_kernel_coefficients", [&] {
    if (!name || !out) fail(RC_ERR_ARGUMENT, "kernel or out is null");
    rc_system system = RC_SYSTEM_INIT;
    system.boundary = RC_BOUNDARY_FREE;
    system.nx = nx;
    system.ny = ny;
    system.hx = hx;
    system.hy = hy;
    system.modulus = 1;
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
