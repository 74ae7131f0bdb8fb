// The registry of kernels.
#include "kernel/kernel.h"

#include <algorithm>
#include <limits>

#include "kernel/kernels.h"

namespace rc::kernel {

std::span<const Kernel> all() { return kernels; }

const Kernel* find(std::string_view name) {
  const auto found = std::ranges::find(kernels, name, &Kernel::name);
  return found == kernels.end() ? nullptr : &*found;
}

void window_coefficients(const Kernel& kernel, double hx, double hy, const Window& window, double* out) {
  if (kernel.window)
    kernel.window(hx, hy, window, out);
  else  // not a free kernel: there is no value
    std::fill_n(out, window.mx * window.my, std::numeric_limits<double>::quiet_NaN());
}

void coefficients(const Kernel& kernel, double hx, double hy, std::int64_t mx, std::int64_t my, double* out) {
  window_coefficients(kernel, hx, hy, {0, 0, mx, my}, out);
}

}  // namespace rc::kernel
