#include "problem.h"

#include <algorithm>
#include <cmath>

#include "error.h"
#include "numbers.h"
#include "targets.h"
#include "text.h"
#include "units.h"

namespace cli {

namespace {

double positive_number(std::string_view option, std::string_view text) {
  const double value = finite_number(option, text);
  if (!(value > 0)) throw Error(std::string(option) + ": " + in_quotes(text) + " is not positive");
  return value;
}

double length_unit(const std::optional<std::string>& name) {
  if (!name) return 1;
  if (const auto metres = metres_per(*name)) return *metres;
  throw Error("--unit: " + in_quotes(*name) + " is not a length unit, give m, mm, um, nm or pm");
}

double contact_modulus(const SolveArguments& arguments) {
  if (arguments.modulus && (arguments.young || arguments.poisson)) throw Error("give either --modulus or --E and --nu, not both");
  if (arguments.modulus) return positive_number("--modulus", *arguments.modulus);
  if (!arguments.young && !arguments.poisson) throw Error("the elastic modulus is missing, give --modulus or --E and --nu");
  if (!arguments.young || !arguments.poisson) {
    throw Error(std::string(arguments.young ? "--nu" : "--E") + " is missing, --E and --nu go together");
  }

  const double young = positive_number("--E", *arguments.young);
  const double poisson = finite_number("--nu", *arguments.poisson);
  if (!(poisson > -1 && poisson <= 0.5)) throw Error("--nu: " + in_quotes(*arguments.poisson) + " is not in (-1, 0.5]");
  return young / (1 - poisson * poisson);
}

int32_t boundary(const std::optional<std::string>& name) {
  if (!name || *name == "free") return RC_BOUNDARY_FREE;
  if (*name == "periodic") return RC_BOUNDARY_PERIODIC;
  throw Error("--boundary: " + in_quotes(*name) + " is not known, give free or periodic");
}

void set_targets(const SolveArguments& arguments, double unit, Problem& problem) {
  struct Control {
    const char* name;
    const std::optional<std::string>& text;
    double scale;
  };
  const Control controls[] = {
      {"displacement", arguments.displacement, unit}, {"load", arguments.load, 1}, {"pressure", arguments.pressure, 1}};

  for (const auto& [name, text, scale] : controls) {
    if (!text) continue;
    if (!problem.control.empty()) throw Error("give only one of --" + problem.control + " and --" + name);
    problem.control = name;
    problem.targets = parse_targets("--" + problem.control, *text);
    for (double& target : problem.targets) target *= scale;
  }
  if (problem.control.empty()) throw Error("what to press with is missing, give --displacement, --load or --pressure");
}

void set_options(const SolveArguments& arguments, Problem& problem) {
  problem.options.emplace_back(RC_OPT_STIFFNESS, "1");
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

struct Pitch {
  double x, y;
};

std::optional<Pitch> pitch_argument(const std::optional<std::string>& text, double unit) {
  if (!text) return std::nullopt;
  const auto parts = split(*text, ',');
  if (parts.size() > 2)
    throw Error("--pitch: " + in_quotes(*text) + " has " + std::to_string(parts.size()) + " numbers, give H or HX,HY");
  return Pitch{unit * positive_number("--pitch", parts.front()), unit * positive_number("--pitch", parts.back())};
}

void set_pitch(const std::optional<Pitch>& given, Problem& problem) {
  Surface& surface = problem.surface;
  const bool in_file = surface.hx && surface.hy;
  if (!given && !in_file) throw Error(problem.file + ": the file does not say its pitch, give --pitch H or --pitch HX,HY");
  if (given && in_file) {
    problem.note = format("note: --pitch is used instead of the pitch %g m, %g m of the file", *surface.hx, *surface.hy);
  }
  if (given) {
    surface.hx = given->x;
    surface.hy = given->y;
  }
  problem.system.hx = *surface.hx;
  problem.system.hy = *surface.hy;
}

}  // namespace

int32_t Problem::step_control() const { return control == "displacement" ? RC_CONTROL_DISPLACEMENT : RC_CONTROL_LOAD; }

double Problem::step_target(std::size_t step) const {
  if (control != "pressure") return targets[step];
  return targets[step] * static_cast<double>(system.nx) * static_cast<double>(system.ny) * system.hx * system.hy;
}

Problem make_problem(const SolveArguments& arguments) {
  Problem problem;
  rc_system_init(&problem.system);
  const double unit = length_unit(arguments.unit);
  problem.system.modulus = contact_modulus(arguments);
  problem.system.boundary = boundary(arguments.boundary);
  set_targets(arguments, unit, problem);
  set_options(arguments, problem);
  const auto given_pitch = pitch_argument(arguments.pitch, unit);

  problem.file = arguments.surface;
  problem.surface = read_surface(problem.file, unit);
  set_pitch(given_pitch, problem);
  problem.system.nx = problem.surface.nx;
  problem.system.ny = problem.surface.ny;
  return problem;
}

std::vector<double> gap_below_highest_point(const Surface& surface) {
  const double highest = *std::ranges::max_element(surface.heights);
  std::vector<double> gap;
  gap.reserve(surface.heights.size());
  for (const double z : surface.heights) gap.push_back(highest - z);
  return gap;
}

}  // namespace cli
