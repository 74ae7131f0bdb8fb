// The exported functions: they check arguments, call, and write results.
#include <roughcontact/formats.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "abi/own_guard.h"
#include "abi/sized_struct.h"
#include "formats/error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/registry.h"
#include "formats/surface.h"
#include "formats/units.h"
#include "formats/wording.h"
#include "platform/files.h"

namespace rc {

namespace formats {

namespace {

struct Library;

// Whatever is wrong with a file is an argument that is wrong.
template <class Body> rc_status guard(const char* where, const Body& body) {
  return own_guard<Library>(where, [&] {
    try {
      body();
    } catch (const Error& error) {
      fail(RC_ERR_ARGUMENT, error.what());
    }
  });
}

void check_pitch(double hx, double hy) {
  for (const double h : {hx, hy})
    if (!(h > 0) || !std::isfinite(h)) fail(RC_ERR_ARGUMENT, "hx = ", hx, ", hy = ", hy, " must be positive and finite");
}

// Sentences on what the file leaves open.
std::string assumptions(const Surface& surface, const BareUnit& unit, bool pitch_given) {
  std::string text;
  const auto add = [&text](const std::string& sentence) {
    if (!sentence.empty()) text += (text.empty() ? "" : "; ") + sentence;
  };
  add(surface.note);
  if (const std::string lengths = bare_lengths(surface); !lengths.empty())
    add(join("lengths without a unit are in ", unit.name,
             unit.given ? ", as asked for" : ": the file names none of its " + lengths));
  if (!surface.hx && !surface.hy && !pitch_given) add("the pitch is not known: the file does not say it");
  return text;
}

template <std::size_t size> void put(const std::string& text, char (&to)[size]) {
  const std::size_t length = std::min(text.size(), size - 1);
  std::copy_n(text.begin(), length, to);
  std::fill(to + length, to + size, '\0');
}

// Reads by read(unit, format), and hands over.
template <class Read> void read_into(const rc_surface_read_spec* given, rc_surface_file* out, const Read& read_file) {
  const rc_surface_read_spec defaults = RC_SURFACE_READ_SPEC_INIT;
  const rc_surface_read_spec spec = given ? read(given, "rc_surface_read_spec", defaults) : defaults;
  check_size(out, "rc_surface_file");
  const BareUnit unit = bare_unit("unit", spec.unit ? std::optional<std::string>(spec.unit) : std::nullopt);
  const bool has_pitch = spec.hx != 0 || spec.hy != 0;
  if (has_pitch) check_pitch(spec.hx, spec.hy);

  Surface surface = read_file(unit, spec.format ? std::optional<std::string>(spec.format) : std::optional<std::string>());
  check_units(unit, {&surface});
  if (has_pitch) refuse_another_pitch("hx, hy", unit.metres * spec.hx, unit.metres * spec.hy, surface);
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  file.nx = surface.nx;
  file.ny = surface.ny;
  file.hx = has_pitch ? unit.metres * spec.hx : surface.hx.value_or(0);
  file.hy = has_pitch ? unit.metres * spec.hy : surface.hy.value_or(0);
  file.missing = count_missing(surface);
  file.periodic = surface.periodic ? *surface.periodic : -1;
  put(surface.format, file.format);
  file.unit_assumed = !unit.given && !bare_lengths(surface).empty();
  put(assumptions(surface, unit, has_pitch), file.assumed);
  auto heights = std::make_unique<std::vector<double>>(std::move(surface.heights));
  file.heights = heights->data();
  file.storage = heights.release();
  write(out, file);
}

// The caller's heights as a Surface.
Surface surface_of(std::int64_t nx, std::int64_t ny, const double* heights) {
  constexpr std::int64_t most = std::int64_t{1} << 40;
  if (nx < 1 || ny < 1 || nx > most / ny) fail(RC_ERR_SHAPE, "nx = ", nx, ", ny = ", ny, ": 1 x 1 to 2^40 points are needed");
  if (!heights) fail(RC_ERR_ARGUMENT, "heights is null");
  Surface surface;
  surface.nx = nx;
  surface.ny = ny;
  surface.heights.assign(heights, heights + nx * ny);
  const auto infinite = std::ranges::find_if(surface.heights, [](double z) { return std::isinf(z); });
  if (infinite != surface.heights.end())
    fail(RC_ERR_ARGUMENT, "heights has an infinite value at ix=", (infinite - surface.heights.begin()) % nx,
         ", iy=", (infinite - surface.heights.begin()) / nx, "; a missing point is NaN");
  return surface;
}

}  // namespace

}  // namespace formats

}  // namespace rc

using namespace rc;           // NOLINT: this file is the bridge
using namespace rc::formats;  // NOLINT

const char* rc_surface_read_last_error(void) { return own_message<rc::formats::Library>; }

rc_status rc_surface_read(const char* path, const rc_surface_read_spec* spec, rc_surface_file* out) {
  return rc::formats::guard("rc_surface_read", [&] {
    if (!path) fail(RC_ERR_ARGUMENT, "path is null");
    read_into(spec, out,
              [&](const BareUnit& unit, const auto& format) { return read_surface(rc_platform::path_of(path), unit, format); });
  });
}

rc_status rc_surface_read_memory(const void* data, size_t size, const char* name, const rc_surface_read_spec* spec,
                                 rc_surface_file* out) {
  return rc::formats::guard("rc_surface_read_memory", [&] {
    if (!data && size > 0) fail(RC_ERR_ARGUMENT, "data is null");
    const std::string_view file(static_cast<const char*>(data), size);
    read_into(spec, out, [&](const BareUnit& unit, const auto& format) {
      return read_surface(file, rc_platform::path_of(name ? name : ""), unit, format);
    });
  });
}

void rc_surface_file_free(rc_surface_file* file) {
  if (!file || file->struct_size < first_size<rc_surface_file>) return;
  delete static_cast<std::vector<double>*>(file->storage);
  write(file, rc_surface_file RC_SURFACE_FILE_INIT);
}

int64_t rc_surface_format_count(void) { return std::ssize(surface_formats()); }

rc_status rc_surface_format_describe(int64_t index, rc_surface_format* out) {
  return rc::formats::guard("rc_surface_format_describe", [&] {
    check_size(out, "rc_surface_format");
    const auto all = surface_formats();
    if (index < 0 || index >= std::ssize(all)) fail(RC_ERR_ARGUMENT, "index = ", index, " is not in 0 .. ", std::ssize(all) - 1);
    const Format& format = all[static_cast<std::size_t>(index)];
    rc_surface_format described = RC_SURFACE_FORMAT_INIT;
    described.name = format.name.data();
    described.summary = format.summary.data();
    described.suffixes = format.extensions.data();
    described.says = format.lengths.data();
    described.by_contents = format.matches ? 1 : 0;
    write(out, described);
  });
}

rc_status rc_surface_unit(const char* name, double* metres) {
  return rc::formats::guard("rc_surface_unit", [&] {
    if (!name || !metres) fail(RC_ERR_ARGUMENT, name ? "metres is null" : "name is null");
    *metres = bare_unit("name", name).metres;
  });
}

rc_status rc_surface_remove_form(int64_t nx, int64_t ny, int32_t form, double* heights) {
  return rc::formats::guard("rc_surface_remove_form", [&] {
    constexpr Form forms[] = {Form::mean, Form::plane, Form::quadric};
    if (form < RC_SURFACE_FORM_MEAN || form > RC_SURFACE_FORM_QUADRIC)
      fail(RC_ERR_ARGUMENT, "form = ", form, " must be one of RC_SURFACE_FORM_*");
    Surface surface = surface_of(nx, ny, heights);
    remove_form(forms[form - RC_SURFACE_FORM_MEAN], surface);
    std::ranges::copy(surface.heights, heights);
  });
}

rc_status rc_surface_fill(int64_t nx, int64_t ny, double hx, double hy, double* heights) {
  return rc::formats::guard("rc_surface_fill", [&] {
    check_pitch(hx, hy);
    Surface surface = surface_of(nx, ny, heights);
    surface.hx = hx;
    surface.hy = hy;
    const std::int64_t missing = count_missing(surface);
    if (missing == 0) return;
    if (missing == nx * ny) fail(RC_ERR_ARGUMENT, "all ", missing, " points are missing");
    fill_missing(surface);
    std::ranges::copy(surface.heights, heights);
  });
}
