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

// Adds the heights of the other body, which face those of the surface at the same points.
void add_other(const SurfaceArguments& arguments, double unit, SurfaceInput& input) {
  constexpr double same_pitch = 1e-6;  // relative; files round it
  if (!arguments.against) return;
  input.against = *arguments.against;
  Surface& surface = input.surface;
  const Surface other = read_surface(rc_platform::path_of(input.against), unit);
  if (!other.note.empty()) input.notes.push_back("note: " + other.note);
  const double hx = other.hx.value_or(*surface.hx), hy = other.hy.value_or(*surface.hy);
  const auto near = [](double a, double b) { return std::abs(a - b) <= same_pitch * b; };
  if (other.nx != surface.nx || other.ny != surface.ny || !near(hx, *surface.hx) || !near(hy, *surface.hy)) {
    const auto grid = [](std::int64_t nx, std::int64_t ny, double x, double y) {
      return format("%lld x %lld points, pitch %s x %s", static_cast<long long>(nx), static_cast<long long>(ny),
                    with_prefix(x, "m", 7).c_str(), with_prefix(y, "m", 7).c_str());
    };
    throw Error("--against: ", input.against, " has ", grid(other.nx, other.ny, hx, hy), ", ", input.file, " has ",
                grid(surface.nx, surface.ny, *surface.hx, *surface.hy), ": give two maps on the same grid");
  }
  for (std::size_t i = 0; i < surface.heights.size(); ++i) surface.heights[i] += other.heights[i];
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
  input.surface = read_surface(rc_platform::path_of(input.file), unit, arguments.format);
  const auto note = [&input](const std::string& text) {
    if (!text.empty()) input.notes.push_back("note: " + text);
  };
  note(input.surface.note);
  note(settle_pitch(given_pitch, input.file, input.surface));
  add_other(arguments, unit, input);
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
