// The arguments of `roughcontact solve` as given, and the checked problem in metres that they describe.
#pragma once

#include <roughcontact/roughcontact.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surface/input.h"

namespace cli {

// In the order of RC_BOUNDARY_*.
inline constexpr std::string_view boundary_names[] = {"free", "periodic", "periodic-x", "periodic-y"};
inline std::string_view name_of_boundary(std::int32_t boundary) { return boundary_names[boundary - RC_BOUNDARY_FREE]; }

struct SolveArguments {
  SurfaceArguments surface;
  std::optional<std::string> young, poisson, young2, poisson2, modulus, hardness;
  std::optional<std::string> approach, load, pressure, area;
  std::optional<std::string> boundary, kernel, solver, backend, tol, threads;
  std::vector<std::string> set;  // key=value
  std::optional<std::string> out, write;
  bool resume = false;
  bool no_maps = false;
  bool explain = false;
  bool quiet = false;
};

struct Problem {
  SurfaceInput input;
  rc_system system;
  std::string control;                                       // "approach", "load", "pressure" or "area"
  std::vector<double> targets;                               // of the control; lengths in metres, areas as shares
  std::vector<std::pair<std::string, std::string>> options;  // of the library, later ones win

  // The control and target for the library, which has areas where the command has shares.
  int32_t step_control() const;
  double step_target(std::size_t step) const;
};

// The boundary, if --boundary is not given: free with a --shape; else as the file says; else periodic, with a note.
void settle_boundary(Problem& problem);

// All but the surface, the size of the grid and a boundary that is not named.
Problem problem_without_surface(const SolveArguments& arguments);

// Throws an Error at the first argument that is wrong; the surface is read last.
Problem make_problem(const SolveArguments& arguments);

}  // namespace cli
