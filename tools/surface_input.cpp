#include "surface_input.h"

#include <cmath>

#include "error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/registry.h"
#include "lengths.h"
#include "text.h"

namespace cli {

namespace {

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

  input.file = arguments.file;
  input.surface = read_surface(input.file, unit, arguments.format);
  const auto note = [&input](const std::string& text) {
    if (!text.empty()) input.notes.push_back(text);
  };
  note(input.surface.note);
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
