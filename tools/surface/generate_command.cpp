#include "surface/generate_command.h"

#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "files/array_files.h"
#include "files/outputs.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/surface.h"
#include "library.h"
#include "platform/files.h"
#include "request/quantities.h"
#include "surface/check.h"
#include "surface/input.h"
#include "text.h"

namespace cli {

namespace {

using Text = std::optional<std::string>;

std::int64_t whole_number(std::string_view option, std::string_view text, std::int64_t least) {
  const auto value = to_integer(text);
  if (!value || *value < least) throw Error(option, ": ", in_quotes(text), " is not a whole number from ", least, " on");
  return *value;
}

std::int64_t whole_or(const char* option, const Text& text, std::int64_t least, std::int64_t otherwise) {
  return text ? whole_number(option, *text, least) : otherwise;
}

double number_or(const char* option, const Text& text, double otherwise) {
  return text ? finite_number(option, *text) : otherwise;
}

// Lengths are in --unit, which is `unit` metres.
double length_or(const char* option, const Text& text, double unit, double otherwise) {
  return text ? read_positive(option, *text, Dimension::length, unit).in(unit) : otherwise;
}

double length_needed(const char* option, const Text& text, double unit) {
  if (!text) throw Error(option, " is missing");
  return length_or(option, text, unit, 0);
}

// The wave number of a wavelength; 0, which is no limit, if none was given.
double wave_number(const char* option, const Text& text, double unit) {
  return text ? 2 * 3.14159265358979323846 / length_or(option, text, unit, 0) : 0;
}

std::uint64_t seed(const GenerateArguments& arguments) {
  return static_cast<std::uint64_t>(whole_or("--seed", arguments.seed, 0, 1));
}

// A surface of the size asked for, in the unit of the command line, without heights.
Surface empty_surface(const GenerateArguments& arguments, double unit) {
  Surface surface;
  const auto pitch = read_quantities("--pitch", split(arguments.pitch ? *arguments.pitch : "1", ','), Dimension::length, unit);
  const bool positive = std::ranges::all_of(pitch, [](const Quantity& each) { return each.number > 0; });
  if (pitch.size() > 2 || !positive)
    throw Error("--pitch: ", in_quotes(*arguments.pitch),
                positive ? " has more than two numbers, give H or HX,HY" : " is not positive");
  surface.hx = pitch.front().in(unit);
  surface.hy = pitch.back().in(unit);
  const auto sizes = split(arguments.size ? std::string_view(*arguments.size) : "256", ',');
  if (sizes.size() > 2) throw Error("--size: ", in_quotes(*arguments.size), " has more than two numbers, give N or NX,NY");
  surface.nx = whole_number("--size", sizes.front(), 1);
  surface.ny = whole_number("--size", sizes.back(), 1);
  return surface;
}

double* make_room(Surface& surface) {
  constexpr std::int64_t most = std::int64_t{1} << 32;
  if (surface.nx > most / surface.ny) throw Error("--size: ", surface.nx, " x ", surface.ny, " points are more than 2^32");
  surface.heights.resize(static_cast<std::size_t>(surface.nx * surface.ny));
  return surface.heights.data();
}

Surface midpoint_displacement(const GenerateArguments& arguments, double unit) {
  rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
  spec.seed = seed(arguments);
  const std::int64_t levels = whole_or("--levels", arguments.levels, 1, spec.levels);
  if (levels > 14) throw Error("--levels: ", levels, " is more than 14");
  const std::int64_t stage = whole_or("--stage", arguments.stage, 0, levels);
  if (stage > levels) throw Error("--stage: ", stage, " is more than the number of levels, ", levels);
  spec.levels = static_cast<int32_t>(levels);
  spec.additions = arguments.additions ? 1 : 0;
  spec.hurst = number_or("--hurst", arguments.hurst, spec.hurst);
  spec.rms_height = length_or("--rms-height", arguments.rms_height, unit, 1);

  Surface surface = empty_surface(arguments, unit);
  // The pitch is the finest grid's; a coarser stage covers the same area.
  const double coarser = std::ldexp(1.0, static_cast<int>(levels - stage));
  surface.hx = *surface.hx * coarser;
  surface.hy = *surface.hy * coarser;
  surface.nx = surface.ny = (std::int64_t{1} << stage) + (arguments.vertices ? 1 : 0);
  check_surface(rc_surface_rmd(&spec, static_cast<int32_t>(stage), arguments.vertices ? 0 : 1, make_room(surface)));
  return surface;
}

Surface self_affine(const GenerateArguments& arguments, double unit) {
  Surface surface = empty_surface(arguments, unit);
  if (arguments.rms_height && arguments.rms_slope) throw Error("give only one of --rms-height and --rms-slope");
  auto spec = on_grid(surface.nx, surface.ny, *surface.hx, *surface.hy, rc_surface_spectral_spec RC_SURFACE_SPECTRAL_SPEC_INIT);
  spec.seed = seed(arguments);
  spec.hurst = number_or("--hurst", arguments.hurst, spec.hurst);
  spec.q_low = wave_number("--longest", arguments.longest, unit);
  spec.q_rolloff = wave_number("--rolloff", arguments.roll_off, unit);
  spec.q_high = wave_number("--shortest", arguments.shortest, unit);
  spec.rms_height = length_or("--rms-height", arguments.rms_height, unit, 0);
  spec.rms_slope = arguments.rms_height ? 0 : arguments.rms_slope ? positive_number("--rms-slope", *arguments.rms_slope) : 0.1;
  spec.fixed_amplitudes = arguments.fixed_amplitudes ? 1 : 0;
  surface.periodic = true;
  check_surface(rc_surface_spectral(&spec, make_room(surface)));
  return surface;
}

Surface shape(const std::string& kind, const GenerateArguments& arguments, double unit) {
  Surface surface = empty_surface(arguments, unit);
  auto spec = on_grid(surface.nx, surface.ny, *surface.hx, *surface.hy, rc_surface_shape_spec RC_SURFACE_SHAPE_SPEC_INIT);
  spec.seed = seed(arguments);
  if (kind == "sphere") {
    spec.shape = arguments.paraboloid ? RC_SURFACE_PARABOLOID : RC_SURFACE_SPHERE;
    spec.radius = length_needed("--radius", arguments.radius, unit);
  } else if (kind == "noise") {
    spec.shape = RC_SURFACE_NOISE;
    spec.height = length_or("--rms-height", arguments.rms_height, unit, 1);
  } else {
    spec.shape = kind == "waves" ? RC_SURFACE_WAVES : RC_SURFACE_PYRAMIDS;
    spec.height = length_or("--height", arguments.height, unit, 1);
    if (!arguments.period) throw Error("--period is missing");
    const auto periods = split(*arguments.period, ',');
    if (periods.size() > 2)
      throw Error("--period: ", in_quotes(*arguments.period), " has more than two numbers, give P or PX,PY");
    const auto lengths = read_quantities("--period", periods, Dimension::length, unit);
    spec.period_x = lengths.front().in(unit);
    spec.period_y = lengths.back().in(unit);
    if (spec.period_x < 0 || spec.period_y < 0) throw Error("--period: ", in_quotes(*arguments.period), " is negative");
  }
  surface.periodic = kind != "sphere";
  check_surface(rc_surface_shape(&spec, make_room(surface)));
  return surface;
}

}  // namespace

void generate(const std::string& kind, const GenerateArguments& arguments) {
  const double unit = length_unit("--unit", arguments.unit ? arguments.unit->c_str() : nullptr);
  const std::filesystem::path path = rc_platform::path_of(arguments.output);
  const std::string extension = path.extension().string();
  if (extension != ".npy" && extension != ".gsf")
    throw Error("--output: ", in_quotes(arguments.output), " must end in .npy or .gsf");

  check_outputs({}, {{"--output", arguments.output}});
  Surface surface = kind == "rmd"        ? midpoint_displacement(arguments, unit)
                    : kind == "spectral" ? self_affine(arguments, unit)
                                         : shape(kind, arguments, unit);
  if (extension == ".gsf") {
    surface.hx = unit * *surface.hx;
    surface.hy = unit * *surface.hy;
    for (double& z : surface.heights) z *= unit;
  }
  write_output(path, [&](std::FILE* file) {
    if (extension == ".gsf") {
      write_gsf(file, surface);
    } else {
      write_npy(file, surface.heights, surface.nx, surface.ny);
    }
    return true;
  });
}

}  // namespace cli
