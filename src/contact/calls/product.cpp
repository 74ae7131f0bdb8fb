#include "contact/calls/product.h"

#include <algorithm>
#include <cmath>

#include "contact/choice.h"
#include "contact/operators.h"
#include "core/error.h"
#include "core/grid.h"
#include "core/large_memory.h"

namespace rc {

namespace {

Operator& operator_of(const GridProblem& problem) {
  const TrialSet all{problem.own_points(), {}};
  return problem.operators().bound(*choose_for(problem, all, RC_CONTROL_APPROACH, {}, false).backend, all);
}

}  // namespace

Product::Product(const rc_system& system, const rc_options& options)
    : problem_(system, options, nullptr),
      operator_(operator_of(problem_)),
      p_(large_vector<double>(static_cast<std::size_t>(problem_.own_points()))),
      u_(p_) {}

void Product::apply(const double* p, double* u) {
  const Rest after(problem_);
  const System& system = problem_.system;
  for (std::size_t i = 0; i < p_.size(); ++i) {
    if (!std::isfinite(p[i]))
      fail(RC_ERR_ARGUMENT, "p = ", p[i], " at ", place(static_cast<std::int64_t>(i), system.given.nx), " is not finite");
    p_[i] = p[i];
  }
  raise_if_failed(operator_.apply(p_.data(), u_.data()), "the product");
  for (double& value : u_) {
    value *= system.length_per_pressure;
    if (!std::isfinite(value)) fail(RC_ERR_NUMERIC, "a deflection is not finite; p is up to ", *std::ranges::max_element(p_));
  }
  std::ranges::copy(u_, u);
}

}  // namespace rc
