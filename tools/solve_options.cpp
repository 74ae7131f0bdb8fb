#include "solve_options.h"

#include <CLI/CLI.hpp>

namespace cli {

namespace {

struct Group {
  CLI::App& command;
  const char* name;

  CLI::Option* operator()(const char* option, auto& value, const char* type, const char* help) const {
    return command.add_option(option, value, help)->type_name(type)->group(name);
  }
};

}  // namespace

void add_surface(CLI::App& command, SurfaceArguments& surface, const char* missing_help, bool rows) {
  command.add_option("SURFACE", surface.file, rows ? "File of heights, .npy" : "File of heights, see roughcontact formats")
      ->required();
  const Group option{command, "Surface"};
  if (!rows) option("--format", surface.format, "NAME", "Format of the file, where contents and extension do not say it");
  option("--pitch", surface.pitch, "H or HX,HY", "Cell size, where the file does not say it");
  option("--unit", surface.unit, "UNIT", "Unit of lengths without one: m (default), mm, um, nm, pm");
  option("--missing", surface.missing, "RULE", missing_help);
  if (!rows) option("--remove", surface.remove, "FORM", "Least-squares form to take off: none (default), mean, plane or quadric");
}

void add_other_body(CLI::App& command, SurfaceArguments& surface) {
  const Group option{command, "Surface"};
  option("--against", surface.against, "FILE", "Heights of the other body on the same grid, towards the first");
}

void add_loading(CLI::App& command, SolveArguments& arguments) {
  const Group elasticity{command, "Elasticity (--modulus, or --E and --nu)"};
  elasticity("--modulus", arguments.modulus, "E*", "Contact modulus");
  elasticity("--E", arguments.young, "E", "Young's modulus");
  elasticity("--nu", arguments.poisson, "NU", "Poisson's ratio");
  elasticity("--E2", arguments.young2, "E", "Young's modulus of the other body; rigid without");
  elasticity("--nu2", arguments.poisson2, "NU", "Poisson's ratio of the other body");
  elasticity("--hardness", arguments.hardness, "H", "Largest pressure; above it the surface yields. None: elastic");

  const Group loading{command, "Loading (one of)"};
  loading("--displacement", arguments.displacement, "TARGETS", "Approach from first touch of the highest point");
  loading("--load", arguments.load, "TARGETS", "Normal force");
  loading("--pressure", arguments.pressure, "TARGETS", "Mean pressure over the whole surface");

  Group{command, "Method"}("--boundary", arguments.boundary, "NAME", "free (default) or periodic");
}

void add_method(CLI::App& command, SolveArguments& arguments, const char* threads_help) {
  const Group option{command, "Method"};
  option("--kernel", arguments.kernel, "NAME", "Influence kernel, see roughcontact kernels");
  option("--solver", arguments.solver, "NAME", "Solver, see roughcontact solvers");
  option("--backend", arguments.backend, "NAME", "Backend, see roughcontact backends");
  option("--tol", arguments.tol, "TOL", "Largest relative residual of a certified step");
  option("--threads", arguments.threads, "N", threads_help);
  option("--set", arguments.set, "KEY=VALUE", "Any option, see roughcontact options; may be repeated")->expected(1)->take_all();
}

void add_resume(CLI::App& command, SolveArguments& arguments) {
  command.add_flag("--resume", arguments.resume, "Go on after the steps that an earlier run into --out has finished")
      ->group("Output");
}

void add_quiet(CLI::App& command, SolveArguments& arguments) {
  command.add_flag("--quiet", arguments.quiet, "No table and no progress")->group("Output");
}

}  // namespace cli
