// The library's kernels as components.
#include <roughcontact/plugin.h>

#include <algorithm>
#include <array>

#include "kernel/kernels.h"
#include "kernel/layer/component.h"
#include "kernel/lowest_eigenvalue.h"
#include "kernel/semi_periodic.h"

namespace rc::kernel {

namespace {

const Kernel& kernel_of(const rc_kernel_spec& spec) { return *static_cast<const Kernel*>(spec.kernel->user); }

rc_status window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                 std::int64_t my, double* out) {
  const rc_system& s = *spec->system;
  const Window window{first_x, first_y, mx, my};
  if (!semi_periodic(s.boundary)) {
    window_coefficients(kernel_of(*spec), s.hx, s.hy, window, out);
    return RC_OK;
  }
  semi_periodic_coefficients(kernel_of(*spec), s, window, out);
  return RC_OK;
}

rc_status waves(const rc_host*, const rc_kernel_spec* spec, double* out) {
  const rc_system& s = *spec->system;
  symbol(kernel_of(*spec), s.hx, s.hy, s.nx, s.ny, out);
  return RC_OK;
}

rc_status bounds(const rc_host*, const rc_kernel_spec* spec, double* lowest, double* galerkin_share) {
  const rc_system& s = *spec->system;
  const Kernel& kernel = kernel_of(*spec);
  if (semi_periodic(s.boundary)) {
    *lowest = lowest_eigenvalue(kernel, strip_of(s));
    *galerkin_share = share_of_galerkin(strip_of(s));
  } else if (kernel.boundary == Boundary::periodic) {
    *lowest = lowest_wave_eigenvalue(kernel, s.hx, s.hy, s.nx, s.ny);
  } else {
    *lowest = lowest_eigenvalue(kernel, s.hx, s.hy);
    *galerkin_share = share_of_galerkin(kernel);
  }
  return RC_OK;
}

constexpr rc_kernel component(const Kernel& kernel) {
  const bool free = kernel.boundary == Boundary::free;
  return {.struct_size = sizeof(rc_kernel),
          .name = kernel.name,
          .summary = kernel.summary,
          .license = "",
          .caps = RC_KERNEL_HOMOGENEOUS |
                  (free ? RC_KERNEL_FREE | RC_KERNEL_POSITIVE | RC_KERNEL_FAR_FIELD : RC_KERNEL_PERIODIC) |
                  (kernel.square_cells ? RC_KERNEL_SQUARE : 0) | (kernel.semi_periodic ? RC_KERNEL_SEMI_PERIODIC : 0),
          .n_options = 0,
          .options = nullptr,
          .window = free || kernel.semi_periodic ? window : nullptr,
          .symbol = free ? nullptr : waves,
          .bounds = bounds,
          .user = const_cast<Kernel*>(&kernel)};
}

constexpr auto components = [] {
  std::array<rc_kernel, kernels.size()> made;
  std::transform(kernels.begin(), kernels.end(), made.begin(), component);
  return made;
}();
constexpr auto entries = [] {
  std::array<const rc_kernel*, components.size() + 1> made{};
  std::transform(components.begin(), components.end(), made.begin(), [](const rc_kernel& each) { return &each; });
  made.back() = &layer::component;
  return made;
}();

}  // namespace

}  // namespace rc::kernel

extern "C" rc_status rc_builtin_kernels(const rc_host*, const rc_plugin** out) {
  using namespace rc::kernel;
  static const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                                   .abi_major = RC_PLUGIN_ABI_MAJOR,
                                   .abi_minor = RC_PLUGIN_ABI_MINOR,
                                   .name = "kernels",
                                   .version = "0.1.0",
                                   .n_kernels = static_cast<std::int64_t>(entries.size()),
                                   .kernels = entries.data()};
  *out = &plugin;
  return RC_OK;
}
