// Cases that need no plugin to be built for them; the others are in tests/contract/plugins.
#include <roughcontact/plugin.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "case.h"
#include "scene.h"
#include "support/system.h"

namespace errors {

namespace {

namespace fs = std::filesystem;

rc_status name_backend(const char* plugin_path, std::uint32_t flags, const char* backend) {
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(flags, plugin_path, nullptr, nullptr, &context), RC_OK);
  const ContextHandle keep(context);
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context, &options), RC_OK);
  const OptionsHandle keep_options(options);
  assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, backend), RC_OK);
  return create(Scene(), options);
}

// A directory with one file, rcb_spoilt, that is not a plugin.
Outcome plugin_file(bool open_directory, bool open_file) {
  static std::random_device number;
  const fs::path directory = fs::current_path() / ("errors-" + std::to_string(number()));
  const fs::path path = directory / "rcb_spoilt" RC_PLUGIN_SUFFIX;
  fs::create_directory(directory);
  std::ofstream(path) << "not a shared object";
  (open_file ? support::let_everybody_write : support::let_owner_alone_write)(path.string());
  (open_directory ? support::let_everybody_write : support::let_owner_alone_write)(directory.string());
  const Outcome outcome = name_backend(directory.string().c_str(), RC_CONTEXT_NO_ENVIRONMENT, "spoilt");
  fs::remove_all(directory);
  return outcome;
}

template <class Change> auto registering(const Change& change) {
  return [change] {
    rc_plugin plugin = {
        sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "mine", "1.0", 0, 0, 0, nullptr, nullptr, nullptr};
    change(plugin);
    rc_context* context = nullptr;
    assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
    const ContextHandle keep(context);
    return Outcome(rc_context_register(context, &plugin));
  };
}

// A kernel of deflections that decay with distance, one value of which is spoilt.
struct Spoilt {
  std::int64_t x, y;
  double value, lowest;
};
const Spoilt& of(const rc_kernel_spec* spec) { return *static_cast<const Spoilt*>(spec->kernel->user); }

rc_status decay_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                       std::int64_t my, double* out) {
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = ix == of(spec).x && iy == of(spec).y ? of(spec).value
                                                    : std::exp(-std::hypot(static_cast<double>(ix), static_cast<double>(iy)));
  return RC_OK;
}

rc_status decay_symbol(const rc_host*, const rc_kernel_spec* spec, double* out) {
  for (std::int64_t ky = 0; ky <= spec->system->ny / 2; ++ky)
    for (std::int64_t kx = 0; kx <= spec->system->nx / 2; ++kx)
      *out++ = kx == of(spec).x && ky == of(spec).y ? of(spec).value : 1 / (1.0 + static_cast<double>(kx * kx + ky * ky));
  return RC_OK;
}

rc_status decay_bounds(const rc_host*, const rc_kernel_spec* spec, double* lowest, double*) {
  *lowest = of(spec).lowest;
  return RC_OK;
}

template <class Use> Outcome with_kernel(const Use& use, Spoilt spoilt, std::uint64_t caps) {
  const rc_kernel kernel = {.struct_size = sizeof(rc_kernel),
                            .name = "mine",
                            .summary = "a test's",
                            .license = "BSD-3-Clause",
                            .caps = caps,
                            .window = decay_window,
                            .symbol = decay_symbol,
                            .bounds = decay_bounds,
                            .user = &spoilt};
  const rc_kernel* const kernels[] = {&kernel};
  const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                            .abi_major = RC_PLUGIN_ABI_MAJOR,
                            .abi_minor = RC_PLUGIN_ABI_MINOR,
                            .name = "mine",
                            .version = "1.0",
                            .n_kernels = 1,
                            .kernels = kernels};
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
  const ContextHandle keep(context);
  if (const rc_status status = rc_context_register(context, &plugin); status != RC_OK) return status;
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context, &options), RC_OK);
  const OptionsHandle keep_options(options);
  assert_int_equal(rc_options_set_text(options, RC_OPT_KERNEL, "mine"), RC_OK);
  return use(options);
}

constexpr std::uint64_t sound = RC_KERNEL_FREE | RC_KERNEL_PERIODIC | RC_KERNEL_POSITIVE;

auto solving(Spoilt spoilt, const Scene& scene = Scene(), const char* backend = "auto") {
  return [spoilt, scene, backend] {
    return with_kernel(
        [&](rc_options* options) {
          assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, backend), RC_OK);
          return Outcome(solve(scene, options));
        },
        spoilt, sound);
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
           {"rc_contact_create: backend \"fft\" is not installed: its plugin rcb_fft" RC_PLUGIN_SUFFIX
            " is in no plugin directory (built by "
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
           {"rc_contact_create: plugin refused: ", "/rcb_spoilt" RC_PLUGIN_SUFFIX, support::writable_to_all},
           [] { return plugin_file(false, true); }},
          {"directory that is world-writable",
           refused,
           {"rc_contact_create: plugin refused: ", support::writable_to_all},
           [] { return plugin_file(true, false); }},
          {"file that is not a shared object",
           refused,
           {"plugin refused: ", "/rcb_spoilt" RC_PLUGIN_SUFFIX " is not a shared object of this machine"},
           [] { return plugin_file(false, false); }},
          {"wrong plugin ABI",
           refused,
           {"rc_context_register: plugin \"mine\" (registered) has plugin ABI 99, this library has 1; rebuild it against the "
            "installed headers"},
           registering([](rc_plugin& plugin) { plugin.abi_major = 99; })},
          {"description without a name", refused, {"or it has no name"}, registering([](rc_plugin& plugin) {
             plugin.name = nullptr;
           })},
          {"description with struct_size = 0", refused, {"struct_size 0 is smaller than "}, registering([](rc_plugin& plugin) {
             plugin.struct_size = 0;
           })},
          {"kernel without the function that its caps name",
           refused,
           {"plugin \"mine\" (registered): kernel \"mine\" has symbol() but its caps say otherwise"},
           [] {
             return with_kernel([](rc_options*) { return Outcome(RC_OK); }, {-1, -1, 0, 0}, RC_KERNEL_FREE);
           }},
          {"kernel with a coefficient that is not finite",
           RC_ERR_NUMERIC,
           {"rc_solve: kernel \"mine\": the coefficient at offset (2, 1) is nan, must be finite"},
           solving({2, 1, nan, 0})},
          {"kernel that deflects another cell more than its own",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": the coefficient at offset (1, 0) is 2, beyond that at (0, 0), 1: H is not positive definite"},
           solving({1, 0, 2, 0})},
          {"kernel that does not deflect its own cell",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": the coefficient at offset (0, 0) is 0, must be positive"},
           solving({0, 0, 0, 0})},
          {"kernel with a negative coefficient against its promise",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": the coefficient at offset (3, 3) is -0.01, although none is promised to be negative"},
           solving({3, 3, -0.01, 0})},
          {"kernel that is not positive definite",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": H is not positive definite: x'Hx / x'x is -", " on 8 x 8 cells"},
           solving({1, 0, 0.999, 0})},
          {"kernel with an eigenvalue below its promise",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": an eigenvalue is at most ", ", although none is promised to be below 0.7"},
           solving({-1, -1, 0, 0.7})},
          {"kernel that promises no number",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": a promised bound is nan, must be finite and >= 0 (0: none)"},
           solving({-1, -1, 0, nan})},
          {"periodic kernel with a negative eigenvalue",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": the symbol at wave numbers (2, 1) is -0.5, must be >= 0 and finite"},
           solving({2, 1, -0.5, 0}, periodic_scene())},
          {"periodic kernel with an eigenvalue below its promise",
           RC_ERR_NUMERIC,
           {"kernel \"mine\": an eigenvalue is 0.1", ", although none is promised to be below 0.5"},
           solving({-1, -1, 0, 0.5}, periodic_scene())},
          {"backend that needs the half-space's far field",
           RC_ERR_INCOMPATIBLE,
           {"backend \"split\" cannot do kernel \"mine\", whose far field is not that of the half-space"},
           solving({-1, -1, 0, 0}, Scene(), "split"),
           "split"},
          {"list of components that is null", refused, {"a list of components is null"}, registering([](rc_plugin& plugin) {
             plugin.n_solvers = 1;
           })},
      }};
}

}  // namespace errors
