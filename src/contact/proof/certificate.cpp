#include "contact/proof/certificate.h"

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

Certificate certify(const StepSurface& surface, double compression, const Deflected& answer, const Survey& found, double scale,
                    double hardness) {
  const std::span<const double> p = answer.p();
  double largest_p = 0, least_p = 0, overlap = 0, worst = 0;
  const double infinite = std::numeric_limits<double>::infinity();
  bool finite = true;
  for (const std::size_t k : found.touching) {
    largest_p = std::max(largest_p, std::abs(p[k]));
    least_p = std::min(least_p, p[k]);
  }
  for (const std::size_t k : found.touching) {
    const std::size_t i = answer.point(k);
    if (!surface.included(i)) continue;
    const double gap = answer.product[k] - (compression - surface.height(i));
    finite = finite && std::isfinite(p[k]) && std::isfinite(gap);
    const double room = gap < 0 && hardness < infinite ? std::max(0.0, 1 - p[k] / hardness) : infinite;
    if (gap < 0) overlap = std::max(overlap, std::min(room, relative(-gap, scale)));
    if (p[k] > 0) worst = std::max(worst, std::min({p[k] / largest_p, room, relative(std::abs(gap), scale)}));
  }
  if (!finite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, 0};
  }
  return {std::max({0.0, relative(-least_p, largest_p), largest_p / hardness - 1}), overlap, worst, 0};
}

}  // namespace rc
