#include "contact_gap.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace rc::flow {

namespace {

struct DestroyProduct {
  void operator()(rc_product* product) const { rc_product_destroy(product); }
};

constexpr double of_products = 2e-11;  // the error of the products of `split`, over the approach

bool hard(const rc_system& system) { return system.hardness > 0 && std::isfinite(system.hardness); }

// The pressure above which points are proven to be in contact: these are rc_result.proven_contacts, and they have the largest
// pressures. Infinite: none.
double proven_above(const rc_system& system, const rc_result& result) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto* p = static_cast<const double*>(result.p.data);
  std::vector<double> pressures;
  std::copy_if(p, p + system.nx * system.ny, std::back_inserter(pressures), [](double each) { return each > 0; });
  const auto proven = static_cast<std::size_t>(std::max<std::int64_t>(result.proven_contacts, 0));
  if (proven == 0 || proven > pressures.size()) return none;
  const auto last = pressures.begin() + static_cast<std::ptrdiff_t>(proven) - 1;
  std::nth_element(pressures.begin(), last, pressures.end(), std::greater<>());
  const double least = *last;
  // Points at the hardness are proven by their overlap as well. Only if lower pressures are proven, too, all of them are among
  // these.
  if (hard(system) && !(result.status == RC_OK && least < 0.999 * system.hardness)) return none;
  const bool tie = std::find(last + 1, pressures.end(), least) != pressures.end();
  return tie ? least : std::nextafter(least, 0.0);
}

}  // namespace

void check_core(rc_status status) {
  if (status < 0) fail(status, rc_last_error());
}

double largest_deflection(const rc_system& system, const rc_options* options) {
  const auto n = static_cast<std::size_t>(system.nx * system.ny);
  double largest = 0;
  if (system.op == RC_OPERATOR_DENSE) {
    for (std::size_t i = 0; i < n; ++i)
      largest = std::max(largest, system.dense[i * static_cast<std::size_t>(system.dense_ld) + i]);
    return largest;
  }
  rc_product* made = nullptr;
  check_core(rc_product_create(&system, options, &made));
  const std::unique_ptr<rc_product, DestroyProduct> product(made);
  std::vector<double> p(n), u(n);
  p[0] = 1;
  check_core(rc_product_apply(made, RC_IN(p.data()), RC_OUT(u.data())));
  return u[0] * (1 + 1e-5);  // products may be in single precision
}

double gap_error(const rc_system& system, const rc_options* options, const rc_result& result, const std::uint8_t* mask,
                 double load) {
  const auto n = static_cast<std::size_t>(system.nx * system.ny);
  const auto* gap = static_cast<const double*>(result.gap.data);
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (mask && mask[i] == 0) continue;
    low = std::min(low, gap[i]);
    high = std::max(high, std::abs(gap[i]));
  }
  const double rounding = of_products * std::abs(result.approach) + 1e-13 * high;
  if (!(load > 0)) return result.gap_error + rounding;
  // At the prescribed load: |d* - d| <= e + |min g|, e^2 = 2 H00 (G + |W_p - W| |d* - d|) over the cell.
  if (std::isnan(result.duality_gap)) return result.duality_gap;
  const double cell = system.hx * system.hy, energy = std::max(result.duality_gap, 0.0) / cell;
  const double deflection = largest_deflection(system, options), lowest = std::abs(low),
               off = std::abs(result.load - load) / cell;
  const double b = deflection * off, c = 2 * deflection * (energy + off * lowest);
  const double e = b + std::sqrt(b * b + c);
  return 2 * e + lowest + 2 * rounding;
}

Gap contact_gap(const rc_system& system, const rc_result& result, const std::uint8_t* mask, double error, bool at_approach) {
  const auto n = static_cast<std::size_t>(system.nx * system.ny);
  const auto* p = static_cast<const double*>(result.p.data);
  const auto* g = static_cast<const double*>(result.gap.data);
  const double proven = at_approach ? proven_above(system, result) : std::numeric_limits<double>::infinity();
  Gap gap{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    if (mask && mask[i] == 0) continue;
    if (p[i] > 0) {
      gap.most[i] = p[i] > proven ? 0 : std::max(g[i], 0.0) + error;
      continue;
    }
    gap.computed[i] = std::max(g[i], 0.0);
    gap.least[i] = std::max(g[i] - error, 0.0);
    gap.most[i] = std::max(g[i] + error, 0.0);
  }
  return gap;
}

}  // namespace rc::flow
