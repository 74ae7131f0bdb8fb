// The registry of kernels.
#include "kernel/kernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "kernel/kernels.h"

namespace rc::kernel {

namespace {

using Fill = void (*)(double hx, double hy, const Window&, double* out);

constexpr std::array<Fill, kernels.size()> fills{disc, eq9, galerkin, love, punch, nullptr};

}  // namespace

std::span<const Kernel> all() { return kernels; }

const Kernel* find(std::string_view name) {
  const auto found = std::ranges::find(kernels, name, &Kernel::name);
  return found == kernels.end() ? nullptr : &*found;
}

void window_coefficients(const Kernel& kernel, double hx, double hy, const Window& window, double* out) {
  const Kernel* known = find(kernel.name);
  const Fill fill_table = known ? fills[static_cast<std::size_t>(known - kernels.data())] : nullptr;
  if (fill_table)
    fill_table(hx, hy, window, out);
  else  // not a free kernel: there is no value
    std::fill_n(out, window.mx * window.my, std::numeric_limits<double>::quiet_NaN());
}

void coefficients(const Kernel& kernel, double hx, double hy, std::int64_t mx, std::int64_t my, double* out) {
  window_coefficients(kernel, hx, hy, {0, 0, mx, my}, out);
}

}  // namespace rc::kernel
