#include "surface_input.h"

#include <algorithm>
#include <cmath>

#include "error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/registry.h"
#include "lengths.h"
#include "text.h"

namespace cli {

namespace {

enum class MissingRule { reject, fill, exclude };

MissingRule parse_missing_rule(std::string_view name) {
  if (name == "reject") return MissingRule::reject;
  if (name == "fill") return MissingRule::fill;
  if (name == "exclude") return MissingRule::exclude;
  throw Error("--missing: " + in_quotes(name) + " is not known, give reject, fill or exclude");
}

Form parse_form(std::string_view name) {
  if (name == "none") return Form::none;
  if (name == "mean") return Form::mean;
  if (name == "plane") return Form::plane;
  if (name == "quadric") return Form::quadric;
  throw Error("--remove: " + in_quotes(name) + " is not known, give none, mean, plane or quadric");
}

void check_format(const std::optional<std::string>& name) {
  try {
    if (name) named_format(*name);
  } catch (const Error& error) {
    throw Error(std::string("--") + error.what());
  }
}

// Counts the missing points and says what can be done.
[[noreturn]] void reject_missing(const Surface& surface, std::int64_t count, bool can_exclude) {
  const auto first = std::ranges::find_if(surface.heights, [](double z) { return std::isnan(z); }) - surface.heights.begin();
  throw Error(format("%lld missing value%s of %zu, first at ix=%lld, iy=%lld; give --missing fill to interpolate%s",
                     static_cast<long long>(count), count == 1 ? "" : "s", surface.heights.size(),
                     static_cast<long long>(first % surface.nx), static_cast<long long>(first / surface.nx),
                     can_exclude ? " or --missing exclude to keep them out of contact" : ""));
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

}  // namespace

std::string SurfaceInput::preparation() const {
  std::string text;
  if (removed != "none") text += ", " + removed + " removed";
  if (missing > 0) {
    text += format(", %lld missing point%s %s", static_cast<long long>(missing), missing == 1 ? "" : "s",
                   missing_rule == "fill" ? "filled" : "excluded");
  }
  return text;
}

double unit_of(const SurfaceArguments& arguments) { return length_unit(arguments.unit); }

SurfaceInput read_input(const SurfaceArguments& arguments, bool can_exclude) {
  SurfaceInput input;
  const double unit = unit_of(arguments);
  const auto given_pitch = pitch_argument(arguments.pitch, unit);
  input.removed = arguments.remove.value_or("none");
  input.missing_rule = arguments.missing.value_or("reject");
  const Form form = parse_form(input.removed);
  const MissingRule rule = parse_missing_rule(input.missing_rule);
  if (rule == MissingRule::exclude && !can_exclude)
    throw Error("--missing: points cannot be excluded here, spectra need all of them; give reject or fill");

  check_format(arguments.format);
  input.file = arguments.file;
  input.surface = read_surface(input.file, unit, arguments.format);
  const auto note = [&input](const std::string& text) {
    if (!text.empty()) input.notes.push_back("note: " + text);
  };
  note(input.surface.note);
  if (input.surface.periodic) note("the file says that the surface is periodic, --boundary periodic is for that");
  note(settle_pitch(given_pitch, input.file, input.surface));
  try {
    input.missing = count_missing(input.surface);
    remove_form(form, input.surface);
    settle_missing(rule, can_exclude, input);
  } catch (const Error& error) {
    throw Error(input.file + ": " + error.what());
  }
  return input;
}

}  // namespace cli
