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
#include "formats/despike.h"
#include "formats/error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/readers.h"
#include "formats/rearrange.h"
#include "formats/registry.h"
#include "formats/resample.h"
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

// Whole numbers become lengths.
void scale_heights(double range, Surface& surface) {
  if (!(surface.full_scale > 0)) return;
  if (range == 0)
    throw Error(surface.file, ": the picture has whole numbers from 0 to ", surface.full_scale,
                ", which are no lengths; give height_range, the height between these two");
  for (double& z : surface.heights) z = range * (z / surface.full_scale);
}

// Reads by read(unit, format), and hands over.
template <class Read> void read_into(const rc_surface_read_spec* given, rc_surface_file* out, const Read& read_file) {
  const rc_surface_read_spec defaults = RC_SURFACE_READ_SPEC_INIT;
  const rc_surface_read_spec spec = given ? read(given, "rc_surface_read_spec", defaults) : defaults;
  check_size(out, "rc_surface_file");
  const BareUnit unit = bare_unit("unit", spec.unit ? std::optional<std::string>(spec.unit) : std::nullopt);
  const bool has_pitch = spec.hx != 0 || spec.hy != 0;
  if (has_pitch) check_pitch(spec.hx, spec.hy);
  if (!(spec.height_range >= 0) || !std::isfinite(spec.height_range))
    fail(RC_ERR_ARGUMENT, "height_range = ", spec.height_range, " must be positive and finite");

  Surface surface = read_file(unit, spec.format ? std::optional<std::string>(spec.format) : std::optional<std::string>());
  check_units(unit, {&surface});
  scale_heights(unit.metres * spec.height_range, surface);
  if (has_pitch) refuse_another_pitch("hx, hy", unit.metres * spec.hx, unit.metres * spec.hy, surface);
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  file.nx = surface.nx;
  file.ny = surface.ny;
  file.hx = has_pitch ? unit.metres * spec.hx : surface.hx.value_or(0);
  file.hy = has_pitch ? unit.metres * spec.hy : surface.hy.value_or(0);
  file.missing = count_missing(surface);
  file.periodic = surface.periodic ? *surface.periodic : -1;
  put(surface.format, file.format);
  file.full_scale = surface.full_scale;
  file.unit_assumed = !unit.given && !bare_lengths(surface).empty();
  put(assumptions(surface, unit, has_pitch), file.assumed);
  auto heights = std::make_unique<std::vector<double>>(std::move(surface.heights));
  file.heights = heights->data();
  file.storage = heights.release();
  write(out, file);
}

void check_points(std::int64_t nx, std::int64_t ny) {
  constexpr std::int64_t most = std::int64_t{1} << 40;
  if (nx < 1 || ny < 1 || nx > most / ny) fail(RC_ERR_SHAPE, "nx = ", nx, ", ny = ", ny, ": 1 x 1 to 2^40 points are needed");
}

// The caller's heights as a Surface.
Surface surface_of(std::int64_t nx, std::int64_t ny, const double* heights) {
  check_points(nx, ny);
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

// The checked numbers of a resampling. The map's heights stay the caller's until here.
std::vector<double> resampled(const rc_surface_resampling& asked) {
  Surface map = surface_of(asked.nx, asked.ny, asked.heights);
  check_pitch(asked.hx, asked.hy);
  check_pitch(asked.to_hx, asked.to_hy);
  check_points(asked.to_nx, asked.to_ny);
  check_switch(asked.periodic, "periodic");
  if (asked.interpolation != RC_SURFACE_LINEAR && asked.interpolation != RC_SURFACE_CUBIC)
    fail(RC_ERR_ARGUMENT, "interpolation = ", asked.interpolation, " must be RC_SURFACE_LINEAR (1) or RC_SURFACE_CUBIC (2)");
  if (!std::isfinite(asked.x0) || !std::isfinite(asked.y0))
    fail(RC_ERR_ARGUMENT, "x0 = ", asked.x0, ", y0 = ", asked.y0, " must be finite");
  constexpr double coarsest = 1.5 * (1 + 1e-9);
  if (asked.to_hx > coarsest * asked.hx || asked.to_hy > coarsest * asked.hy)
    fail(RC_ERR_ARGUMENT, "the pitch ", asked.to_hx, ", ", asked.to_hy, " is more than 1.5 times the map's, ", asked.hx, ", ",
         asked.hy, ": interpolation would skip summits; resample the coarser map on this grid");
  const auto method = asked.interpolation == RC_SURFACE_LINEAR ? Interpolation::linear : Interpolation::cubic;
  return heights_at(map, asked.periodic == 1, method, {asked.to_nx, asked.x0 / asked.hx, asked.to_hx / asked.hx},
                    {asked.to_ny, asked.y0 / asked.hy, asked.to_hy / asked.hy});
}

std::int64_t count_nan(const std::vector<double>& heights) {
  return std::ranges::count_if(heights, [](double z) { return std::isnan(z); });
}

template <class Number> void put(Number* to, Number value) {
  if (to) *to = value;
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

rc_status rc_surface_despike(int64_t nx, int64_t ny, double factor, double* heights, int64_t* spikes, double* largest) {
  return rc::formats::guard("rc_surface_despike", [&] {
    if (!(factor > 0) || !std::isfinite(factor)) fail(RC_ERR_ARGUMENT, "factor = ", factor, " must be positive and finite");
    Surface surface = surface_of(nx, ny, heights);
    const Spikes found = remove_spikes(factor, surface);
    std::ranges::copy(surface.heights, heights);
    put(spikes, found.count);
    put(largest, found.largest);
  });
}

rc_status rc_surface_crop(int64_t* nx, int64_t* ny, double hx, double hy, double x0, double x1, double y0, double y1,
                          double* heights) {
  return rc::formats::guard("rc_surface_crop", [&] {
    if (!nx || !ny) fail(RC_ERR_ARGUMENT, nx ? "ny is null" : "nx is null");
    check_pitch(hx, hy);
    for (const double limit : {x0, x1, y0, y1})
      if (std::isnan(limit)) fail(RC_ERR_ARGUMENT, "the region ", x0, " .. ", x1, ", ", y0, " .. ", y1, " is not a number");
    Surface surface = surface_of(*nx, *ny, heights);
    surface.hx = hx;
    surface.hy = hy;
    crop({x0, x1, y0, y1}, surface);
    std::ranges::copy(surface.heights, heights);
    *nx = surface.nx;
    *ny = surface.ny;
  });
}

rc_status rc_surface_mirror(int64_t nx, int64_t ny, int32_t axes, double* heights) {
  return rc::formats::guard("rc_surface_mirror", [&] {
    if (axes < RC_SURFACE_MIRROR_X || axes > (RC_SURFACE_MIRROR_X | RC_SURFACE_MIRROR_Y))
      fail(RC_ERR_ARGUMENT, "axes = ", axes, " must be RC_SURFACE_MIRROR_X (1), RC_SURFACE_MIRROR_Y (2) or their sum");
    Surface surface = surface_of(nx, ny, heights);
    mirror((axes & RC_SURFACE_MIRROR_X) != 0, (axes & RC_SURFACE_MIRROR_Y) != 0, surface);
    std::ranges::copy(surface.heights, heights);
  });
}

rc_status rc_surface_resample(rc_surface_resampling* resampling) {
  return rc::formats::guard("rc_surface_resample", [&] {
    rc_surface_resampling asked = read<rc_surface_resampling>(resampling, "rc_surface_resampling", RC_SURFACE_RESAMPLING_INIT);
    if (!asked.to) fail(RC_ERR_ARGUMENT, "to is null");
    const std::vector<double> heights = resampled(asked);
    std::ranges::copy(heights, asked.to);
    asked.missing = count_nan(heights);
    write(resampling, asked);
  });
}

rc_status rc_surface_shift(int64_t nx, int64_t ny, double hx, double hy, double dx, double dy, int32_t periodic,
                           int32_t interpolation, double* heights, int64_t* missing) {
  return rc::formats::guard("rc_surface_shift", [&] {
    if (!std::isfinite(dx) || !std::isfinite(dy)) fail(RC_ERR_ARGUMENT, "dx = ", dx, ", dy = ", dy, " must be finite");
    rc_surface_resampling asked = RC_SURFACE_RESAMPLING_INIT;
    asked.nx = asked.to_nx = nx;
    asked.ny = asked.to_ny = ny;
    asked.hx = asked.to_hx = hx;
    asked.hy = asked.to_hy = hy;
    asked.x0 = -dx;
    asked.y0 = -dy;
    asked.periodic = periodic;
    asked.interpolation = interpolation;
    asked.heights = heights;
    const std::vector<double> moved = resampled(asked);
    std::ranges::copy(moved, heights);
    put(missing, count_nan(moved));
  });
}
