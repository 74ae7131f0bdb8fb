// H of a half-space grid, shared by processes or with x and y exchanged where that is faster. Transforms take lines along x, and
// columns many at a time. On a grid of few columns most of each block of columns would be empty, so such a grid is turned: its
// columns become lines.
#pragma once

#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "operator.h"
#include "slabs.h"

namespace rc_fft {

class Turned {
 public:
  static constexpr roughcontact::Component component = rc_fft::component;

  Turned(const rc_host* host, const rc_operator_spec& spec);
  Turned(const Turned&) = delete;
  Turned& operator=(const Turned&) = delete;

  static void score(const rc_facts&, rc_estimate&);
  const rc_host* host() const { return op_.host(); }
  std::int64_t modelled() const { return slabs_ ? slabs_->points() : op_.modelled(); }

  void bind(const rc_domain& domain);
  void forget() { op_.forget(); }
  void rest() { op_.rest(); }
  void apply(const double* x, double* y);
  void apply_float(const float* x, float* y);
  void field(const double* x, double* y);
  double norm() { return op_.norm(); }

 private:
  template <class Real, class Product> void reordered(const Real* x, Real* y, const Product& product) const;

  const std::int64_t nx_, ny_;  // as the caller has them
  const bool turned_;
  rc_system system_;  // as the operator has it
  Operator op_;
  std::unique_ptr<Slabs> slabs_;     // null: this process has the whole grid
  std::vector<std::int64_t> order_;  // the caller's place of each point in the operator's order; empty: the same
};

}  // namespace rc_fft
