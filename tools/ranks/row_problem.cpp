#include "row_problem.h"

#include <roughcontact/mpi.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "arguments/choices.h"
#include "arguments/quantities.h"
#include "files/summary.h"
#include "formats/error.h"
#include "library.h"
#include "text.h"

namespace cli {

namespace {

constexpr std::string_view rules[] = {"reject", "exclude"};  // of --missing; points are filled from all rows around them

// The checksum of the checksums of rows, which does not depend on who has them.
std::string checksum_of_rows(const Communicator& ranks, std::span<const double> heights, std::int64_t nx, Rows rows) {
  std::vector<double> sums;
  for (std::int64_t iy = 0; iy < rows.count; ++iy) {
    Checksum row;
    row.add(heights.subspan(static_cast<std::size_t>(iy * nx), static_cast<std::size_t>(nx)));
    sums.push_back(std::bit_cast<double>(row.value()));
  }
  Checksum all;
  for (const double sum : ranks.collected(sums)) all.add(std::bit_cast<std::uint64_t>(sum));
  return all.text();
}

// The first point of all rows at which the heights are so, by its place in the grid; -1: none.
template <class Condition>
std::int64_t first_point(const Communicator& ranks, std::span<const double> heights, std::int64_t nx, Rows rows, Condition so) {
  constexpr std::int64_t nowhere = std::numeric_limits<std::int64_t>::max();
  const auto found = std::ranges::find_if(heights, so);
  const auto place = found == heights.end() ? nowhere : rows.first * nx + (found - heights.begin());
  const std::int64_t first = ranks.least(place);
  return first == nowhere ? -1 : first;
}

void add_other(const Communicator& ranks, const std::string& file, double unit, const std::string& name, std::int64_t nx,
               std::int64_t ny, Rows rows, std::vector<double>& heights) {
  const auto layout = read_layout(ranks, file);
  if (layout.nx != nx || layout.ny != ny)
    throw Error("--against: ", file, " has ", layout.nx, " x ", layout.ny, " points, ", name, " has ", nx, " x ", ny,
                ": give two maps on the same grid");
  const std::vector<double> other = read_rows(ranks, file, layout, rows);
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += unit * other[i];
}

}  // namespace

RowProblem read_problem(const Communicator& ranks, const SolveArguments& arguments) {
  RowProblem row{problem_without_surface(arguments), {}, {}, ""};
  Problem& problem = row.problem;
  SurfaceInput& input = problem.input;
  const double unit = unit_of(arguments.surface);
  const auto pitch = pitch_argument(arguments.surface.pitch, unit);
  input.removed = "none";
  input.missing_rule = arguments.surface.missing.value_or("reject");
  const bool exclude = choice("--missing", input.missing_rule, rules) == 1;
  input.file = arguments.surface.file;
  input.against = arguments.surface.against.value_or("");
  input.surface.format = "npy";

  const auto layout = read_layout(ranks, input.file);
  const std::int64_t nx = input.surface.nx = layout.nx, ny = input.surface.ny = layout.ny;
  input.surface.file = input.file;
  input.surface.lengths.push_back({"heights", "", unit});
  settle_pitch(pitch, input.surface);
  rc::formats::Surface other;
  other.file = input.against;
  if (!input.against.empty()) other.lengths = input.surface.lengths;
  settle_units(arguments.surface, &other, input);
  problem.system.hx = *input.surface.hx;
  problem.system.hy = *input.surface.hy;
  problem.system.nx = nx;
  problem.system.ny = ny;
  settle_boundary(problem);
  ranks.together([&] { check(rc_mpi_rows(ranks.get(), &problem.system, &row.rows.first, &row.rows.count), ""); });

  std::vector<double> heights = read_rows(ranks, input.file, layout, row.rows);
  for (double& z : heights) z *= unit;
  if (!input.against.empty()) add_other(ranks, input.against, unit, input.file, nx, ny, row.rows, heights);
  const auto where = [nx](std::int64_t point) {
    return format("ix=%lld, iy=%lld", static_cast<long long>(point % nx), static_cast<long long>(point / nx));
  };
  const std::int64_t infinite = first_point(ranks, heights, nx, row.rows, [](double z) { return std::isinf(z); });
  if (infinite >= 0) throw Error(input.file, ": the height at ", where(infinite), " is not finite");
  input.missing = ranks.sum(std::ranges::count_if(heights, [](double z) { return std::isnan(z); }));
  const std::int64_t missing = first_point(ranks, heights, nx, row.rows, [](double z) { return std::isnan(z); });
  if (input.missing == nx * ny) throw Error(input.file, ": all points are missing");
  if (input.missing > 0 && !exclude)
    throw Error(input.file, ": ", input.missing, " missing values of ", nx * ny, ", first at ", where(missing),
                "; give --missing exclude to keep them out of contact");
  if (input.missing > 0) {
    for (const double z : heights) input.mask.push_back(std::isnan(z) ? 0 : 1);
  }

  row.checksum = checksum_of_rows(ranks, heights, nx, row.rows);
  double highest = -std::numeric_limits<double>::infinity();
  for (const double z : heights) highest = std::max(highest, std::isnan(z) ? highest : z);
  highest = ranks.largest(highest);
  for (double& z : heights) z = highest - z;
  row.gap = std::move(heights);
  return row;
}

std::vector<double> read_step_rows(const Communicator& ranks, const std::string& file, const RowProblem& row) {
  const rc_system& system = row.problem.system;
  const auto layout = read_layout(ranks, file);
  if (layout.nx != system.nx || layout.ny != system.ny)
    throw Error("--resume: ", file, " has ", layout.nx, " x ", layout.ny, " points, the surface has ", system.nx, " x ",
                system.ny);
  return read_rows(ranks, file, layout, row.rows);
}

}  // namespace cli
