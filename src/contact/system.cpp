#include "contact/system.h"

#include <roughcontact/plugin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/grid.h"
#include "kernel/semi_periodic.h"

namespace rc {

namespace {

constexpr double longest_cell = 1e150;  // over its width
constexpr double longest_strip = 1e4;   // a semi-periodic grid's cells over its period
constexpr double symmetric = 1e-12;     // largest |H_ij - H_ji| relative to the largest entry

const Component<rc_kernel>& resolved_kernel(const System& checked, const rc_options& options) {
  const rc_system& system = checked.given;
  const std::string& option = options.text(RC_OPT_KERNEL);
  const auto& found = options.context->kernel(option == "auto" ? (checked.periodic() ? "spectral" : "love") : option);
  const rc_kernel& kernel = found.vtable;
  const std::uint64_t needed = checked.periodic()        ? RC_KERNEL_PERIODIC
                               : checked.semi_periodic() ? RC_KERNEL_SEMI_PERIODIC
                                                         : RC_KERNEL_FREE;
  if ((kernel.caps & needed) == 0)
    fail(RC_ERR_INCOMPATIBLE, "kernel \"", kernel.name, "\" is not for ", checked.boundary(),
         " boundaries, which the system has; use kernel=auto");
  if ((kernel.caps & RC_KERNEL_SQUARE) && system.hx != system.hy)
    fail(RC_ERR_INCOMPATIBLE, "kernel \"", kernel.name, "\" needs square cells, hx = ", system.hx, " and hy = ", system.hy,
         " differ; use love or galerkin");
  return found;
}

// Images of a cell are summed up to some times its length.
void check_strip(const kernel::Strip& strip) {
  if (!(strip.h_across <= longest_strip * strip.period()))
    fail(RC_ERR_ARGUMENT, "cells are ", strip.h_across / strip.period(), " times as long as the period of the grid, ",
         strip.period(), ", at most ", longest_strip, " times with RC_BOUNDARY_PERIODIC_X or _Y; use shorter cells");
}

void probe_dense(System& result) {
  const rc_system& system = result.given;
  const std::int64_t n = result.points();
  const auto entry = [&](std::int64_t i, std::int64_t j) { return system.dense[i * system.dense_ld + j]; };
  double largest = 0, diagonal = 0, sum = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    for (std::int64_t j = 0; j < n; ++j) {
      if (!std::isfinite(entry(i, j))) fail(RC_ERR_ARGUMENT, "dense matrix: entry (", i, ", ", j, ") is ", entry(i, j));
      largest = std::max(largest, std::abs(entry(i, j)));
      sum += entry(i, j);
      result.positive = result.positive && entry(i, j) >= 0;
    }
    if (!(entry(i, i) > 0))
      fail(RC_ERR_NUMERIC, "dense matrix is not positive definite: diagonal entry ", i, " is ", entry(i, i), ", must be > 0");
    diagonal = std::max(diagonal, entry(i, i));
  }
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < i; ++j)
      if (std::abs(entry(i, j) - entry(j, i)) > symmetric * largest)
        fail(RC_ERR_ARGUMENT, "dense matrix is not symmetric: entry (", i, ", ", j, ") = ", entry(i, j), " but (", j, ", ", i,
             ") = ", entry(j, i), "; allowed difference ", symmetric * largest);
  // A necessary condition that costs n^2 operations. Only a factorisation shows whether the matrix is positive definite.
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < i; ++j)
      if (std::abs(entry(i, j)) > std::sqrt(entry(i, i)) * std::sqrt(entry(j, j)) * (1 + symmetric))
        fail(RC_ERR_NUMERIC, "dense matrix is not positive definite: entry (", i, ", ", j, ") = ", entry(i, j),
             " exceeds the geometric mean of the diagonal entries ", entry(i, i), " and ", entry(j, j));
  if (!(sum > 0)) fail(RC_ERR_NUMERIC, "dense matrix is not positive definite: the sum of its entries is ", sum, ", must be > 0");
  result.length_per_pressure = result.operator_scale = diagonal;
}

// One product with a constant vector. It shows a failing callback before a solve depends on it, and gives the scale.
void probe_callback(System& result) {
  const rc_system& system = result.given;
  check_memory(system, result.points());
  const auto n = static_cast<std::size_t>(result.points());
  std::vector<double> x(n, 1.0), y(n, std::numeric_limits<double>::quiet_NaN());
  if (system.apply(x.data(), y.data(), result.points(), system.user) != 0)
    fail(RC_ERR_EXTERNAL, "the caller's apply function reported failure");
  double work = 0, largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(y[i]))
      fail(RC_ERR_NUMERIC, "the caller's apply function returned ", y[i], " at ", place(static_cast<std::int64_t>(i), system.nx));
    work += y[i];
    largest = std::max(largest, std::abs(y[i]));
  }
  if (!(work > 0)) fail(RC_ERR_NUMERIC, "the caller's apply function is not positive definite: 1'H1 = ", work, ", must be > 0");
  result.positive = false;
  result.length_per_pressure = result.operator_scale = largest;
}

// Everything that a component can see of the half-space, the kernel's options included.
std::string key_of(const System& system, const rc_options& options, double cell) {
  const rc_system& unit = system.unit;
  std::string text = join(system.kernel.name, " ", unit.nx, " ", unit.ny, " ", unit.boundary, " ", exact(unit.hx), " ",
                          exact(unit.hy), " ", exact(unit.hardness), " ", exact(cell), " ", exact(system.given.modulus));
  for (const OptionSpec* spec : options.context->known_options())
    if (spec->key.starts_with(system.kernel.name + '.')) text += join(" ", spec->key, "=", options.values.text_of(*spec));
  return text;
}

Promises promises_of(const System& system) {
  Promises result;
  result.most = system.half_space_wave();
  result.bounds = system.kernel.influence->bounds(system.unit, result.most);
  if (!system.kernel.influence->half_space()) system.kernel.influence->coefficients(system.unit, 1, 1, &result.self);
  return result;
}

void take_promises(System& result, const rc_options& options) {
  const auto make = [&] { return std::make_shared<const Promises>(promises_of(result)); };
  // The promises of kernels from plugins are checked for each contact, because the library does not trust them.
  result.kernel.promises = result.kernel.influence->built_in()
                               ? options.context->shared().get<const Promises>("promises " + result.kernel.key, make)
                               : make();
  result.bounds.lambda_most = result.kernel.promises->most;
  (result.periodic() ? result.bounds.lambda_wave : result.bounds.lambda_min) = result.kernel.promises->bounds.lowest;
  result.bounds.galerkin_share = result.kernel.promises->bounds.galerkin_share;
  if (!result.kernel.influence->half_space())
    result.bounds.least_deflection = std::min(result.bounds.least_deflection, result.kernel.promises->self);
}

}  // namespace

std::uint64_t System::needed_caps() const {
  if (given.op == RC_OPERATOR_DENSE) return RC_CAP_DENSE_INPUT;
  if (given.op == RC_OPERATOR_CALLBACK) return RC_CAP_CALLBACK;
  return periodic() ? RC_CAP_PERIODIC : semi_periodic() ? RC_CAP_SEMI_PERIODIC : RC_CAP_FREE;
}

double System::half_space_wave() const {
  const double lx = unit.hx * static_cast<double>(unit.nx), ly = unit.hy * static_cast<double>(unit.ny);
  return (unit.nx == 1 ? ly : unit.ny == 1 ? lx : std::max(lx, ly)) / std::numbers::pi;
}

System checked_system(const rc_system& asked, const rc_options& options, bool probe) {
  check_grid(asked);
  rc_system system = asked;  // the elastic one that components and coarser grids see
  system.creep_by = system.creep_terms = 0;
  system.creep_ratio = system.creep_time = {};
  System result{.given = system, .unit = system, .creep = prony_terms(asked)};
  if (!(system.hardness >= 0))
    fail(RC_ERR_ARGUMENT, "rc_system.hardness = ", system.hardness, " must be positive, or 0 where all is elastic");
  if (system.hardness > 0) result.hardness = system.hardness;
  switch (system.op) {
    case RC_OPERATOR_HALFSPACE: {
      if (!(std::isfinite(system.modulus) && system.modulus > 0))
        fail(RC_ERR_ARGUMENT, "rc_system.modulus = ", system.modulus,
             " must be positive and finite (contact modulus E*); set it");
      if (!(system.hx / system.hy < longest_cell && system.hy / system.hx < longest_cell))
        fail(RC_ERR_ARGUMENT, "cells of hx = ", system.hx, " by hy = ", system.hy, " are more than ", longest_cell,
             " times as long as wide: their influence coefficients are beyond double precision");
      if (result.semi_periodic()) check_strip(kernel::strip_of(system));
      const double cell = std::sqrt(system.hx) * std::sqrt(system.hy);
      const auto& kernel = resolved_kernel(result, options);
      result.kernel.name = kernel.vtable.name;
      result.kernel.influence = std::make_shared<SystemKernel>(kernel, options, cell, system.modulus);
      result.unit.hx = system.hx / cell;
      result.unit.hy = system.hx == system.hy ? result.unit.hx : system.hy / cell;
      result.unit.modulus = 1;
      result.length_per_pressure = cell / system.modulus;
      if (!std::isnormal(result.length_per_pressure))
        fail(RC_ERR_ARGUMENT, "sqrt(hx*hy)/modulus = ", cell, " / ", system.modulus,
             " is beyond double precision; choose other units");
      result.unit.hardness = result.capped() ? system.hardness / system.modulus : 0;
      result.positive = !result.periodic() && result.kernel.influence->has(RC_KERNEL_POSITIVE);
      result.kernel.key = key_of(result, options, cell);
      if (probe) take_promises(result, options);
      break;
    }
    case RC_OPERATOR_DENSE:
      if (!system.dense) fail(RC_ERR_ARGUMENT, "rc_system.dense is null");
      if (system.dense_ld < result.points())
        fail(RC_ERR_SHAPE, "rc_system.dense_ld = ", system.dense_ld, " must be >= n = ", result.points());
      if (system.dense_ld > most_points / result.points())
        fail(RC_ERR_SHAPE, "dense matrix: n*dense_ld = ", result.points(), " * ", system.dense_ld, " is more than ", most_points,
             " entries");
      if (probe) probe_dense(result);
      break;
    case RC_OPERATOR_CALLBACK:
      if (!system.apply) fail(RC_ERR_ARGUMENT, "rc_system.apply is null");
      if (probe) probe_callback(result);
      break;
  }
  if (result.capped() && !std::isnormal(result.hardness * result.length_per_pressure))
    fail(RC_ERR_ARGUMENT, "rc_system.hardness = ", system.hardness, " times ", result.length_per_pressure,
         ", what a unit pressure deflects, is beyond double precision; choose other units");
  return result;
}

}  // namespace rc
