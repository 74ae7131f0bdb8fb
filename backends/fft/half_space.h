// H of a half-space grid, which this process has alone or whose rows are shared by processes.
#pragma once

#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>

#include "operator.h"
#include "slabs.h"

namespace rc_fft {

class HalfSpace {
 public:
  static constexpr roughcontact::Component component = rc_fft::component;

  HalfSpace(const rc_host* host, const rc_operator_spec& spec);

  static void score(const rc_facts&, rc_estimate&);
  const rc_host* host() const { return op_.host(); }
  std::int64_t modelled() const { return slabs_ ? slabs_->points() : op_.modelled(); }

  void bind(const rc_domain& domain) {
    if (!slabs_) op_.bind(domain);
  }
  void forget() { op_.forget(); }
  void rest() { op_.rest(); }
  void apply(const double* x, double* y) { slabs_ ? slabs_->apply(x, y) : op_.apply(x, y); }
  void apply_float(const float* x, float* y) { slabs_ ? slabs_->apply(x, y) : op_.apply_float(x, y); }
  void field(const double* x, double* y) { slabs_ ? slabs_->apply(x, y) : op_.field(x, y); }
  double norm() { return op_.norm(); }

 private:
  Operator op_;
  std::unique_ptr<Slabs> slabs_;  // null: this process has the whole grid
};

}  // namespace rc_fft
