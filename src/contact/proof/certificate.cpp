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

// The scale follows from the problem alone: an answer must not set the scale that it is judged by. Periodic, load control: in
// full contact the compression may vanish under any load. The scale is then at least a quarter of mean pressure times
// length_per_pressure, or what the kernel deflects a cell by if that is less; the library's kernels deflect it by more, if it is
// up to 100 times as long as wide. Periodic, approach control: gaps under pressure as large as the mean gap would leave the
// load open, so tol times the scale is half of it at most.
double residual_scale(const GridProblem& problem, const Target& target, double compression) {
  const System& system = problem.system;
  const double mean_pressure = target.value / system.cell_area() / static_cast<double>(system.points());
  return residual_scale(
      {.periodic = system.periodic(),
       .by_load = target.by_load(),
       .whole = problem.surface.range().whole,
       .deflected = system.bounds.least_deflection * system.length_per_pressure * mean_pressure,
       .mean_height = system.periodic() && !target.by_load() ? problem.surface.moments().mean : 0,  // a pass over the surface
       .tol = problem.options.real(RC_OPT_TOL)},
      compression);
}

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
