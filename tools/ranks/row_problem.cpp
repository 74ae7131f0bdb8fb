#include "row_problem.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "files/summary.h"
#include "formats/error.h"
#include "library.h"
#include "request/choices.h"
#include "request/shapes.h"
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

// The layout of a file, and the grid that the request library gets.
struct RowMap {
  rc::formats::NpyLayout layout;
  rc_map map;
};

RowMap map_of(const Communicator& ranks, const char* word, const std::string& file) {
  RowMap found{read_layout(ranks, file), RC_MAP_INIT};
  found.map.word = word;
  found.map.name = file.c_str();
  found.map.nx = found.layout.nx;
  found.map.ny = found.layout.ny;
  return found;
}

}  // namespace

RowProblem read_problem(const Communicator& ranks, const SolveArguments& arguments) {
  const GivenWords& words = arguments.words;
  const auto& against = words["against"];
  const bool exclude = choice("--missing", words["missing"].value_or("reject"), rules) == 1;
  const RowMap surface = map_of(ranks, "surface", words.surface);
  std::vector<rc_map> maps{surface.map};
  std::optional<RowMap> other;
  if (against) maps.push_back(other.emplace(map_of(ranks, "against", *against)).map);
  RowProblem row{make_problem(arguments, RC_CALL_ROWS, maps.data(), std::ssize(maps)), {}, {}, {}, ""};
  Problem& problem = row.problem;
  SurfaceInput& input = problem.input;
  input.format = "npy";
  const rc_system& system = problem.system;
  const std::int64_t nx = system.nx, ny = system.ny;
  ranks.together([&] { check(rc_ranks_rows(&ranks.exchange(), &system, &row.rows.first, &row.rows.count), ""); });

  const double unit = problem_of(input.request).metres;
  std::vector<double> heights = read_rows(ranks, input.file, surface.layout, row.rows);
  for (double& z : heights) z *= unit;
  if (other) {
    const std::vector<double> added = read_rows(ranks, *against, other->layout, row.rows);
    for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += unit * added[i];
  }
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
    for (const double z : heights) row.mask.push_back(std::isnan(z) ? 0 : 1);
    input.mask = row.mask.data();
  }
  if (!input.shape.empty()) {
    bool bare = false;
    const Shape shape = parse_shape("--shape", input.shape, unit, bare);
    ranks.together([&] { add_shape("--shape", shape, {nx, ny, system.hx, system.hy, row.rows.first}, true, heights); });
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
