// The kernel "graded": a half-space whose modulus grows with depth, E(z) = E (z/L)^k, 0 <= k < 1.
//
// A pressure wave exp(i q.x) deflects it by 2/(E* |q|) (|q| L')^k times itself, L' = L times a number that depends on k and on
// Poisson's ratio: Booker, Balaam & Davis, International Journal for Numerical and Analytical Methods in Geomechanics 9 (1985)
// 353. The option graded.length is L': short waves feel the soft surface, waves longer than 2 pi L' the stiffer depth.
#include <cmath>
#include <numbers>
#include <roughcontact/plugin.hpp>

namespace {

constexpr roughcontact::Component component{"graded", "use fewer points"};

rc_status symbol(const rc_host* host, const rc_kernel_spec* spec, double* out) {
  return roughcontact::guard(host, component, [&] {
    // In the units of the system: a length is 1 there where it is spec->length for the caller.
    const double length = roughcontact::option_real(host, spec->options, "graded.length") / spec->length;
    const double exponent = roughcontact::option_real(host, spec->options, "graded.exponent");
    if (!(length > 0)) roughcontact::fail(component, RC_ERR_ARGUMENT, "graded.length = ", length, ": must be positive");
    const rc_system& s = *spec->system;
    const double step_x = 2 * std::numbers::pi / (static_cast<double>(s.nx) * s.hx),
                 step_y = 2 * std::numbers::pi / (static_cast<double>(s.ny) * s.hy);
    for (std::int64_t ky = 0; ky <= s.ny / 2; ++ky)
      for (std::int64_t kx = 0; kx <= s.nx / 2; ++kx) {
        const double q = std::hypot(step_x * static_cast<double>(kx), step_y * static_cast<double>(ky));
        *out++ = q > 0 ? 2 / q * std::pow(q * length, exponent) : 0;
      }
  });
}

constexpr rc_component length = roughcontact::real_option(
                           "graded.length", "0", 0, 1e30,
                           "1/|q| of the waves that a half-space of modulus E* deflects as much [length]"),
                       exponent = roughcontact::real_option("graded.exponent", "0.5", 0, 0.99,
                                                            "power of the depth by which the modulus grows");
constexpr const rc_component* options[] = {&length, &exponent};

const rc_kernel kernel = {.struct_size = sizeof(rc_kernel),
                          .name = "graded",
                          .summary = "half-space whose modulus grows with a power of the depth; exact for every wave",
                          .license = "BSD-3-Clause",
                          .caps = RC_KERNEL_PERIODIC,
                          .n_options = 2,
                          .options = options,
                          .symbol = symbol};
const rc_kernel* const kernels[] = {&kernel};
const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                          .abi_major = RC_PLUGIN_ABI_MAJOR,
                          .abi_minor = RC_PLUGIN_ABI_MINOR,
                          .name = "graded",
                          .version = "1.0",
                          .n_kernels = 1,
                          .kernels = kernels};

}  // namespace

RC_PLUGIN_ENTRY(graded, , out) {
  *out = &plugin;
  return RC_OK;
}
