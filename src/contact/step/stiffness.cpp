#include "contact/step/stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/step/contact_set_solve.h"
#include "core/error.h"

namespace rc {

namespace {

// Residuals; the error is quadratic in them.
constexpr double least_tol = 1e-10, most_tol = 1e-4;  // of the contact set's solve, which follows the tolerance between them
constexpr double subset_tol = 1e-12;                  // without a preconditioner or a bound

}  // namespace

double stiffness(Workspace& work, const Answer& answer) {
  const System& system = work.system;
  if (!answer.op) return 0;
  std::vector<std::int64_t> contact;
  for (std::size_t i = 0; i < answer.p.size(); ++i)
    if (answer.p[i] > 0 && answer.p[i] < answer.cap()) contact.push_back(static_cast<std::int64_t>(i));
  if (contact.empty()) return 0;
  const bool full = static_cast<std::int64_t>(contact.size()) == system.points();
  if (system.periodic() && full) return std::numeric_limits<double>::infinity();
  const std::vector<double> ones(contact.size(), 1.0);
  std::vector<double> rate(contact.size());
  double sum = 0, mean = answer.op->trial().zero_mode / static_cast<double>(system.points());
  rc_status status = RC_OK;
  if (const double lowest = system.periodic() ? system.lambda_wave : system.lambda_min;
      system.halfspace() && !answer.op->has_subset() && lowest > 0) {
    ContactSetSolve solve(*answer.op, contact, work.grid(), lowest, work.team(),
                          [&work](std::int64_t mx, std::int64_t my, auto& out) {
                            out.resize(static_cast<std::size_t>(mx * my));
                            raise_if_failed(work.coefficients(mx, my, out.data()), "the stiffness");
                          });
    mean += solve.mean();
    ContactSetBound bound;
    status = solve(ones, std::clamp(work.options.real(RC_OPT_TOL), least_tol, most_tol), rate, {&bound, 1});
    sum = bound.form;
    work.options.context->log(RC_LOG_INFO,
                              join("stiffness: residual ", bound.residual / std::sqrt(static_cast<double>(ones.size()))));
  } else {
    status = answer.op->subset(contact, ones.data(), rate.data(), subset_tol);
    for (const double value : rate) sum += value;
  }
  raise_if_failed(status, "the stiffness");
  if (status != RC_OK) return std::numeric_limits<double>::quiet_NaN();
  // Without the rank-one zero mode (Sherman & Morrison 1950).
  sum /= 1 - mean * sum;
  return sum * system.cell_area() / system.length_per_pressure;
}

}  // namespace rc
