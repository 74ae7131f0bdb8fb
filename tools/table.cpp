#include "table.h"

#include <cstdio>
#include <filesystem>
#include <string>

#include "platform/files.h"
#include "text.h"

namespace cli {

void print_table_head(const Problem& problem) {
  const rc_system& system = problem.system;
  const std::string name = rc_platform::path_of(problem.input.file).filename().string();
  std::printf("surface %s, %lld x %lld points, pitch %.6g m x %.6g m, E* %.6g, %s boundary, lengths in m%s\n", name.c_str(),
              static_cast<long long>(system.nx), static_cast<long long>(system.ny), system.hx, system.hy, system.modulus,
              system.boundary == RC_BOUNDARY_PERIODIC ? "periodic" : "free", problem.input.preparation().c_str());
  if (system.hardness > 0)
    std::printf("hardness %.6g: pressures are at most that, the overlap there is plastic\n", system.hardness);
  std::printf("%4s %12s %12s %13s %12s %9s %12s %12s %8s %10s %8s %10s %8s  %-20s %s\n", "step", "approach", "load",
              "mean pressure", "max pressure", "area", "mean gap", "stiffness", "residual", "iterations", "products",
              "candidates", "seconds", "solver/backend", "status");
  std::fflush(stdout);
}

void print_table_row(const Problem& problem, const StepRecord& step) {
  const rc_result& r = step.result;
  const std::string names = std::string(r.solver) + "/" + r.backend;
  std::printf("%4d %12.6g %12.6g %13.6g %12.6g %9.6f %12.6g %12.6g %8.1e %10lld %8lld %10lld %8.3g  %-20s %s\n", step.number,
              r.approach, r.load, r.mean_pressure, step.measures.max_pressure, step.area_fraction(), step.measures.mean_gap,
              r.stiffness, step.worst_residual(), static_cast<long long>(r.iterations), static_cast<long long>(r.products),
              static_cast<long long>(r.candidates), r.seconds, names.c_str(), rc_status_name(r.status));
  if (r.status == RC_WITHIN_GOAL)
    std::printf("%4s estimated errors: %.2g %% of what accuracy is of, %.2g %% of the area\n", "",
                100 * step.accuracy.error_estimate, 100 * step.accuracy.area_estimate);
  if (problem.system.hardness > 0)
    std::printf("%4s %lld of %lld contact points at the hardness, plastic volume of the step %.6g m^3\n", "",
                static_cast<long long>(r.capped), static_cast<long long>(r.contacts), r.plastic_volume);
  std::fflush(stdout);
}

}  // namespace cli
