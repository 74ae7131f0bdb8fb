#include "contact/proof/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/certificate_terms.h"

namespace rc {

namespace {

// The pressures' ends in all processes, and the largest violations.
struct Ends {
  double largest = 0, least = 0;
  Ends operator+(const Ends& b) const { return {std::max(largest, b.largest), std::min(least, b.least)}; }
};

struct Violations {
  double overlap = 0, worst = 0;
  bool finite = true;
  Violations operator+(const Violations& b) const {
    return {std::max(overlap, b.overlap), std::max(worst, b.worst), finite && b.finite};
  }
};

}  // namespace

bool Certificate::within(double tol) const { return primal <= tol && dual <= tol && complementarity <= tol && control <= tol; }

Certificate certify(const StepSurface& surface, double compression, const Deflected& answer, const Survey& found, double scale,
                    double hardness) {
  const std::span<const double> p = answer.p();
  const Ends ends = surface.points().combined_over<Ends>(found.touching, [&](Ends& part, std::size_t k) {
    part.largest = std::max(part.largest, std::abs(p[k]));
    part.least = std::min(part.least, p[k]);
  });
  const double largest_p = ends.largest, least_p = ends.least;
  const auto [overlap, worst, finite] =
      surface.points().combined_over<Violations>(found.touching, [&](Violations& part, std::size_t k) {
        const std::size_t i = answer.point(k);
        if (!surface.included(i)) return;
        const double gap = deformed_gap(answer.product[k], compression, surface.height(i));
        part.finite = part.finite && std::isfinite(p[k]) && std::isfinite(gap);
        part.overlap = std::max(part.overlap, dual_violation(gap, p[k], hardness, scale));
        part.worst = std::max(part.worst, complementarity_violation(gap, p[k], largest_p, hardness, scale));
      });
  if (!finite) {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown, 0};
  }
  return {primal_violation(least_p, largest_p, hardness), overlap, worst, 0};
}

}  // namespace rc
