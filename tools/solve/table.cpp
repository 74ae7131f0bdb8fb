#include "solve/table.h"

#include <cstdio>
#include <filesystem>
#include <string>

#include "platform/files.h"
#include "request/units.h"
#include "solve/leak.h"
#include "text.h"

namespace cli {

namespace {

constexpr int digits = 4;

// time: an empty text without times.
std::string row(const std::string& time, const std::string (&cells)[10], const std::string& status) {
  constexpr std::size_t widths[] = {4, 9, 9, 8, 12, 10, 13, 9, 8, 7};
  std::string line;
  for (std::size_t k = 0; k < std::size(cells); ++k) line += (k == 0 ? "" : " ") + right_aligned(cells[k], widths[k]);
  if (!time.empty()) line.insert(widths[0], " " + right_aligned(time, 10));
  return line + "  " + status + "\n";
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

void print_table_head(const Problem& problem) {
  const rc_system& system = problem.system;
  const std::string name = rc_platform::path_of(problem.input.file).filename().string();
  std::string pitch = with_prefix(system.hx, "m", digits);
  if (system.hx != system.hy) pitch += " x " + with_prefix(system.hy, "m", digits);
  std::string text = format("surface %s, %lld x %lld points, pitch ", name.c_str(), static_cast<long long>(system.nx),
                            static_cast<long long>(system.ny)) +
                     pitch + ", E* " + with_prefix(system.modulus, "Pa", digits) + ", " + name_of_boundary(system.boundary) +
                     " boundary" + problem.input.preparation() + "\n";
  if (system.hardness > 0)
    text += "hardness " + with_prefix(system.hardness, "Pa", digits) +
            ": pressure is capped, the overlap is stored as plastic indentation\n";
  print(text +
        row(problem.times.empty() ? "" : "after",
            {"step", "load", "approach", "area", "max pressure", "stiffness", "mean pressure", "mean gap", "residual", "time"},
            "status"));
}

void print_table_row(const Problem& problem, const StepRecord& step) {
  const rc_result& r = step.result;
  const std::string time =
      problem.times.empty() ? "" : format("%.6g s", problem.step_time(static_cast<std::size_t>(step.number - 1)));
  std::string text = row(time,
                         {std::to_string(step.number), with_prefix(r.load, "N", digits), with_prefix(r.approach, "m", digits),
                          format("%.*g %%", digits, 100 * step.result.area_fraction),
                          with_prefix(step.result.max_pressure, "Pa", digits), with_prefix(r.stiffness, "N/m", digits),
                          with_prefix(r.mean_pressure, "Pa", digits), with_prefix(step.result.mean_gap, "m", digits),
                          format("%.1e", step.worst_residual()), with_prefix(r.setup_seconds + r.seconds, "s")},
                         rc_status_name(r.status));
  if (r.status == RC_WITHIN_GOAL)
    text += format("%4s estimated errors: %.2g %% of what accuracy is of, %.2g %% of the area\n", "",
                   100 * step.result.error_estimate, 100 * step.result.area_estimate);
  if (problem.system.hardness > 0)
    text += format("%4s %lld of %lld contact points at the hardness, plastic volume of the step ", "",
                   static_cast<long long>(r.capped), static_cast<long long>(r.contacts)) +
            with_prefix(r.plastic_volume, "m^3", digits) + "\n";
  if (step.leak) text += format("%4s ", "") + line_of(problem, *step.leak) + "\n";
  print(text);
}

}  // namespace cli
