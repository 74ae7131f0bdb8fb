// H of one system: products, and solves by a factor of all entries or by conjugate gradients with a factor of the near ones.
#pragma once

#include <cstdint>
#include <optional>
#include <roughcontact/plugin.hpp>
#include <span>
#include <vector>

#include "common/entry_operator.h"
#include "failure.h"
#include "near_field.h"
#include "working_set.h"

namespace rc_cholmod {

inline constexpr const char *memory_limit_key = "cholmod.memory_limit", *near_field_key = "cholmod.near_field";

class Operator : public rc_common::EntryOperator {
 public:
  static constexpr roughcontact::Component component = rc_cholmod::component;

  Operator(const rc_host*, const rc_operator_spec&);

  static void score(const rc_facts& facts, rc_estimate& estimate) {
    rc_common::estimate_matrix(facts, estimate, component, memory_limit_key);
  }

  void bind(const rc_domain&);
  void apply(const double* x, double* y);
  void subset(std::int64_t na, const std::int64_t* a, const double* b, double* x);
  void shifted(double rho, const double* b, double* x);

 private:
  bool exact() const { return radius_ == 0.0; }
  void require_factor(std::int64_t points, std::int64_t slots) const;
  void iterate(std::span<const rc_common::Point> points, double rho, const double* b, double* x);
  void forget_factors();

  const rc_operator_spec& spec_;
  const rc_system* system_;
  double radius_;    // of the near field; 0: all entries are factored
  Session session_;  // before what was made with it
  WorkingSet set_;
  std::optional<Factor> shifted_;
  Session::Factor near_;
  std::vector<rc_common::Point> near_points_;
  double rho_ = 0.0;  // of shifted_ or near_
};

}  // namespace rc_cholmod
