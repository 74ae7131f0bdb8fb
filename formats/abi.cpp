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

double unit_of(const rc_surface_read_spec& spec) {
  if (!spec.unit) return 1;
  if (const auto metres = metres_per(spec.unit)) return *metres;
  fail(RC_ERR_ARGUMENT, "unit: ", in_quotes(spec.unit), " is not a length unit, give m, mm, um, nm or pm");
}

void check_pitch(double hx, double hy) {
  for (const double h : {hx, hy})
    if (!(h > 0) || !std::isfinite(h)) fail(RC_ERR_ARGUMENT, "hx = ", hx, ", hy = ", hy, " must be positive and finite");
}

// Sentences on what the file leaves open, and on values of the file that the caller has replaced.
std::string assumptions(const Surface& surface, const rc_surface_read_spec& spec, bool pitch_replaced) {
  std::string text;
  const auto add = [&text](const std::string& sentence) {
    if (!sentence.empty()) text += (text.empty() ? "" : "; ") + sentence;
  };
  add(surface.note);
  if (!surface.names_unit)
    add(join("lengths without a unit are in ", spec.unit ? spec.unit : "m",
             spec.unit ? ", as asked for" : ": the file names none"));
  if (pitch_replaced) add(join("the pitch asked for is used, not ", *surface.hx, " m, ", *surface.hy, " m of the file"));
  if (!surface.hx && !surface.hy && spec.hx == 0) add("the pitch is not known: the file does not say it");
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
  const double unit = unit_of(spec);
  const bool has_pitch = spec.hx != 0 || spec.hy != 0;
  if (has_pitch) check_pitch(spec.hx, spec.hy);

  Surface surface = read_file(unit, spec.format ? std::optional<std::string>(spec.format) : std::optional<std::string>());
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  file.nx = surface.nx;
  file.ny = surface.ny;
  file.hx = has_pitch ? unit * spec.hx : surface.hx.value_or(0);
  file.hy = has_pitch ? unit * spec.hy : surface.hy.value_or(0);
  file.missing = count_missing(surface);
  file.periodic = surface.periodic ? *surface.periodic : -1;
  put(surface.format, file.format);
  put(assumptions(surface, spec, has_pitch && surface.hx && surface.hy), file.assumed);
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
    read_into(spec, out, [&](double unit, const auto& format) { return read_surface(rc_platform::path_of(path), unit, format); });
  });
}

rc_status rc_surface_read_memory(const void* data, size_t size, const char* name, const rc_surface_read_spec* spec,
                                 rc_surface_file* out) {
  return rc::formats::guard("rc_surface_read_memory", [&] {
    if (!data && size > 0) fail(RC_ERR_ARGUMENT, "data is null");
    const std::string_view file(static_cast<const char*>(data), size);
    read_into(spec, out, [&](double unit, const auto& format) {
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
