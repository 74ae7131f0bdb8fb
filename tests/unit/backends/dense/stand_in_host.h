// A host with a stand-in for the influence coefficients, and an operator driven through the backend's function table.
#pragma once

#include <roughcontact/plugin.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/unit_system.h"
#include "support/unshared.h"

RC_PLUGIN_LINKAGE rc_status rc_builtin_dense(const rc_host*, const rc_plugin**);

namespace stand_in {

struct State {
  double memory_limit = 8192.0;
  bool coefficients_fail = false;
  std::int64_t mx = 0, my = 0, requests = 0;  // of the last request for coefficients, and their number
  std::string message;
};

inline State& state() {
  static State instance;
  return instance;
}

// Free: near 1/(pi r), as on the half-space. Periodic: a sum over waves with eigenvalues 1/|k|, without the mean.
inline double coefficient(const rc_system& system, std::int64_t dx, std::int64_t dy) {
  const double x = static_cast<double>(dx), y = static_cast<double>(dy), pi = std::acos(-1.0);
  if (system.boundary == RC_BOUNDARY_FREE) return dx == 0 && dy == 0 ? 1.122 : 1.0 / (pi * std::hypot(x, y));
  const double nx = static_cast<double>(system.nx), ny = static_cast<double>(system.ny);
  double sum = 0.0;
  for (std::int64_t j = 0; j < system.ny; ++j)
    for (std::int64_t i = 0; i < system.nx; ++i) {
      if (i == 0 && j == 0) continue;
      const double kx = static_cast<double>(std::min(i, system.nx - i)) / nx,
                   ky = static_cast<double>(std::min(j, system.ny - j)) / ny;
      sum += std::cos(2.0 * pi * (static_cast<double>(i) * x / nx + static_cast<double>(j) * y / ny)) / std::hypot(kx, ky);
    }
  return sum / (nx * ny);
}

inline rc_status set_message(const rc_host*, rc_status code, const char* message) {
  state().message = message;
  return code;
}

inline rc_status option_real(const rc_host* host, const rc_options*, const char* key, double* out) {
  if (std::string(key) != "dense.memory_limit") return set_message(host, RC_ERR_OPTION, key);
  *out = state().memory_limit;
  return RC_OK;
}

inline rc_status coefficients(const rc_host* host, const rc_system* system, const char*, std::int64_t mx, std::int64_t my,
                              double* out) {
  if (state().coefficients_fail) return set_message(host, RC_ERR_INTERNAL, "no coefficients here");
  state().mx = mx;
  state().my = my;
  ++state().requests;
  for (std::int64_t iy = 0; iy < my; ++iy)
    for (std::int64_t ix = 0; ix < mx; ++ix) out[iy * mx + ix] = coefficient(*system, ix, iy);
  return RC_OK;
}

inline support::Unshared& objects() {
  static support::Unshared instance;
  return instance;
}

inline const rc_host& host() {
  static const rc_host instance = [] {
    rc_host filled = {};
    filled.struct_size = sizeof(rc_host);
    filled.abi_major = RC_PLUGIN_ABI_MAJOR;
    filled.fail = set_message;
    filled.option_real = option_real;
    filled.coefficients = coefficients;
    filled.share = [](const rc_host*, const char*, rc_status (*make)(void*, void**), void (*destroy)(void*), void* argument,
                      void** object) { return objects().add(make, destroy, argument, object); };
    filled.release = [](const rc_host*, void* object) { objects().remove(object); };
    return filled;
  }();
  return instance;
}

inline const rc_backend& backend() {
  const rc_plugin* plugin = nullptr;
  rc_builtin_dense(&host(), &plugin);
  return *plugin->backends[0];
}

inline rc_system half_space(std::int64_t nx, std::int64_t ny, std::int32_t boundary = RC_BOUNDARY_FREE) {
  rc_system system = support::unit_system();
  system.nx = nx;
  system.ny = ny;
  system.boundary = boundary;
  return system;
}

inline rc_system dense(const double* matrix, std::int64_t n, std::int64_t ld) {
  rc_system system = half_space(n, 1);
  system.op = RC_OPERATOR_DENSE;
  system.dense = matrix;
  system.dense_ld = ld;
  return system;
}

class Operator {
 public:
  explicit Operator(const rc_system& system, double memory_limit = 8192.0) : system_(system) {
    state() = State{};
    state().memory_limit = memory_limit;
    const rc_operator_spec spec = {
        sizeof(rc_operator_spec), &system_, system_.op == RC_OPERATOR_HALFSPACE ? "stand-in" : "", nullptr, nullptr, nullptr};
    created_ = backend().create(&host(), &spec, &self_);
  }
  ~Operator() {
    if (self_) backend().destroy(self_);
  }
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  rc_status created() const { return created_; }
  rc_status bind(const std::vector<std::int64_t>& index, double zero_mode = 0.0) {
    n_ = static_cast<Eigen::Index>(index.size());
    const rc_domain domain = {sizeof(rc_domain), n_, index.data(), zero_mode};
    return backend().bind(self_, &domain);
  }
  rc_status bind_all(double zero_mode = 0.0) {
    n_ = system_.nx * system_.ny;
    const rc_domain domain = {sizeof(rc_domain), n_, nullptr, zero_mode};
    return backend().bind(self_, &domain);
  }
  rc_status apply(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    y = Eigen::VectorXd::Constant(n_, std::nan(""));
    return backend().apply(self_, x.data(), y.data());
  }
  rc_status field(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    y = Eigen::VectorXd::Constant(system_.nx * system_.ny, std::nan(""));
    return backend().field(self_, x.data(), y.data());
  }
  rc_status subset(const std::vector<std::int64_t>& a, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    x = Eigen::VectorXd::Constant(b.size(), std::nan(""));
    return backend().subset(self_, static_cast<std::int64_t>(a.size()), a.data(), b.data(), x.data());
  }
  rc_status shifted(double rho, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    x = Eigen::VectorXd::Constant(b.size(), std::nan(""));
    return backend().shifted(self_, rho, b.data(), x.data());
  }
  std::int64_t modelled() { return backend().modelled(self_); }

  // H over the whole grid, entry by entry.
  Eigen::MatrixXd matrix(double zero_mode = 0.0) const {
    const Eigen::Index n = system_.nx * system_.ny;
    return Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) {
      if (system_.op == RC_OPERATOR_DENSE) return system_.dense[i * system_.dense_ld + j];
      return coefficient(system_, std::abs(i % system_.nx - j % system_.nx), std::abs(i / system_.nx - j / system_.nx)) +
             zero_mode / static_cast<double>(n);
    });
  }

 private:
  rc_system system_;
  void* self_ = nullptr;
  rc_status created_;
  Eigen::Index n_ = 0;
};

}  // namespace stand_in
