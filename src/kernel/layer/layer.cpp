// The kernel "layer": an elastic layer on a half-space or on a rigid base, under normal pressure without shear. Uniform pressure
// on a cell, mean deflection of the receiving cell, as in the kernel galerkin.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <roughcontact/plugin.hpp>
#include <string_view>

#include "kernel/kernels.h"
#include "kernel/layer/component.h"
#include "kernel/layer/remainder.h"
#include "kernel/layer/response.h"

namespace rc::kernel::layer {

namespace {

constexpr roughcontact::Component own{"layer", "use fewer points"};

// Coefficients are differences of what the layer's material and the remainder deflect: beyond these limits digits are lost.
constexpr double thinnest = 1e-9, thinnest_on_rigid = 1e-4, thickest = 1e9;  // in cells
constexpr double most_unlike = 1e6;                                          // ratio of the moduli

Layer layer_of(const rc_host* host, const rc_kernel_spec& spec) {
  const auto number = [&](const char* key) { return roughcontact::option_real(host, spec.options, key); };
  const auto is = [&](const char* key, std::string_view choice) {
    return roughcontact::option_text(host, spec.options, key) == choice;
  };
  const double modulus = number("layer.modulus"), thickness = number("layer.thickness");
  if (!(thickness > 0))
    roughcontact::fail(own, RC_ERR_ARGUMENT, "layer.thickness = ", thickness,
                       ": must be positive; without a layer use another kernel");
  Layer layer;
  layer.thickness = thickness / spec.length;
  layer.modulus = modulus > 0 ? modulus / spec.modulus : 1;
  layer.poisson = number("layer.poisson");
  layer.base_poisson = number("layer.substrate_poisson");
  layer.rigid_base = is("layer.base", "rigid");
  layer.bonded = is("layer.interface", "bonded");
  const double least = layer.rigid_base ? thinnest_on_rigid : thinnest;
  if (!(layer.thickness >= least && layer.thickness <= thickest))
    roughcontact::fail(own, RC_ERR_ARGUMENT, "layer.thickness = ", thickness, " is ", layer.thickness, " cells, must be ", least,
                       " .. ", thickest);
  if (!(layer.modulus >= 1 / most_unlike && layer.modulus <= most_unlike))
    roughcontact::fail(own, RC_ERR_ARGUMENT, "layer.modulus = ", modulus, " is ", layer.modulus,
                       " times the modulus of the system, must be ", 1 / most_unlike, " .. ", most_unlike);
  return layer;
}

rc_status window(const rc_host* host, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                 std::int64_t my, double* out) {
  return roughcontact::guard(host, own, [&] {
    const double hx = spec->system->hx, hy = spec->system->hy;
    const Response response(layer_of(host, *spec));
    const Remainder remainder(response, hx, hy,
                              std::hypot(hx * static_cast<double>(first_x + mx), hy * static_cast<double>(first_y + my)));
    galerkin(hx, hy, {first_x, first_y, mx, my}, out);
    for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
      for (std::int64_t ix = first_x; ix < first_x + mx; ++ix, ++out)
        *out = response.short_waves() * *out + remainder.coefficient(hx * static_cast<double>(ix), hy * static_cast<double>(iy));
  });
}

rc_status symbol(const rc_host* host, const rc_kernel_spec* spec, double* out) {
  return roughcontact::guard(host, own, [&] {
    const Response response(layer_of(host, *spec));
    const rc_system& s = *spec->system;
    const double step_x = 2 * std::numbers::pi / (static_cast<double>(s.nx) * s.hx),
                 step_y = 2 * std::numbers::pi / (static_cast<double>(s.ny) * s.hy);
    for (std::int64_t ky = 0; ky <= s.ny / 2; ++ky)
      for (std::int64_t kx = 0; kx <= s.nx / 2; ++kx) {
        const double q = std::hypot(step_x * static_cast<double>(kx), step_y * static_cast<double>(ky));
        *out++ = q > 0 ? 2 / q * response.f(q * response.layer().thickness) : 0;
      }
  });
}

// The smallest of a function of the wave number, up to `last`. Between the waves looked at it falls by far less than 1e-3.
template <class Function> double lowest(double last, const Function& function) {
  constexpr int looks = 2000;
  double least = function(last);
  for (int i = 0; i < looks; ++i) least = std::min(least, function(last * std::pow(1e-9, i / (looks - 1.0))));
  return (1 - 1e-3) * least;
}

// The kernel galerkin has f = 1 and all waves of the lattice add what is positive: the least f is a share of it. The waves that
// the lattice resolves alone give a bound as well: 2 f/q times the squares of the transforms of two cells, (2/pi)^4 at least.
rc_status bounds(const rc_host* host, const rc_kernel_spec* spec, double* least, double* galerkin_share) {
  return roughcontact::guard(host, own, [&] {
    const Response response(layer_of(host, *spec));
    const rc_system& s = *spec->system;
    const double t = response.layer().thickness;
    if (s.boundary == RC_BOUNDARY_PERIODIC) return;  // the library looks the lowest eigenvalue up
    *galerkin_share = std::min(lowest(1e3 / t, [&](double q) { return response.f(q * t); }), (1 - 1e-3) * response.long_waves());
    const double resolved =
        lowest(std::hypot(std::numbers::pi / s.hx, std::numbers::pi / s.hy), [&](double q) { return 2 / q * response.f(q * t); });
    *least = std::pow(2 / std::numbers::pi, 4) * resolved;
  });
}

using roughcontact::real_option, roughcontact::text_option;

constexpr rc_component thickness = real_option("layer.thickness", "0", 0, 1e30,
                                               "thickness of the layer [length]; required by the kernel layer"),
                       modulus = real_option("layer.modulus", "0", 0, 1e30,
                                             "E1/(1-nu1^2) of the layer [force/length^2]; 0: the modulus of the system"),
                       poisson = real_option("layer.poisson", "0.3", 0, 0.5, "Poisson's ratio of the layer"),
                       substrate = real_option("layer.substrate_poisson", "0.3", 0, 0.5,
                                               "Poisson's ratio of the half-space below a bonded layer"),
                       base = text_option("layer.base", "half-space", "half-space|rigid",
                                          "below the layer: a half-space with the modulus of the system, or a rigid body"),
                       interface = text_option("layer.interface", "bonded", "bonded|frictionless",
                                               "the layer sticks to its base, or slides on it and never leaves it");
constexpr const rc_component* options[] = {&base, &interface, &modulus, &poisson, &substrate, &thickness};

}  // namespace

const rc_kernel component = {
    .struct_size = sizeof(rc_kernel),
    .name = "layer",
    .summary = "elastic layer on a half-space or a rigid base (layer.thickness, ...), against a rigid surface; second order",
    .license = "",
    .caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC,
    .n_options = std::size(options),
    .options = options,
    .window = window,
    .symbol = symbol,
    .bounds = bounds,
    .user = nullptr};

}  // namespace rc::kernel::layer
