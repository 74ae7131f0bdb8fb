// The kernel of one system: what it promises, and its values, which are checked where it comes from outside.
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/kernel.h"
#include "registry/context.h"
#include "registry/options_handle.h"

namespace rc {

// What rc_kernel.bounds promises.
struct KernelBounds {
  double lowest = 0, galerkin_share = 0;
};

// All functions throw Error(NUMERIC, or what the kernel says).
class SystemKernel {
 public:
  // length, modulus: what 1 in the systems below is for the caller. The options' context holds the kernel.
  SystemKernel(const Component<rc_kernel>& kernel, const rc_options& options, double length, double modulus);

  std::string_view name() const { return kernel_.name; }
  bool has(std::uint64_t cap) const { return (kernel_.caps & cap) != 0; }
  bool built_in() const { return built_in_; }
  // One of the library's kernels of a homogeneous half-space, of which all that is promised is known.
  bool half_space() const { return built_in_ && has(RC_KERNEL_HOMOGENEOUS); }

  // Checks what can be seen of a kernel from outside before anything depends on it, and returns its promises. The lowest
  // eigenvalue follows from the share of galerkin where that says more; periodic systems: from the symbol. largest: out, the
  // largest eigenvalue but the mean's; unchanged if no symbol is read.
  KernelBounds bounds(const rc_system&, double& largest) const;

  void window(const rc_system&, const kernel::Window&, double* out) const;  // not for periodic boundaries
  void symbol(const rc_system&, double* out) const;                         // periodic boundaries
  void coefficients(const rc_system&, std::int64_t mx, std::int64_t my, double* out) const;

 private:
  rc_kernel_spec spec(const rc_system&) const;
  void check(rc_status, const char* what) const;
  void ask(const rc_system&, const kernel::Window&, double* out) const;
  void check_mirrored(const rc_system&, const kernel::Window&, const double* values, double scale) const;
  KernelBounds promised(const rc_system&) const;
  void check_coefficients(const rc_system&, const KernelBounds&) const;
  template <class... Parts> [[noreturn]] void refuse(const Parts&... parts) const;

  const rc_kernel& kernel_;
  rc_options options_;
  double length_, modulus_;
  bool built_in_;
};

}  // namespace rc
