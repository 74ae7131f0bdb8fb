// The arguments of `roughcontact solve` as given, and the checked problem in metres that they describe.
#pragma once

#include <roughcontact/budget.h>
#include <roughcontact/flow.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surface/input.h"

namespace cli {

// The name of RC_BOUNDARY_*.
std::string name_of_boundary(std::int32_t boundary);

struct SolveArguments {
  GivenWords words;
  std::vector<std::string> set;  // key=value
  std::optional<std::string> out, write;
  std::optional<std::string> budget;  // its sources
  bool resume = false;
  bool no_maps = false, no_pictures = false;
  bool explain = false;
  bool quiet = false;
};

struct Problem {
  SurfaceInput input;
  rc_problem_view view;
  rc_system system;
  std::string control;                                       // "approach", "load", "pressure", "area" or "closing-pressure"
  std::vector<double> targets;                               // of the control; lengths in metres, areas as shares
  std::vector<double> times;                                 // of the steps [s]; empty: the bodies are elastic
  std::vector<std::pair<std::string, std::string>> options;  // of the library, later ones win
  std::string budget_sources;
  std::shared_ptr<const rc_budget> budget;  // of the last step; null: not asked for

  // The control and target for the library, which has areas where the command has shares.
  int32_t step_control() const;
  double step_target(std::size_t step) const;
  double step_time(std::size_t step) const { return times.empty() ? 0 : times[step]; }
};

// Throws an Error at the first argument that is wrong; the surface is read last. call: RC_CALL_*; maps: of a caller that has the
// heights.
Problem make_problem(const SolveArguments& arguments, std::int32_t call, const rc_map* maps = nullptr, std::int64_t n_maps = 0);

}  // namespace cli
