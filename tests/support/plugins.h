// Components of a test's own, each registered as a plugin of one.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <numeric>
#include <vector>

namespace support {

inline rc_plugin plugin_of_none() {
  rc_plugin plugin{};
  plugin.struct_size = sizeof plugin;
  plugin.abi_major = RC_PLUGIN_ABI_MAJOR;
  plugin.abi_minor = RC_PLUGIN_ABI_MINOR;
  plugin.name = "tests";
  plugin.version = "1.0";
  return plugin;
}

// The component must outlive the context.
template <class Component>
rc_status add_one(rc_context* context, const Component& one, std::int64_t rc_plugin::*count,
                  const Component* const* rc_plugin::*components) {
  const Component* const list[] = {&one};
  rc_plugin plugin = plugin_of_none();
  plugin.*count = 1;
  plugin.*components = list;
  return rc_context_register(context, &plugin);
}
inline rc_status add(rc_context* context, const rc_backend& one) {
  return add_one(context, one, &rc_plugin::n_backends, &rc_plugin::backends);
}
inline rc_status add(rc_context* context, const rc_solver& one) {
  return add_one(context, one, &rc_plugin::n_solvers, &rc_plugin::solvers);
}
inline rc_status add(rc_context* context, const rc_kernel& one) {
  return add_one(context, one, &rc_plugin::n_kernels, &rc_plugin::kernels);
}

// A solver or kernel: its name, and nothing but what every component has.
template <class Component> Component component(const char* name) {
  Component made{};
  made.struct_size = sizeof made;
  made.name = name;
  made.summary = "a test's";
  made.license = "BSD-3-Clause";
  return made;
}
inline rc_solver solver(const char* name, decltype(rc_solver::solve) solve, std::uint32_t controls = RC_CONTROL_APPROACH) {
  rc_solver made = component<rc_solver>(name);
  made.controls = controls;
  made.solve = solve;
  return made;
}

// Has another solver solve all.
inline rc_status inner_solve(const rc_problem* problem, const char* solver, double* p) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(problem->n));
  std::iota(all.begin(), all.end(), 0);
  return problem->inner(problem, solver, problem->n, all.data(), problem->tol, p, nullptr);
}

}  // namespace support
