#include "problem.h"

#include "choices.h"
#include "error.h"
#include "numbers.h"
#include "quantities.h"
#include "targets.h"
#include "text.h"

namespace cli {

namespace {

double contact_modulus(const SolveArguments& arguments) {
  if (arguments.modulus && (arguments.young || arguments.poisson)) throw Error("give either --modulus or --E and --nu, not both");
  if (arguments.modulus) return read_positive("--modulus", *arguments.modulus, Dimension::pressure).si();
  if (!arguments.young && !arguments.poisson) throw Error("the elastic modulus is missing, give --modulus or --E and --nu");
  if (!arguments.young || !arguments.poisson) {
    throw Error(std::string(arguments.young ? "--nu" : "--E") + " is missing, --E and --nu go together");
  }

  const double young = read_positive("--E", *arguments.young, Dimension::pressure).si();
  const double poisson = finite_number("--nu", *arguments.poisson);
  if (!(poisson > -1 && poisson <= 0.5)) throw Error("--nu: " + in_quotes(*arguments.poisson) + " is not in (-1, 0.5]");
  return young / (1 - poisson * poisson);
}

int32_t boundary(const std::optional<std::string>& name) {
  return name && choice("--boundary", *name, boundary_names) == 1 ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
}

void set_targets(const SolveArguments& arguments, double unit, Problem& problem) {
  struct Control {
    const char* name;
    const std::optional<std::string>& text;
    Dimension dimension;
    double unit;
  };
  const Control controls[] = {{"displacement", arguments.displacement, Dimension::length, unit},
                              {"load", arguments.load, Dimension::force, 1},
                              {"pressure", arguments.pressure, Dimension::pressure, 1}};

  for (const auto& [name, text, dimension, alone] : controls) {
    if (!text) continue;
    if (!problem.control.empty()) throw Error("give only one of --" + problem.control + " and --" + name);
    problem.control = name;
    problem.targets = parse_targets("--" + problem.control, *text, dimension, alone);
  }
  if (problem.control.empty()) throw Error("what to press with is missing, give --displacement, --load or --pressure");
}

void set_options(const SolveArguments& arguments, Problem& problem) {
  problem.options.emplace_back(RC_OPT_STIFFNESS, "1");
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
    if (equals == std::string::npos || equals == 0)
      throw Error("--set: " + in_quotes(assignment) + " has not the form key=value");
    problem.options.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
}

}  // namespace

int32_t Problem::step_control() const { return control == "displacement" ? RC_CONTROL_DISPLACEMENT : RC_CONTROL_LOAD; }

double Problem::step_target(std::size_t step) const {
  if (control != "pressure") return targets[step];
  return targets[step] * static_cast<double>(system.nx) * static_cast<double>(system.ny) * system.hx * system.hy;
}

Problem make_problem(const SolveArguments& arguments) {
  Problem problem;
  problem.system = RC_SYSTEM_INIT;
  const double unit = unit_of(arguments.surface);
  problem.system.modulus = contact_modulus(arguments);
  problem.system.boundary = boundary(arguments.boundary);
  set_targets(arguments, unit, problem);
  set_options(arguments, problem);

  problem.input = read_input(arguments.surface, true);
  const Surface& surface = problem.input.surface;
  problem.system.hx = *surface.hx;
  problem.system.hy = *surface.hy;
  problem.system.nx = surface.nx;
  problem.system.ny = surface.ny;
  return problem;
}

}  // namespace cli
