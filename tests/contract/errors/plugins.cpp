// Cases that need no plugin to be built for them; the others are in tests/contract/plugins.
#include <roughcontact/plugin.h>

#include <cmath>
#include <cstring>
#include <string>

#include "calls.h"

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

// A kernel of deflections that decay with distance, one value of which is spoilt.
const Memory& of(const rc_kernel_spec* spec) { return *static_cast<const Memory*>(spec->kernel->user); }

rc_status decay_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                       std::int64_t my, double* out) {
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = ix == of(spec).at_x && iy == of(spec).at_y
                   ? of(spec).value
                   : std::exp(-std::hypot(static_cast<double>(ix), static_cast<double>(iy)));
  return RC_OK;
}

rc_status decay_symbol(const rc_host*, const rc_kernel_spec* spec, double* out) {
  for (std::int64_t ky = 0; ky <= spec->system->ny / 2; ++ky)
    for (std::int64_t kx = 0; kx <= spec->system->nx / 2; ++kx)
      *out++ = kx == of(spec).at_x && ky == of(spec).at_y ? of(spec).value : 1 / (1.0 + static_cast<double>(kx * kx + ky * ky));
  return RC_OK;
}

rc_status decay_bounds(const rc_host*, const rc_kernel_spec* spec, double* lowest, double* share) {
  *lowest = of(spec).lowest;
  *share = of(spec).share;
  return RC_OK;
}

// Registers a kernel "mine", and solves with it: on one backend, or on all that look at the whole table.
Outcome solve_with_kernel(World& w) {
  const rc_kernel kernel = {.struct_size = sizeof(rc_kernel),
                            .name = "mine",
                            .summary = "a test's",
                            .license = "BSD-3-Clause",
                            .caps = w.memory.caps,
                            .window = decay_window,
                            .symbol = decay_symbol,
                            .bounds = decay_bounds,
                            .user = &w.memory};
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
