#include "arguments/command_line.h"

#include <string>
#include <string_view>
#include <utility>

#include "arguments/shared_options.h"

namespace cli {

namespace {

constexpr const char* solve_help = R"(
Lengths, pressures and forces may have a unit with any SI prefix: 39nm, 210GPa, 1mN. Numbers without a unit are in m, Pa and N;
--unit gives another unit to lengths without one, also in the file. Results are in m, Pa and N.

A target is a number, a list a,b,c, or a range of n values: a..b:n with equal differences, a..b:nlog with equal ratios.
The approach is 0 when the highest point of the surface touches. E* is E/(1-nu^2), or with --E2 and --nu2 1/((1-nu^2)/E +
(1-nu2^2)/E2).

Exit code: 0 every step is certified, 1 wrong input or a failed call, 2 a step is not certified (its results are written, marked
by their status), 130 interrupted (a second signal ends it at once). --resume continues an interrupted history.
)";

Command solve_command(SolveArguments& arguments) {
  Command solve{"solve", "Press a rough surface against a flat half-space", solve_help};
  add_words(solve, arguments.words, RC_CALL_HISTORY);
  add_set(solve, arguments);
  add_budget_sources(solve, arguments);
  solve.add(
      "Output",
      {{"--out", &arguments.out, "DIR", "Folder for summary.json, steps.csv, pressure-K.npy, gap-K.npy, contact-K.png"},
       {"--no-maps", &arguments.no_maps, "", "Only summary.json, steps.csv and history.png: no arrays, no pictures of steps"},
       {"--no-pictures", &arguments.no_pictures, "", "No contact-K.png and history.png, which gnuplot draws"},
       {"--write", &arguments.write, "FORMATS", "Also write each step in these formats: vti, netcdf, hdf5"}});
  add_resume(solve, arguments);
  solve.add("Output", {{"--explain", &arguments.explain, "", "Print why auto chose its solver and backend"}});
  add_quiet(solve, arguments);
  return solve;
}

constexpr const char* report_help = R"(
SURFACE is a file of heights, which is solved with the words of solve (a single target becomes the last of ten steps), or the folder
that solve --out has written. The page has the steps, curves, maps, proven intervals and what was assumed. It is made by Python with
Jinja2 and Plotly (pip install 'roughcontact[report]').

Exit code: as of solve.
)";

Command report_command(CommandLine& line) {
  Command report{"report", "Write a page on a surface under load", report_help};
  add_words(report, line.report.words, RC_CALL_HISTORY);
  add_set(report, line.report);
  add_budget_sources(report, line.report);
  report.add("Output", {{"--out", &line.report.out, "PAGE", "The page to write (default report.html)"},
                        {"--law", &line.reported_law, "FILE", "Show this contact law of the surface, see roughcontact law"}});
  return report;
}

constexpr const char* generate_help = R"(
Lengths may have a unit, 39nm; numbers without one are in --unit. A .gsf file is in metres (float32). A .npy file (float64) is
in --unit and does not store its pitch: give the same --unit and --pitch when you read it. The same arguments give the same
surface at every call.
)";

constexpr std::pair<const char*, const char*> generate_kinds[] = {
    {"rmd", "Random midpoint displacement, self-affine on all scales"},
    {"spectral", "Periodic self-affine surface with cut-offs and roll-off"},
    {"sphere", "A sphere or paraboloid about the centre"},
    {"waves", "Sinusoidal waves along x, y or both"},
    {"pyramids", "Square pyramids or ridges"},
    {"noise", "Independent Gaussian heights"},
};

Command generate_command(GenerateArguments& arguments) {
  struct Setting {
    std::string_view kinds;  // kinds of surfaces that have it; "": all
    Option option;
  };
  const Setting settings[] = {
      {"", {"--output", &arguments.output, "FILE", "File to write, .npy or .gsf"}},
      {"spectral sphere waves pyramids noise", {"--size", &arguments.size, "N or NX,NY", "Grid points (default 256)"}},
      {"rmd", {"--levels", &arguments.levels, "K", "2^K points a side (default 8)"}},
      {"rmd", {"--stage", &arguments.stage, "S", "Write the coarser grid of 2^S points a side of the same surface"}},
      {"", {"--pitch", &arguments.pitch, "H or HX,HY", "Cell size (default 1; rmd: of the finest grid)"}},
      {"", {"--unit", &arguments.unit, "UNIT", "Unit of .npy files and of lengths without a unit: m (default), mm, um, nm, pm"}},
      {"rmd spectral noise", {"--seed", &arguments.seed, "N", "Random seed (default 1)"}},
      {"rmd spectral", {"--hurst", &arguments.hurst, "H", "Hurst exponent (default 0.7 for rmd, 0.8 for spectral)"}},
      {"rmd spectral noise", {"--rms-height", &arguments.rms_height, "LENGTH", "rms height (default 1 for rmd and noise)"}},
      {"spectral", {"--rms-slope", &arguments.rms_slope, "SLOPE", "rms slope (default 0.1 without --rms-height)"}},
      {"spectral", {"--longest", &arguments.longest, "LENGTH", "Longest wavelength (default: the surface's size)"}},
      {"spectral", {"--rolloff", &arguments.roll_off, "LENGTH", "Wavelength above which the spectrum is flat (default: none)"}},
      {"spectral", {"--shortest", &arguments.shortest, "LENGTH", "Shortest wavelength (default: two pitches)"}},
      {"sphere", {"--radius", &arguments.radius, "LENGTH", "Radius"}},
      {"waves pyramids", {"--height", &arguments.height, "LENGTH", "Amplitude of waves, height of pyramids (default 1)"}},
      {"waves pyramids", {"--period", &arguments.period, "P or PX,PY", "Period; 0: constant along this axis"}},
      {"rmd", {"--vertices", &arguments.vertices, "", "All 2^K + 1 points a side"}},
      {"rmd", {"--additions", &arguments.additions, "", "Random additions to all points at every stage"}},
      {"spectral", {"--fixed-amplitudes", &arguments.fixed_amplitudes, "", "Only phases are random"}},
      {"sphere", {"--paraboloid", &arguments.paraboloid, "", "z = -r^2/(2 R) instead of a sphere"}},
  };
  Command generate{"generate", "Make a surface and write it to a file", generate_help, true};
  for (const auto& [name, help] : generate_kinds) {
    Command& kind = generate.commands.emplace_back(Command{name, help, generate_help});
    for (const Setting& setting : settings) {
      if (setting.kinds.empty() || setting.kinds.find(name) != std::string_view::npos) kind.options.push_back(setting.option);
    }
  }
  return generate;
}

Command analyze_command(AnalyzeArguments& arguments) {
  Command analyze{"analyze", "Roughness parameters and spectrum of a surface, and advice on cmr"};
  add_words(analyze, arguments.words, RC_CALL_ANALYZE);
  analyze.add(
      "Options",
      {{"--levels", &arguments.levels, "K", "Halvings of the grid for the advice on cmr (default 4)"},
       {"--approach", &arguments.approach, "LENGTH", "Approach for the advice on cmr (default half the highest point's height)"},
       {"--json", &arguments.json, "FILE", "Write all numbers and the spectrum"},
       {"--picture", &arguments.picture, "FILE", "Draw the spectrum with the fitted range (PNG, needs gnuplot)"}});
  return analyze;
}

}  // namespace

Command whole_command(CommandLine& line) {
  return {.name = "roughcontact",
          .help = "Normal contact of rough surfaces on an elastic half-space, every answer certified",
          .commands = {solve_command(line.solve),
                       report_command(line),
                       generate_command(line.generate),
                       analyze_command(line.analyze),
                       law_command(line.law),
                       {"backends", "List the backends"},
                       {"solvers", "List the solvers"},
                       {"kernels", "List the influence kernels"},
                       {"options", "List every option with its type, default and range"},
                       {"formats", "List the formats of surface files"}}};
}

}  // namespace cli
