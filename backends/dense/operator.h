// H of one system: a stored matrix, a factor that follows a set of points, and a factor of H + rho I. It decides which of them to
// hold.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>

#include "common/entry_operator.h"
#include "failure.h"
#include "updatable_cholesky.h"
#include "working_set.h"

namespace rc_dense {

inline constexpr const char* memory_limit_key = "dense.memory_limit";

class Operator : public rc_common::EntryOperator {
 public:
  static constexpr roughcontact::Component component = rc_dense::component;

  Operator(const rc_host*, const rc_operator_spec&);

  static void score(const rc_facts& facts, rc_estimate& estimate) {
    rc_common::estimate_matrix(facts, estimate, component, memory_limit_key);
  }

  void bind(const rc_domain&);
  void apply(const double* x, double* y);
  void subset(std::int64_t na, const std::int64_t* a, const double* b, double* x);
  void shifted(double rho, const double* b, double* x);
  // The influence coefficients stay.
  void forget();
  void rest();

 private:
  double budget() const;
  bool fits(double bytes) const { return bytes <= budget(); }
  void factor_shifted(double rho);

  const rc_options* options_;
  bool grid_;
  WorkingSet set_;  // of grid points, so that it outlives a change of domain
  UpdatableCholesky shifted_;
  double rho_ = 0.0;  // of shifted_
};

}  // namespace rc_dense
