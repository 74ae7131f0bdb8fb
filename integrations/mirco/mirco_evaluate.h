// MIRCO::Evaluate over roughcontact: the same arguments, neither Kokkos nor Trilinos. To be included where MIRCO's file of this
// name was.
#pragma once

#include <roughcontact/roughcontact.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace MIRCO {

namespace detail {

inline void check(rc_status status) {
  if (status != RC_OK) throw std::runtime_error(std::string("MIRCO::Evaluate: ") + rc_last_error());
}

struct Destroy {
  void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
  void operator()(rc_options* options) const { rc_options_destroy(options); }
};

// Rows of a Kokkos::View, or of a Teuchos matrix. The second argument prefers the first form.
template <class Matrix> auto rows(const Matrix& matrix, int) -> decltype(static_cast<std::int64_t>(matrix.extent(0))) {
  return static_cast<std::int64_t>(matrix.extent(0));
}
template <class Matrix> auto rows(const Matrix& matrix, long) -> decltype(static_cast<std::int64_t>(matrix.numRows())) {
  return matrix.numRows();
}

}  // namespace detail

// The mean pressure of a rough square at a far-field displacement, and the share of its points that are in contact.
//
// Delta: the displacement below the highest point, without the deflection of the half-space below the patch as a whole, which is
// force / ElasticComplianceCorrection. LateralLength: of the square's side. GridSize: the distance of neighbouring points.
// Tolerance: the relative residual to reach, at every point and of the displacement; 1e-6 if it is larger, 1e-12 if it is
// smaller. MaxIteration: of Newton's iterations on the displacement. CompositeYoungs: the contact modulus. topology: heights, N
// by N, with operator()(row, column) and extent(0) or numRows(): a Kokkos::View<double**> that the host can read, a Teuchos
// matrix, or a class of the caller's. zmax: the largest height. meshgrid is not looked at: the points are equidistant.
// WarmStartingFlag: iterations start from the pressures of the last one; no answer depends on it. PressureGreenFunFlag: uniform
// pressure on each cell (true), or the influence coefficients of Bemporad & Paggi (2015), eq. 9. VisualizationExportPath: must be
// empty; no VTK file is written. Throws std::runtime_error.
template <class Matrix, class Meshgrid = std::vector<double>>
void Evaluate(double& pressure, double& effectiveContactAreaFraction, double Delta, double LateralLength, double GridSize,
              double Tolerance, int MaxIteration, double CompositeYoungs, bool WarmStartingFlag,
              double ElasticComplianceCorrection, const Matrix& topology, double zmax, const Meshgrid& meshgrid,
              bool PressureGreenFunFlag, std::optional<std::string> VisualizationExportPath = std::nullopt) {
  using detail::check;
  (void)meshgrid;
  if (VisualizationExportPath)
    throw std::runtime_error("MIRCO::Evaluate: no VTK files are written to " + *VisualizationExportPath + "; give std::nullopt");
  const std::int64_t side = detail::rows(topology, 0);
  std::vector<double> gap;
  for (std::int64_t row = 0; row < side; ++row)
    for (std::int64_t column = 0; column < side; ++column)
      gap.push_back(zmax - topology(static_cast<int>(row), static_cast<int>(column)));

  const double tolerance = std::clamp(Tolerance, 1e-12, 1e-6);
  rc_options* made_options = nullptr;
  check(rc_options_create(nullptr, &made_options));
  const std::unique_ptr<rc_options, detail::Destroy> options(made_options);
  check(rc_options_set_text(options.get(), RC_OPT_KERNEL, PressureGreenFunFlag ? "love" : "eq9"));
  check(rc_options_set_number(options.get(), RC_OPT_TOL, tolerance));
  check(rc_options_set_number(options.get(), RC_OPT_STIFFNESS, 1));
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = side;
  system.hx = system.hy = GridSize;
  system.modulus = CompositeYoungs;
  rc_contact* made_contact = nullptr;
  check(rc_contact_create(&system, options.get(), &made_contact));
  const std::unique_ptr<rc_contact, detail::Destroy> contact(made_contact);

  // The approach d of the patch on its half-space solves d - F(d) / ElasticComplianceCorrection = Delta. F is convex, so Newton's
  // method from below goes up to the solution.
  double approach = Delta;
  for (int iteration = 0; iteration < MaxIteration; ++iteration) {
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.warm_start = WarmStartingFlag ? 1 : 0;
    step.target = approach;
    step.undeformed_gap.data = iteration == 0 ? gap.data() : nullptr;
    rc_result result = RC_RESULT_INIT;
    check(rc_contact_solve(contact.get(), &step, &result));
    const double excess = approach - result.load / ElasticComplianceCorrection - Delta;
    if (std::abs(excess) <= tolerance * std::abs(approach)) {
      pressure = result.load / (LateralLength * LateralLength);
      effectiveContactAreaFraction = static_cast<double>(result.contacts) / static_cast<double>(side * side);
      return;
    }
    const double slope = 1 - result.stiffness / ElasticComplianceCorrection;
    if (!(slope > 1e-3))
      throw std::runtime_error("MIRCO::Evaluate: at Delta = " + std::to_string(Delta) +
                               " the patch is as stiff as the half-space below it: it is closed; press less");
    approach -= excess / slope;
  }
  throw std::runtime_error("MIRCO::Evaluate: Delta = " + std::to_string(Delta) +
                           " is not reached after MaxIteration = " + std::to_string(MaxIteration) + " iterations; allow more");
}

// The same with an object of parameters whose members have MIRCO's names.
template <class Parameters, class Meshgrid = std::vector<double>>
void Evaluate(double& pressure, double& effectiveContactAreaFraction, const Parameters& given, double zmax,
              const Meshgrid& meshgrid) {
  Evaluate(pressure, effectiveContactAreaFraction, given.delta, given.lateral_length, given.grid_size, given.tolerance,
           given.max_iteration, given.composite_youngs, given.warm_starting_flag, given.elastic_compliance_correction,
           given.topology, zmax, meshgrid, given.pressure_green_funct_flag, given.export_visualization_path);
}

}  // namespace MIRCO
