#include "solve/problem.h"

#include <algorithm>

#include "arguments/choices.h"
#include "arguments/quantities.h"
#include "arguments/targets.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "text.h"

namespace cli {

namespace {

using Text = std::optional<std::string>;

// E/(1 - nu^2) of one body; `which`: "" or "2", after the options' names.
double plane_modulus(const std::string& which, const Text& young_text, const Text& poisson_text) {
  const std::string young_name = "--E" + which, poisson_name = "--nu" + which;
  if (!young_text || !poisson_text) {
    throw Error(young_text ? poisson_name : young_name, " is missing, ", young_name, " and ", poisson_name, " go together");
  }
  const double young = read_positive(young_name, *young_text, Dimension::pressure).si();
  const double poisson = finite_number(poisson_name, *poisson_text);
  if (!(poisson > -1 && poisson <= 0.5)) throw Error(poisson_name, ": ", in_quotes(*poisson_text), " is not in (-1, 0.5]");
  return young / (1 - poisson * poisson);
}

double contact_modulus(const SolveArguments& arguments) {
  const bool one = arguments.young || arguments.poisson, other = arguments.young2 || arguments.poisson2;
  if (arguments.modulus && (one || other)) throw Error("give either --modulus or --E and --nu, not both");
  if (arguments.modulus) return read_positive("--modulus", *arguments.modulus, Dimension::pressure).si();
  if (!one && !other) throw Error("the elastic modulus is missing, give --modulus or --E and --nu");
  const double first = plane_modulus("", arguments.young, arguments.poisson);
  return other ? 1 / (1 / first + 1 / plane_modulus("2", arguments.young2, arguments.poisson2)) : first;
}

int32_t named_boundary(const Text& name) {
  if (!name) return 0;
  return RC_BOUNDARY_FREE + static_cast<int32_t>(choice("--boundary", *name, boundary_names));
}

void set_targets(const SolveArguments& arguments, double unit, Problem& problem) {
  struct Control {
    const char* name;
    const std::optional<std::string>& text;
    Dimension dimension;
    double unit;
  };
  const Control controls[] = {{"approach", arguments.approach, Dimension::length, unit},
                              {"load", arguments.load, Dimension::force, 1},
                              {"pressure", arguments.pressure, Dimension::pressure, 1},
                              {"area", arguments.area, Dimension::share, 1}};

  for (const auto& [name, text, dimension, alone] : controls) {
    if (!text) continue;
    if (!problem.control.empty()) throw Error("give only one of --", problem.control, " and --", name);
    problem.control = name;
    problem.targets = parse_targets("--" + problem.control, *text, dimension, alone);
  }
  if (problem.control == "area" && std::ranges::max(problem.targets) > 1)
    throw Error("--area: ", in_quotes(*arguments.area), " is more than the whole, give a share as 10% or 0.1");
  if (problem.control.empty()) throw Error("what to press with is missing, give --approach, --load or --pressure");
}

void set_options(const SolveArguments& arguments, Problem& problem) {
  if (arguments.out) problem.options.emplace_back(RC_OPT_RESUMABLE, "1");
  const std::pair<const char*, const std::optional<std::string>&> named[] = {{RC_OPT_KERNEL, arguments.kernel},
                                                                             {RC_OPT_SOLVER, arguments.solver},
                                                                             {RC_OPT_BACKEND, arguments.backend},
                                                                             {RC_OPT_TOL, arguments.tol},
                                                                             {RC_OPT_THREADS, arguments.threads}};
  for (const auto& [key, text] : named) {
    if (text) problem.options.emplace_back(key, *text);
  }
  for (const std::string& assignment : arguments.set) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) throw Error("--set: ", in_quotes(assignment), " has not the form key=value");
    problem.options.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
}

// A unit left out or a prefix mistaken: "150" for 150 MPa. The library has no units and cannot know.
void doubt_pressures(const SolveArguments& arguments, SurfaceInput& input) {
  struct Doubt {
    const char* option;
    const Text& text;
    double least;  // [Pa]; the softest gels and solids have more
  };
  const Doubt doubts[] = {{"--E", arguments.young, 1e2},
                          {"--E2", arguments.young2, 1e2},
                          {"--modulus", arguments.modulus, 1e2},
                          {"--hardness", arguments.hardness, 1e6}};
  for (const auto& [option, text, least] : doubts) {
    if (!text) continue;
    const double value = read_positive(option, *text, Dimension::pressure).si();
    if (value < least)
      input.notes.push_back(std::string("remark: ") + option + " is " + with_prefix(value, "Pa") + ", below " +
                            with_prefix(least, "Pa") + ": check its unit, a number alone is in Pa");
  }
}

}  // namespace

int32_t Problem::step_control() const {
  if (control == "approach") return RC_CONTROL_APPROACH;
  if (control == "load") return RC_CONTROL_LOAD;
  return control == "area" ? RC_CONTROL_AREA : RC_CONTROL_PRESSURE;
}

double Problem::step_target(std::size_t step) const {
  if (control != "area") return targets[step];
  return targets[step] * static_cast<double>(system.nx) * static_cast<double>(system.ny) * system.hx * system.hy;
}

Problem problem_without_surface(const SolveArguments& arguments) {
  Problem problem;
  problem.system = RC_SYSTEM_INIT;
  const double unit = unit_of(arguments.surface);
  problem.system.modulus = contact_modulus(arguments);
  if (arguments.hardness) problem.system.hardness = read_positive("--hardness", *arguments.hardness, Dimension::pressure).si();
  problem.system.boundary = named_boundary(arguments.boundary);
  set_targets(arguments, unit, problem);
  set_options(arguments, problem);
  return problem;
}

void settle_boundary(Problem& problem) {
  int32_t& boundary = problem.system.boundary;
  SurfaceInput& input = problem.input;
  const std::optional<bool> periodic = input.surface.periodic;
  if (boundary != 0) return;
  if (!input.shape.empty()) {
    boundary = RC_BOUNDARY_FREE;
  } else if (periodic == false) {
    boundary = RC_BOUNDARY_FREE;
    input.notes.emplace_back(
        "note: boundary free, the file says that the surface does not repeat; --boundary periodic if it is a sample of a larger "
        "one");
  } else {
    boundary = RC_BOUNDARY_PERIODIC;
    if (periodic) return;
    input.notes.emplace_back(
        "note: boundary periodic, the map is taken as a sample of a larger surface; --boundary free if the body ends at its "
        "edges");
  }
}

Problem make_problem(const SolveArguments& arguments) {
  Problem problem = problem_without_surface(arguments);
  problem.options.insert(problem.options.begin(), {RC_OPT_STIFFNESS, "1"});
  problem.input = read_input(arguments.surface, true);
  doubt_pressures(arguments, problem.input);
  const Surface& surface = problem.input.surface;
  problem.system.hx = *surface.hx;
  problem.system.hy = *surface.hy;
  problem.system.nx = surface.nx;
  problem.system.ny = surface.ny;
  settle_boundary(problem);
  return problem;
}

}  // namespace cli
