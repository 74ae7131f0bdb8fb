#include "surface/input.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "arguments/choices.h"
#include "arguments/quantities.h"
#include "formats/error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/registry.h"
#include "formats/units.h"
#include "platform/files.h"
#include "surface/shapes.h"
#include "text.h"
#include "units.h"

namespace cli {

namespace {

enum class MissingRule { reject, fill, exclude };  // in the order of missing_rule_names

void check_format(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Format& format : surface_formats()) names.push_back(format.name);
  choice("--format", name, names);
}

// Counts the missing points and says what can be done.
[[noreturn]] void reject_missing(const Surface& surface, std::int64_t count, bool can_exclude) {
  const auto first = std::ranges::find_if(surface.heights, [](double z) { return std::isnan(z); }) - surface.heights.begin();
  throw Error(count, " missing value", count == 1 ? "" : "s", " of ", surface.heights.size(),
              ", first at ix=", first % surface.nx, ", iy=", first / surface.nx, "; give --missing fill to interpolate",
              can_exclude ? " or --missing exclude to keep them out of contact" : "");
}

void settle_missing(MissingRule rule, bool can_exclude, SurfaceInput& input) {
  Surface& surface = input.surface;
  if (input.missing == 0) return;
  if (input.missing == std::ssize(surface.heights)) {
    throw Error(input.missing == 1 ? "the only point is missing"
                                   : "all " + std::to_string(input.missing) + " points are missing");
  }
  if (rule == MissingRule::reject) reject_missing(surface, input.missing, can_exclude);
  if (rule == MissingRule::fill) fill_missing(surface);
  if (rule == MissingRule::exclude) {
    input.mask.reserve(surface.heights.size());
    for (const double z : surface.heights) input.mask.push_back(std::isnan(z) ? 0 : 1);
  }
}

Surface read_file(const std::string& path, const BareUnit& bare, const std::optional<std::string>& format = std::nullopt) {
  try {
    return read_surface(rc_platform::path_of(path), bare, format);
  } catch (...) {
    silence_hdf5();
    throw;
  }
}

// Adds the heights of the other body, which face those of the surface at the same points. Both together repeat if each does.
void add_other(const Surface& other, SurfaceInput& input) {
  Surface& surface = input.surface;
  const double hx = other.hx.value_or(*surface.hx), hy = other.hy.value_or(*surface.hy);
  if (other.nx != surface.nx || other.ny != surface.ny || !same_pitch(hx, *surface.hx) || !same_pitch(hy, *surface.hy)) {
    const auto grid = [](std::int64_t nx, std::int64_t ny, double x, double y) {
      return format("%lld x %lld points, pitch %s x %s", static_cast<long long>(nx), static_cast<long long>(ny),
                    with_prefix(x, "m", 7).c_str(), with_prefix(y, "m", 7).c_str());
    };
    throw Error("--against: ", input.against, " has ", grid(other.nx, other.ny, hx, hy), ", ", input.file, " has ",
                grid(surface.nx, surface.ny, *surface.hx, *surface.hy), ": give two maps on the same grid");
  }
  for (std::size_t i = 0; i < surface.heights.size(); ++i) surface.heights[i] += other.heights[i];
  if (surface.periodic == true) surface.periodic = other.periodic;
  if (other.periodic == false) surface.periodic = false;
}

}  // namespace

std::string SurfaceInput::preparation() const {
  std::string text;
  if (!against.empty()) text += ", against " + rc_platform::path_of(against).filename().string();
  if (removed != "none") text += ", " + removed + " removed";
  if (missing > 0) {
    text += format(", %lld missing point%s %s", static_cast<long long>(missing), missing == 1 ? "" : "s",
                   missing_rule == "fill" ? "filled" : "excluded");
  }
  if (!shape.empty()) text += ", shape " + shape;
  return text;
}

double unit_of(const SurfaceArguments& arguments) { return length_unit(arguments.unit); }

void settle_units(const SurfaceArguments& arguments, const Surface* other, SurfaceInput& input) {
  const BareUnit unit = bare_unit("--unit", arguments.unit);
  if (other) {
    check_units(unit, {&input.surface, other});
  } else {
    check_units(unit, {&input.surface});
  }
  if (unit.given) return;
  const auto add = [&input](const std::string& lengths) { input.assumed += (input.assumed.empty() ? "" : ", ") + lengths; };
  for (const Surface* const surface : {static_cast<const Surface*>(&input.surface), other}) {
    if (surface && !bare_lengths(*surface).empty()) add(bare_lengths(*surface) + " of " + surface->file);
  }
  if (const auto pitch = pitch_argument(arguments.pitch, unit.metres); pitch && pitch->bare) add("--pitch");
  if (input.assumed.empty()) return;
  input.assumed = "lengths without a unit are taken in m (" + input.assumed + ")";
  input.notes.push_back("note: " + input.assumed + "; --unit names another");
}

SurfaceInput read_input(const SurfaceArguments& arguments, bool can_exclude) {
  SurfaceInput input;
  const double unit = unit_of(arguments);
  const auto given_pitch = pitch_argument(arguments.pitch, unit);
  input.removed = arguments.remove.value_or("none");
  input.missing_rule = arguments.missing.value_or("reject");
  const Form form = static_cast<Form>(choice("--remove", input.removed, form_names));
  const MissingRule rule = static_cast<MissingRule>(choice("--missing", input.missing_rule, missing_rule_names));
  if (rule == MissingRule::exclude && !can_exclude)
    throw Error("--missing: points cannot be excluded here, spectra need all of them; give reject or fill");

  if (arguments.format) check_format(*arguments.format);
  std::optional<Shape>& shape = input.body;
  if (arguments.shape) shape = parse_shape(*arguments.shape, unit);
  input.shape = arguments.shape.value_or("");

  input.file = arguments.file;
  const BareUnit bare = bare_unit("--unit", arguments.unit);
  input.surface = read_file(input.file, bare, arguments.format);
  const auto note = [&input](const std::string& text) {
    if (!text.empty()) input.notes.push_back("note: " + text);
  };
  note(input.surface.note);
  settle_pitch(given_pitch, input.surface);
  std::optional<Surface> other;
  if (arguments.against) {
    input.against = *arguments.against;
    other = read_file(input.against, bare);
    note(other->note);
  }
  settle_units(arguments, other ? &*other : nullptr, input);
  if (other) add_other(*other, input);
  try {
    input.missing = count_missing(input.surface);
    remove_form(form, input.surface);
    settle_missing(rule, can_exclude, input);
    if (shape) add_shape(*shape, input.surface);
  } catch (const Error& error) {
    throw Error(input.file, ": ", error.what());
  }
  return input;
}

}  // namespace cli
