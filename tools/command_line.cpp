#include "command_line.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "solve_options.h"

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

void add_solve(CLI::App& app, SolveArguments& arguments) {
  CLI::App* solve = app.add_subcommand("solve", "Press a rough surface against a flat half-space");
  solve->footer(solve_help);
  add_surface(*solve, arguments.surface, "Missing points: reject (default), fill (interpolate) or exclude (from contact)");
  add_other_body(*solve, arguments.surface);
  solve->add_option("--shape", arguments.surface.shape, "Added: sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x")
      ->type_name("SHAPE")
      ->group("Surface");
  add_loading(*solve, arguments);
  add_method(*solve, arguments, "Threads; all cores that the process may use");

  solve->add_option("--out", arguments.out, "Folder for summary.json, steps.csv, pressure-K.npy, gap-K.npy, contact-K.png")
      ->type_name("DIR")
      ->group("Output");
  solve->add_option("--write", arguments.write, "Each step also as a file of these: vti, netcdf, hdf5")
      ->type_name("FORMATS")
      ->group("Output");
  add_resume(*solve, arguments);
  solve->add_flag("--explain", arguments.explain, "Say why auto chose its solver and backend")->group("Output");
  add_quiet(*solve, arguments);
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
  add_surface(*analyze, arguments.surface, "Missing points: reject (default) or fill (interpolate)");
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
