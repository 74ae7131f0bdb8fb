// Cases that need no plugin to be built for them; the others are in tests/contract/plugins.
#include <roughcontact/plugin.h>

#include <cstring>
#include <string>

#include "calls.h"
#include "support/decay.h"

namespace errors {

namespace {

ContextHandle new_context(std::uint32_t flags = 0, const char* plugin_path = nullptr) {
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(flags, plugin_path, nullptr, nullptr, &context), RC_OK);
  return ContextHandle(context);
}

rc_status create_in(const char* plugin_path, std::uint32_t flags, const char* backend) {
  const ContextHandle context = new_context(flags, plugin_path);
  World world;
  world.set(std::string("options.backend=") + backend);
  return create(world.scene, world.options_of(context.get()).get());
}

// Registers a kernel "mine", and solves with it: on one backend, or on all that look at the whole table.
Outcome solve_with_kernel(World& w) {
  const Memory& m = w.memory;
  support::Decay decay{m.at_x, m.at_y, m.value, 1, m.lowest, m.share};
  rc_kernel kernel = support::decay_kernel("mine", decay);
  kernel.caps = m.caps;
  const rc_kernel* const kernels[] = {&kernel};
  rc_plugin plugin = w.memory.plugin;
  plugin.n_kernels = 1;
  plugin.kernels = kernels;
  const ContextHandle context = new_context();
  if (const rc_status status = rc_context_register(context.get(), &plugin); status != RC_OK) return status;
  w.set("options.kernel=mine");
  const OptionsHandle options = w.options_of(context.get());
  const auto with = [&](const char* backend) {
    assert_int_equal(rc_options_set_text(options.get(), RC_OPT_BACKEND, backend), RC_OK);
    return Outcome(solve(w.scene, options.get()));
  };
  if (std::strcmp(w.memory.backend, "callback") != 0) return with(w.memory.backend);
  for (const char* backend : {"dense", "fft"}) {
    const rc_status status = with(backend).status;
    assert_true(status == RC_ERR_NUMERIC || status == RC_ERR_NO_BACKEND);
  }
  return with("auto");
}

}  // namespace

Calls plugin_calls() {
  return {
      {"create_in",
       [](World& w) { return create_in(w.memory.text, static_cast<std::uint32_t>(w.memory.flags), w.memory.backend); }},
      {"register", [](World& w) { return rc_context_register(new_context().get(), &w.memory.plugin); }},
      {"solve_with_kernel", solve_with_kernel},
  };
}

}  // namespace errors
