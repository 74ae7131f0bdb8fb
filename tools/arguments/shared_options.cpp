#include "arguments/shared_options.h"

namespace cli {

void add_surface(Command& command, SurfaceArguments& surface, const char* missing_help, bool rows) {
  const char* const file_help = rows ? "File of heights, .npy" : "File of heights, see roughcontact formats";
  command.options.push_back({"SURFACE", &surface.file, "TEXT", file_help});
  if (!rows) {
    command.add("Surface", {{"--format", &surface.format, "NAME", "File format, if neither contents nor extension shows it"}});
  }
  command.add("Surface", {{"--pitch", &surface.pitch, "H or HX,HY", "Cell size of a file that has none"},
                          {"--unit", &surface.unit, "UNIT",
                           "Unit of lengths without a unit, on the command line and in files: m (default), mm, um, nm, A"},
                          {"--missing", &surface.missing, "RULE", missing_help}});
  if (!rows) {
    command.add("Surface",
                {{"--remove", &surface.remove, "FORM", "Level the map first: none (default), mean, plane or quadric"}});
  }
}

void add_other_body(Command& command, SurfaceArguments& surface) {
  command.add("Surface",
              {{"--against", &surface.against, "FILE", "Second rough body: heights on the same grid, seen from the first"}});
}

void add_shape(Command& command, SurfaceArguments& surface) {
  command.add("Surface", {{"--shape", &surface.shape, "SHAPE",
                           "Add a nominal shape: sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x"}});
}

void add_elasticity(Command& command, SolveArguments& arguments) {
  command.add("Elasticity (--modulus, or --E and --nu)",
              {{"--modulus", &arguments.modulus, "E*", "Contact modulus"},
               {"--E", &arguments.young, "E", "Young's modulus"},
               {"--nu", &arguments.poisson, "NU", "Poisson's ratio"},
               {"--E2", &arguments.young2, "E", "Young's modulus of the other body (default: rigid)"},
               {"--nu2", &arguments.poisson2, "NU", "Poisson's ratio of the other body"},
               {"--hardness", &arguments.hardness, "H", "Largest pressure; above it the surface yields (default: elastic)"}});
}

void add_loading(Command& command, SolveArguments& arguments) {
  add_elasticity(command, arguments);
  command.add("Loading (one of)",
              {{"--approach", &arguments.approach, "TARGETS", "Approach from first touch of the highest point"},
               {"--load", &arguments.load, "TARGETS", "Normal force"},
               {"--pressure", &arguments.pressure, "TARGETS", "Mean pressure over the whole surface"}});
  add_boundary(command, arguments);
}

void add_boundary(Command& command, SolveArguments& arguments) {
  command.add("Method", {{"--boundary", &arguments.boundary, "NAME",
                          "periodic: the map is a sample of a larger surface; free: the body ends at its edges; periodic-x, "
                          "periodic-y: it repeats along this axis only (default: as the file says; free with a --shape; else "
                          "periodic)"}});
}

void add_method(Command& command, SolveArguments& arguments, const char* threads_help) {
  command.add("Method", {{"--kernel", &arguments.kernel, "NAME", "Influence kernel, see roughcontact kernels"},
                         {"--solver", &arguments.solver, "NAME", "Solver, see roughcontact solvers"},
                         {"--backend", &arguments.backend, "NAME", "Backend, see roughcontact backends"},
                         {"--tol", &arguments.tol, "TOL", "Convergence tolerance, relative (default 1e-8)"},
                         {"--threads", &arguments.threads, "N", threads_help},
                         {"--set", &arguments.set, "KEY=VALUE", "Any option, see roughcontact options; may be repeated"}});
}

void add_resume(Command& command, SolveArguments& arguments) {
  command.add("Output", {{"--resume", &arguments.resume, "", "Continue the earlier run in --out after its last finished step"}});
}

void add_quiet(Command& command, SolveArguments& arguments) {
  command.add("Output", {{"--quiet", &arguments.quiet, "", "No table and no progress"}});
}

}  // namespace cli
