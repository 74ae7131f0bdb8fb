// H of a half-space grid on the device. Vectors come from the host and go back to it.
#pragma once

#include <memory>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "session.h"

namespace rc_cuda {

class Operator {
 public:
  static constexpr roughcontact::Component component = rc_cuda::component;

  Operator(const rc_host* host, const rc_operator_spec& spec);

  static void score(const rc_facts& facts, rc_estimate& estimate);
  // Callers' arrays on the device.
  static void fetch(const rc_host*, const rc_options*, void* to_host, const void* from_device, std::int64_t bytes);
  static void store(const rc_host*, const rc_options*, void* to_device, const void* from_host, std::int64_t bytes);
  const rc_host* host() const { return host_; }
  Index modelled() const { return box_.nx * box_.ny; }

  void bind(const rc_domain& domain);
  void apply(const double* x, double* y) { multiply(x, y, false); }
  void apply_float(const float* x, float* y) { multiply(x, y, false); }
  void field(const double* x, double* y) { multiply(x, y, true); }

 private:
  bool periodic() const { return spec_.system->boundary == RC_BOUNDARY_PERIODIC; }
  Torus torus(bool whole) const;
  const Spectrum& spectrum(Engine& engine, bool whole);
  template <class R> void multiply(const R* x, R* y, bool whole);

  const rc_host* host_;
  rc_operator_spec spec_;
  const Settings settings_;
  rc_common::Box grid_, box_;
  Index n_ = 0;
  std::vector<Index> place_;  // of each point of the domain in the box; empty: in order
  double zero_mode_ = 0;
  std::shared_ptr<const Spectrum> of_box_, of_grid_;
};

}  // namespace rc_cuda
