#include "registry/system_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/limits.h"
#include "kernel/lowest_eigenvalue.h"
#include "kernel/semi_periodic.h"

namespace rc {

namespace {

constexpr double round_off = 1e-9;     // by which promises may be missed
constexpr double same = 1e-11;         // difference of two equal coefficients, over the one at offset (0, 0), at most
constexpr std::int64_t patch = 8;      // cells along a side of the patch on which promises are checked
constexpr double unlooked = 1 - 1e-6;  // of a lowest eigenvalue that is looked up: transforms round

// 1/n x'Hx for the n cells of the patch, x = +-1 with the sign changing from cell to cell along x, y, both or neither.
double mean_work(const double* k, int along_x, int along_y) {
  double sum = 0;
  for (std::int64_t y = 0; y < patch; ++y)
    for (std::int64_t x = 0; x < patch; ++x) {
      const auto pairs = [](std::int64_t offset) {
        return static_cast<double>((offset == 0 ? 1 : 2) * (patch - offset)) / static_cast<double>(patch);
      };
      const double sign = (along_x * x + along_y * y) % 2 == 0 ? 1 : -1;
      sum += sign * pairs(x) * pairs(y) * k[y * patch + x];
    }
  return sum;
}

}  // namespace

SystemKernel::SystemKernel(const Component<rc_kernel>& kernel, const rc_options& options, double length, double modulus)
    : kernel_(kernel.vtable), options_(options), length_(length), modulus_(modulus), built_in_(kernel.built_in()) {}

template <class... Parts> void SystemKernel::refuse(const Parts&... parts) const {
  fail(RC_ERR_NUMERIC, "kernel \"", kernel_.name, "\": ", parts...);
}

rc_kernel_spec SystemKernel::spec(const rc_system& system) const {
  return {sizeof(rc_kernel_spec), &kernel_, &system, &options_, length_, modulus_};
}

void SystemKernel::check(rc_status status, const char* what) const {
  raise_if_failed(status, what);
  if (status != RC_OK) refuse(what, " returned ", status, ", must be RC_OK or an error");
}

KernelBounds SystemKernel::promised(const rc_system& system) const {
  KernelBounds found;
  if (!kernel_.bounds) return found;
  const rc_kernel_spec asked = spec(system);
  clear_message();
  check(kernel_.bounds(&options_.context->host(), &asked, &found.lowest, &found.galerkin_share), "the kernel's bounds");
  for (const double value : {found.lowest, found.galerkin_share})
    if (!(value >= 0) || std::isinf(value)) refuse("a promised bound is ", value, ", must be finite and >= 0 (0: none)");
  return found;
}

KernelBounds SystemKernel::bounds(const rc_system& system, double& largest) const {
  KernelBounds found = promised(system);
  if (half_space()) return found;
  if (kernel::semi_periodic(system.boundary)) found.galerkin_share = 0;  // a promise about free boundaries
  if (system.boundary != RC_BOUNDARY_PERIODIC) {
    if (!built_in_) check_coefficients(system, found);
    found.lowest =
        std::max(found.lowest, found.galerkin_share * kernel::lowest_eigenvalue(*kernel::find("galerkin"), system.hx, system.hy));
    return found;
  }
  std::vector<double> values(static_cast<std::size_t>((system.nx / 2 + 1) * (system.ny / 2 + 1)));
  symbol(system, values.data());
  found.galerkin_share = 0;
  if (values.size() == 1) return found;
  const double least = *std::min_element(values.begin() + 1, values.end());
  largest = *std::max_element(values.begin() + 1, values.end());
  if (found.lowest > least * (1 + round_off))
    refuse("an eigenvalue is ", least, ", although none is promised to be below ", found.lowest);
  found.lowest = unlooked * least;
  return found;
}

// Quotients x'Hx / x'x are no smaller than the lowest eigenvalue.
void SystemKernel::check_coefficients(const rc_system& system, const KernelBounds& promise) const {
  const kernel::Window all{0, 0, patch, patch};
  std::vector<double> values(patch * patch), galerkin(values.size()), alone(patch);
  window(system, all, values.data());
  for (std::int64_t y = 0; y < patch; ++y) {
    ask(system, {1, y, patch - 1, 1}, alone.data());
    for (std::int64_t x = 1; x < patch; ++x)
      if (const double value = values[static_cast<std::size_t>(y * patch + x)], other = alone[static_cast<std::size_t>(x - 1)];
          !(std::abs(value - other) <= same * values[0]))
        refuse("the coefficient at offset (", x, ", ", y, ") is ", exact(value), " in one window and ", exact(other),
               " in another, must not depend on the window");
  }
  kernel::window_coefficients(*kernel::find("galerkin"), system.hx, system.hy, all, galerkin.data());
  for (const int along_x : {0, 1})
    for (const int along_y : {0, 1}) {
      const double work = mean_work(values.data(), along_x, along_y), least = mean_work(galerkin.data(), along_x, along_y);
      if (!(work > 0)) refuse("H is not positive definite: x'Hx / x'x is ", work, " on ", patch, " x ", patch, " cells");
      if (promise.lowest > work * (1 + round_off))
        refuse("an eigenvalue is at most ", work, ", although none is promised to be below ", promise.lowest);
      if (promise.galerkin_share * least > work * (1 + round_off))
        refuse("x'Hx is ", work / least, " times that of galerkin, although at least ", promise.galerkin_share, " is promised");
    }
}

void SystemKernel::ask(const rc_system& system, const kernel::Window& window, double* out) const {
  const rc_kernel_spec asked = spec(system);
  clear_message();
  if (!built_in_) std::fill_n(out, window.mx * window.my, nan);  // shows what is left out
  check(kernel_.window(&options_.context->host(), &asked, window.first_x, window.first_y, window.mx, window.my, out),
        "the kernel's window");
}

// A backend reads half a period and mirrors it, or all of it. So each value is compared with its mirror image, in a window of its
// own. Offset 0 is its own image.
void SystemKernel::check_mirrored(const rc_system& system, const kernel::Window& window, const double* values,
                                  double scale) const {
  const bool along_x = system.boundary == RC_BOUNDARY_PERIODIC_X;
  const std::int64_t period = along_x ? system.nx : system.ny;
  const std::int64_t first = along_x ? window.first_x : window.first_y, size = along_x ? window.mx : window.my;
  const std::int64_t begin = std::max<std::int64_t>(first, 1), end = std::min(first + size, period);
  if (begin >= end) return;
  kernel::Window mirrored = window;
  (along_x ? mirrored.first_x : mirrored.first_y) = period - end + 1;
  (along_x ? mirrored.mx : mirrored.my) = end - begin;
  std::vector<double> images(static_cast<std::size_t>(mirrored.mx * mirrored.my));
  ask(system, mirrored, images.data());
  for (std::int64_t iy = 0; iy < mirrored.my; ++iy)
    for (std::int64_t ix = 0; ix < mirrored.mx; ++ix) {
      const std::int64_t image_x = mirrored.first_x + ix, image_y = mirrored.first_y + iy;
      const std::int64_t x = along_x ? period - image_x : image_x, y = along_x ? image_y : period - image_y;
      const double value = values[(y - window.first_y) * window.mx + x - window.first_x];
      const double image = images[static_cast<std::size_t>(iy * mirrored.mx + ix)];
      if (!(std::abs(value - image) <= same * scale))
        refuse("the coefficients at offsets (", x, ", ", y, ") and (", image_x, ", ", image_y, ") are ", exact(value), " and ",
               exact(image), ", must be equal: the grid repeats after ", period, " points along ", along_x ? 'x' : 'y');
    }
}

void SystemKernel::window(const rc_system& system, const kernel::Window& window, double* out) const {
  ask(system, window, out);
  if (built_in_) return;
  // The largest coefficient is the first one.
  double most = out[0];
  if (window.first_x != 0 || window.first_y != 0) ask(system, {0, 0, 1, 1}, &most);
  if (!(most > 0))
    refuse("the coefficient at offset (0, 0) is ", most, std::isnan(most) ? ", must be finite" : ", must be positive");
  const bool positive = has(RC_KERNEL_POSITIVE);
  for (std::int64_t i = 0; i < window.mx * window.my; ++i) {
    const auto wrong = [&](const auto&... why) {
      refuse("the coefficient at offset (", window.first_x + i % window.mx, ", ", window.first_y + i / window.mx, ") is ", out[i],
             why...);
    };
    if (!std::isfinite(out[i])) wrong(", must be finite");
    if (std::abs(out[i]) > most) wrong(", beyond that at (0, 0), ", most, ": H is not positive definite");
    if (positive && out[i] < 0) wrong(", although none is promised to be negative");
  }
  if (kernel::semi_periodic(system.boundary)) check_mirrored(system, window, out, most);
}

void SystemKernel::symbol(const rc_system& system, double* out) const {
  const rc_kernel_spec asked = spec(system);
  const std::int64_t half_x = system.nx / 2 + 1, n = half_x * (system.ny / 2 + 1);
  if (!built_in_) std::fill_n(out, n, nan);
  clear_message();
  check(kernel_.symbol(&options_.context->host(), &asked, out), "the kernel's symbol");
  out[0] = 0;
  if (built_in_) return;
  for (std::int64_t i = 1; i < n; ++i)
    if (!(out[i] >= 0) || std::isinf(out[i]))
      refuse("the symbol at wave numbers (", i % half_x, ", ", i / half_x, ") is ", out[i], ", must be >= 0 and finite");
}

void SystemKernel::coefficients(const rc_system& system, std::int64_t mx, std::int64_t my, double* out) const {
  if (system.boundary != RC_BOUNDARY_PERIODIC) return window(system, {0, 0, mx, my}, out);
  std::vector<double> values(static_cast<std::size_t>((system.nx / 2 + 1) * (system.ny / 2 + 1)));
  symbol(system, values.data());
  kernel::from_symbol(std::move(values), system.nx, system.ny, mx, my, out);
}

}  // namespace rc
