#include "contact/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rc {

namespace {

// 0/0 is no violation; anything else over 0 is an infinite one.
double relative(double violation, double scale) {
  if (violation == 0) return 0;
  return scale > 0 ? violation / scale : std::numeric_limits<double>::infinity();
}

}  // namespace

bool Certificate::within(double tol) const { return primal <= tol && dual <= tol && complementarity <= tol && control <= tol; }

double load_imbalance(double load, double wanted) { return relative(std::abs(load - wanted), wanted); }

Certificate certify(const SurfaceState& surface, double approach, std::span<const double> p, std::span<const double> product,
                    double least_deflection, std::span<double> gap) {
  const std::span<const double> h = surface.gap();
  double largest_p = 0, least_p = 0, least_gap = 0, worst = 0;
  bool finite = true;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest_p = std::max(largest_p, std::abs(p[i]));
    least_p = std::min(least_p, p[i]);
  }
  const double scale = std::max(least_deflection * largest_p, approach - surface.lowest());
  for (std::size_t i = 0; i < p.size(); ++i) {
    gap[i] = product[i] - (approach - h[i]);
    if (!surface.included(i)) continue;
    finite = finite && std::isfinite(p[i]) && std::isfinite(gap[i]);
    least_gap = std::min(least_gap, gap[i]);
    if (p[i] > 0) worst = std::max(worst, std::min(p[i] / largest_p, relative(std::abs(gap[i]), scale)));
  }
  if (!finite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, 0};
  }
  return {relative(-least_p, largest_p), relative(-least_gap, scale), worst, 0};
}

}  // namespace rc
