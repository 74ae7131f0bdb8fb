// The command `roughcontact`: arguments in, exit code out.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "list_commands.h"
#include "solve_command.h"
#include "text.h"

namespace {

constexpr const char* solve_help = R"(
Lengths on the command line, and in files that name no unit, are in --unit. Results are in metres and in the unit of the modulus:
with E in Pa, pressures are in Pa and forces in N.

A target is a number, a list a,b,c or a range a:b:n of n points. The highest point of the surface touches first; displacement is
counted from there. The modulus E* is E/(1-nu^2), the other body being rigid.

Exit code: 0 every step is certified, 1 wrong input or a failed call, 2 a step is not certified (its results are written, marked by
their status), 130 interrupted.
)";

std::string version() {
  int32_t major = 0, minor = 0, patch = 0, abi = 0;
  rc_version(&major, &minor, &patch, &abi);
  return cli::format("roughcontact %d.%d.%d (ABI %d)", major, minor, patch, abi);
}

void add_solve(CLI::App& app, cli::SolveArguments& arguments) {
  CLI::App* solve = app.add_subcommand("solve", "Press a rough surface against a flat half-space");
  solve->footer(solve_help);
  solve->add_option("SURFACE", arguments.surface, "Heights: .gsf, .npy or a text matrix")->required();

  const auto option = [solve](const char* name, auto& value, const char* type, const char* help, const char* group) {
    return solve->add_option(name, value, help)->type_name(type)->group(group);
  };
  option("--pitch", arguments.pitch, "H or HX,HY", "Cell size, where the file does not say it", "Surface");
  option("--unit", arguments.unit, "UNIT", "Unit of lengths: m (default), mm, um, nm, pm", "Surface");

  option("--modulus", arguments.modulus, "E*", "Contact modulus", "Elasticity (--modulus, or --E and --nu)");
  option("--E", arguments.young, "E", "Young's modulus", "Elasticity (--modulus, or --E and --nu)");
  option("--nu", arguments.poisson, "NU", "Poisson's ratio", "Elasticity (--modulus, or --E and --nu)");

  option("--displacement", arguments.displacement, "TARGETS", "Approach from first touch of the highest point",
         "Loading (one of)");
  option("--load", arguments.load, "TARGETS", "Normal force", "Loading (one of)");
  option("--pressure", arguments.pressure, "TARGETS", "Mean pressure over the whole surface", "Loading (one of)");

  option("--boundary", arguments.boundary, "NAME", "free (default) or periodic", "Method");
  option("--kernel", arguments.kernel, "NAME", "Influence kernel, see roughcontact kernels", "Method");
  option("--solver", arguments.solver, "NAME", "Solver, see roughcontact solvers", "Method");
  option("--backend", arguments.backend, "NAME", "Backend, see roughcontact backends", "Method");
  option("--tol", arguments.tol, "TOL", "Largest relative residual of a certified step", "Method");
  option("--threads", arguments.threads, "N", "Threads a backend may use", "Method");
  option("--set", arguments.set, "KEY=VALUE", "Any option, see roughcontact options; may be repeated", "Method")
      ->expected(1)
      ->take_all();

  option("--out", arguments.out, "DIR", "Folder for summary.json, pressure-K.npy, gap-K.npy and contact-K.png", "Output");
  solve->add_flag("--quiet", arguments.quiet, "No table and no progress")->group("Output");
}

int run(int argc, char** argv) {
  CLI::App app{"Normal contact of rough surfaces on an elastic half-space, every answer certified", "roughcontact"};
  app.set_version_flag("--version", version());
  app.require_subcommand(0, 1);
  cli::SolveArguments arguments;
  add_solve(app, arguments);
  app.add_subcommand("backends", "List the backends");
  app.add_subcommand("solvers", "List the solvers");
  app.add_subcommand("kernels", "List the influence kernels");
  app.add_subcommand("options", "List every option with its type, default and range");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    cli::report(std::string(error.what()) + "; see roughcontact --help or roughcontact solve --help");
    return cli::exit_error;
  }

  if (app.got_subcommand("solve")) return cli::run_solve(arguments);
  if (app.got_subcommand("backends")) cli::list_backends();
  if (app.got_subcommand("solvers")) cli::list_solvers();
  if (app.got_subcommand("kernels")) cli::list_kernels();
  if (app.got_subcommand("options")) cli::list_options();
  if (app.get_subcommands().empty()) {
    cli::report("no command given, give solve, backends, solvers, kernels or options; see roughcontact --help");
    return cli::exit_error;
  }
  return cli::exit_certified;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    cli::report("out of memory");
  } catch (const std::exception& error) {
    cli::report(error.what());
  }
  return cli::exit_error;
}
