#include "command_line.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cli {

namespace {

constexpr const char* solve_help = R"(
Lengths, pressures and forces may have a unit with any SI prefix: 39nm, 210GPa, 1mN. Numbers alone are in m (or --unit, as are
the lengths of files that name no unit), Pa and N. Results are in m, Pa and N.

A target is a number, a list a,b,c or a range a:b:n of n points. The highest point of the surface touches first; the approach is
counted from there. E* is E/(1-nu^2), or with
--E2 and --nu2 1/((1-nu^2)/E + (1-nu2^2)/E2).

Exit code: 0 every step is certified, 1 wrong input or a failed call, 2 a step is not certified (its results are written, marked by
their status), 130 interrupted (a second signal ends it at once). With --resume an interrupted history goes on.
)";

void add_surface(CLI::App* command, SurfaceArguments& surface, const char* missing_help) {
  command->add_option("SURFACE", surface.file, "File of heights, see roughcontact formats")->required();
  const auto option = [command](const char* name, auto& value, const char* type, const char* help) {
    command->add_option(name, value, help)->type_name(type)->group("Surface");
  };
  option("--format", surface.format, "NAME", "Format of the file, where contents and extension do not say it");
  option("--pitch", surface.pitch, "H or HX,HY", "Cell size, where the file does not say it");
  option("--unit", surface.unit, "UNIT", "Unit of lengths without one: m (default), mm, um, nm, pm");
  option("--missing", surface.missing, "RULE", missing_help);
  option("--remove", surface.remove, "FORM", "Least-squares form to take off: none (default), mean, plane or quadric");
}

void add_solve(CLI::App& app, SolveArguments& arguments) {
  CLI::App* solve = app.add_subcommand("solve", "Press a rough surface against a flat half-space");
  solve->footer(solve_help);
  add_surface(solve, arguments.surface, "Missing points: reject (default), fill (interpolate) or exclude (from contact)");

  solve->add_option("--against", arguments.surface.against, "Heights of the other body on the same grid, towards the first")
      ->type_name("FILE")
      ->group("Surface");
  solve->add_option("--shape", arguments.surface.shape, "Added: sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x")
      ->type_name("SHAPE")
      ->group("Surface");

  const auto option = [solve](const char* name, auto& value, const char* type, const char* help, const char* group) {
    return solve->add_option(name, value, help)->type_name(type)->group(group);
  };
  option("--modulus", arguments.modulus, "E*", "Contact modulus", "Elasticity (--modulus, or --E and --nu)");
  option("--E", arguments.young, "E", "Young's modulus", "Elasticity (--modulus, or --E and --nu)");
  option("--nu", arguments.poisson, "NU", "Poisson's ratio", "Elasticity (--modulus, or --E and --nu)");
  option("--E2", arguments.young2, "E", "Young's modulus of the other body; rigid without",
         "Elasticity (--modulus, or --E and --nu)");
  option("--nu2", arguments.poisson2, "NU", "Poisson's ratio of the other body", "Elasticity (--modulus, or --E and --nu)");
  option("--hardness", arguments.hardness, "H", "Largest pressure; above it the surface yields. None: elastic",
         "Elasticity (--modulus, or --E and --nu)");

  option("--displacement", arguments.displacement, "TARGETS", "Approach from first touch of the highest point",
         "Loading (one of)");
  option("--load", arguments.load, "TARGETS", "Normal force", "Loading (one of)");
  option("--pressure", arguments.pressure, "TARGETS", "Mean pressure over the whole surface", "Loading (one of)");

  option("--boundary", arguments.boundary, "NAME", "free (default) or periodic", "Method");
  option("--kernel", arguments.kernel, "NAME", "Influence kernel, see roughcontact kernels", "Method");
  option("--solver", arguments.solver, "NAME", "Solver, see roughcontact solvers", "Method");
  option("--backend", arguments.backend, "NAME", "Backend, see roughcontact backends", "Method");
  option("--tol", arguments.tol, "TOL", "Largest relative residual of a certified step", "Method");
  option("--threads", arguments.threads, "N", "Threads; all cores that the process may use", "Method");
  option("--set", arguments.set, "KEY=VALUE", "Any option, see roughcontact options; may be repeated", "Method")
      ->expected(1)
      ->take_all();

  option("--out", arguments.out, "DIR", "Folder for summary.json, steps.csv, pressure-K.npy, gap-K.npy, contact-K.png", "Output");
  option("--write", arguments.write, "FORMATS", "Each step also as a file of these: vti, netcdf, hdf5", "Output");
  solve->add_flag("--resume", arguments.resume, "Go on after the steps that an earlier run into --out has finished")
      ->group("Output");
  solve->add_flag("--explain", arguments.explain, "Say why auto chose its solver and backend")->group("Output");
  solve->add_flag("--quiet", arguments.quiet, "No table and no progress")->group("Output");
}

constexpr const char* generate_help = R"(
Lengths may have a unit, 39nm; numbers alone are in --unit. A .gsf file is in metres (float32); a .npy file (float64) is in --unit and does not say its pitch: give the
same --unit and --pitch where it is read. The same arguments give the same surface at every call.
)";

struct Setting {
  const char* kinds;  // kinds of surfaces that have it; "": all
  const char* name;
  std::optional<std::string> GenerateArguments::*value;
  const char* type;
  const char* help;
};

constexpr Setting generate_settings[] = {
    {"spectral sphere waves pyramids noise", "--size", &GenerateArguments::size, "N or NX,NY", "Points, 256"},
    {"rmd", "--levels", &GenerateArguments::levels, "K", "2^K points a side, 8"},
    {"rmd", "--stage", &GenerateArguments::stage, "S", "The coarser grid of 2^S points a side of the same surface"},
    {"", "--pitch", &GenerateArguments::pitch, "H or HX,HY", "Cell size, 1 (rmd: of the finest grid)"},
    {"", "--unit", &GenerateArguments::unit, "UNIT",
     "Unit of .npy files and of lengths without one: m (default), mm, um, nm, pm"},
    {"rmd spectral noise", "--seed", &GenerateArguments::seed, "N", "Number of the surface, 1"},
    {"rmd spectral", "--hurst", &GenerateArguments::hurst, "H", "Hurst exponent, 0.7 (rmd) or 0.8 (spectral)"},
    {"rmd spectral noise", "--rms-height", &GenerateArguments::rms_height, "LENGTH", "rms height, 1 (rmd, noise)"},
    {"spectral", "--rms-slope", &GenerateArguments::rms_slope, "SLOPE", "rms slope, 0.1 without --rms-height"},
    {"spectral", "--longest", &GenerateArguments::longest, "LENGTH", "Longest wavelength; the surface's size"},
    {"spectral", "--rolloff", &GenerateArguments::roll_off, "LENGTH", "Wavelength above which the spectrum is flat; none"},
    {"spectral", "--shortest", &GenerateArguments::shortest, "LENGTH", "Shortest wavelength; two pitches"},
    {"sphere", "--radius", &GenerateArguments::radius, "LENGTH", "Radius"},
    {"waves pyramids", "--height", &GenerateArguments::height, "LENGTH", "Amplitude of waves, height of pyramids, 1"},
    {"waves pyramids", "--period", &GenerateArguments::period, "P or PX,PY", "Period; 0: none along this direction"},
};

constexpr std::pair<const char*, const char*> generate_kinds[] = {
    {"rmd", "Random midpoint displacement, self-affine on all scales"},
    {"spectral", "Periodic self-affine surface with cut-offs and roll-off"},
    {"sphere", "A sphere or paraboloid about the centre"},
    {"waves", "Sinusoidal waves along x, y or both"},
    {"pyramids", "Square pyramids or ridges"},
    {"noise", "Independent Gaussian heights"},
};

void add_generate(CLI::App& app, GenerateArguments& arguments) {
  CLI::App* generate = app.add_subcommand("generate", "Make a surface and write it to a file");
  generate->require_subcommand(1);
  generate->footer(generate_help);
  for (const auto& [name, help] : generate_kinds) {
    CLI::App* kind = generate->add_subcommand(name, help);
    kind->footer(generate_help);
    kind->add_option("--output", arguments.output, "File to write, .npy or .gsf")->type_name("FILE")->required();
    for (const Setting& setting : generate_settings) {
      const std::string_view kinds = setting.kinds;
      if (!kinds.empty() && kinds.find(name) == std::string_view::npos) continue;
      kind->add_option(setting.name, arguments.*setting.value, setting.help)->type_name(setting.type);
    }
    const std::string_view which = name;
    if (which == "rmd") {
      kind->add_flag("--vertices", arguments.vertices, "All 2^K + 1 points a side");
      kind->add_flag("--additions", arguments.additions, "Random additions to all points at every stage");
    }
    if (which == "spectral") kind->add_flag("--fixed-amplitudes", arguments.fixed_amplitudes, "Only phases are random");
    if (which == "sphere") kind->add_flag("--paraboloid", arguments.paraboloid, "z = -r^2/(2 R) instead of a sphere");
  }
}

void add_analyze(CLI::App& app, AnalyzeArguments& arguments) {
  CLI::App* analyze = app.add_subcommand("analyze", "Roughness parameters and spectrum of a surface, and advice on cmr");
  add_surface(analyze, arguments.surface, "Missing points: reject (default) or fill (interpolate)");
  const auto option = [analyze](const char* name, auto& value, const char* type, const char* help) {
    analyze->add_option(name, value, help)->type_name(type);
  };
  analyze->add_flag("--periodic", arguments.periodic, "The surface repeats: no window, only the mean is removed");
  option("--levels", arguments.levels, "K", "Halvings of the grid to judge cmr for, 4");
  option("--approach", arguments.approach, "LENGTH", "Approach to judge cmr for; half the highest point's height");
  option("--json", arguments.json, "FILE", "Write all numbers and the spectrum");
  option("--picture", arguments.picture, "FILE", "Draw the spectrum with the fitted range (PNG, needs gnuplot)");
}

}  // namespace

void add_commands(CLI::App& app, CommandLine& line) {
  app.require_subcommand(0, 1);
  add_solve(app, line.solve);
  add_generate(app, line.generate);
  add_analyze(app, line.analyze);
  app.add_subcommand("backends", "List the backends");
  app.add_subcommand("solvers", "List the solvers");
  app.add_subcommand("kernels", "List the influence kernels");
  app.add_subcommand("options", "List every option with its type, default and range");
  app.add_subcommand("formats", "List the formats of surface files");
}

}  // namespace cli
