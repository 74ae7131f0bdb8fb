#include "contact/calls/product.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

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

// The longest distance that n values of an array may be apart: offsets in bytes, of both axes together, stay in range.
constexpr std::int64_t longest_of(std::int64_t n) { return std::numeric_limits<std::int64_t>::max() / 16 / n; }

template <class Value> void check_distances(const GridField<Value>& field, const char* name, std::int64_t nx, std::int64_t ny) {
  const auto check = [&](const char* axis, std::int64_t distance, std::int64_t n) {
    if (const std::int64_t most = longest_of(n); n > 1 && (distance > most || distance < -most))
      fail(RC_ERR_ARGUMENT, name, '_', axis, " = ", distance, ", a distance between neighbours, must be within +-", most);
  };
  check("x", field.x, nx);
  check("y", field.y, ny);
}

// Whether two of the points (ix, iy) lie at the same place: ix x + iy y vanishes at the smallest whole multiples only if those
// are differences between points of the grid.
bool points_coincide(std::int64_t x, std::int64_t y, std::int64_t nx, std::int64_t ny) {
  if (nx == 1 || ny == 1) return (nx > 1 && x == 0) || (ny > 1 && y == 0);
  const std::int64_t common = std::gcd(x, y);
  return common == 0 || (std::abs(y / common) < nx && std::abs(x / common) < ny);
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
  check_distances(p, "p", nx, ny);
  check_distances(u, "u", nx, ny);
  if (points_coincide(u.x, u.y, nx, ny))
    fail(RC_ERR_ARGUMENT, "u_x = ", u.x, ", u_y = ", u.y, ": some of the ", nx, " x ", ny, " points of u coincide");
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
