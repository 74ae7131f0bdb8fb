#include "contact/calls/product.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

void Product::apply(const GridField<const double>& p, const GridField<double>& u) {
  const Rest after(problem_);
  const System& system = problem_.system;
  const std::int64_t nx = system.given.nx, ny = system.given.ny;
  if ((u.x == 0 && nx > 1) || (u.y == 0 && ny > 1))
    fail(RC_ERR_ARGUMENT, "u_x = ", u.x, ", u_y = ", u.y, ": points of u coincide");
  for (const auto& [distance, n] : {std::pair{p.x, nx}, {p.y, ny}, {u.x, nx}, {u.y, ny}})
    if (const std::int64_t most = std::numeric_limits<std::int64_t>::max() / 4 / n; distance > most || distance < -most)
      fail(RC_ERR_ARGUMENT, "a distance between neighbours, ", distance, ", is too large");
  std::size_t k = 0;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const double value = p.at(ix, iy);
      if (!std::isfinite(value)) fail(RC_ERR_ARGUMENT, "p = ", value, " at ", place(iy * nx + ix, nx), " is not finite");
      p_[k++] = value;
    }
  raise_if_failed(operator_.apply(p_.data(), u_.data()), "the product");
  for (double& value : u_) {
    value *= system.length_per_pressure;
    if (!std::isfinite(value)) fail(RC_ERR_NUMERIC, "a deflection is not finite; p is up to ", *std::ranges::max_element(p_));
  }
  k = 0;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix) u.at(ix, iy) = u_[k++];
}

}  // namespace rc
