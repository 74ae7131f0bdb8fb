// The exported functions: they check arguments, call, and write results.
#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "abi/own_guard.h"
#include "cmr_advice.h"
#include "grid/downsample.h"
#include "midpoint.h"
#include "peaks.h"
#include "power_law.h"
#include "spectral.h"
#include "statistics.h"
#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

template <class Body> rc_status guard(const char* where, const Body& body) { return own_guard<Library>(where, body); }

void check_rmd(const rc_surface_rmd_spec& spec, std::int32_t stage, std::int32_t crop) {
  if (spec.levels < 1 || spec.levels > 14) fail(RC_ERR_ARGUMENT, "levels = ", spec.levels, " is not in 1 .. 14");
  if (!(spec.hurst > 0 && spec.hurst <= 1)) fail(RC_ERR_ARGUMENT, "hurst = ", spec.hurst, " is not in (0, 1]");
  if (spec.additions != 0 && spec.additions != 1) fail(RC_ERR_ARGUMENT, "additions = ", spec.additions, " must be 0 or 1");
  check_magnitude_or_zero("rms_height", spec.rms_height);
  if (spec.rms_height == 0) check_magnitude("sigma", spec.sigma);
  if (stage < 0 || stage > spec.levels) fail(RC_ERR_ARGUMENT, "stage = ", stage, " is not in 0 .. levels = ", spec.levels);
  if (crop != 0 && crop != 1) fail(RC_ERR_ARGUMENT, "crop = ", crop, " must be 0 or 1");
}

void check_spectral(const rc_surface_spectral_spec& spec) {
  check_shape(spec.nx, spec.ny);
  check_magnitude("hx", spec.hx);
  check_magnitude("hy", spec.hy);
  if (!(spec.hurst >= 0 && spec.hurst <= 1)) fail(RC_ERR_ARGUMENT, "hurst = ", spec.hurst, " is not in 0 .. 1");
  check_magnitude_or_zero("q_low", spec.q_low);
  check_magnitude_or_zero("q_rolloff", spec.q_rolloff);
  check_magnitude_or_zero("q_high", spec.q_high);
  if (spec.q_high > 0 && spec.q_low > spec.q_high)
    fail(RC_ERR_ARGUMENT, "q_low = ", spec.q_low, " is above q_high = ", spec.q_high);
  check_magnitude_or_zero("rms_height", spec.rms_height);
  check_magnitude_or_zero("rms_slope", spec.rms_slope);
  if ((spec.rms_height > 0) == (spec.rms_slope > 0))
    fail(RC_ERR_ARGUMENT, "rms_height = ", spec.rms_height, " and rms_slope = ", spec.rms_slope, ": exactly one must be > 0");
  if (spec.fixed_amplitudes != 0 && spec.fixed_amplitudes != 1)
    fail(RC_ERR_ARGUMENT, "fixed_amplitudes = ", spec.fixed_amplitudes, " must be 0 or 1");
  if (spec.reserved != 0) fail(RC_ERR_ARGUMENT, "reserved = ", spec.reserved, " must be 0");
}

void check_shape_spec(const rc_surface_shape_spec& spec) {
  check_shape(spec.nx, spec.ny);
  check_magnitude("hx", spec.hx);
  check_magnitude("hy", spec.hy);
  if (spec.shape < RC_SURFACE_PARABOLOID || spec.shape > RC_SURFACE_NOISE)
    fail(RC_ERR_ARGUMENT, "shape = ", spec.shape, " must be one of RC_SURFACE_PARABOLOID .. RC_SURFACE_NOISE");
  if (spec.reserved != 0) fail(RC_ERR_ARGUMENT, "reserved = ", spec.reserved, " must be 0");
  if (spec.shape <= RC_SURFACE_SPHERE) return check_magnitude("radius", spec.radius);
  check_magnitude("height", spec.height);
  if (spec.shape == RC_SURFACE_NOISE) return;
  check_magnitude_or_zero("period_x", spec.period_x);
  check_magnitude_or_zero("period_y", spec.period_y);
  if (spec.period_x + spec.period_y <= 0) fail(RC_ERR_ARGUMENT, "period_x and period_y are both 0, one must be > 0");
}

Heights read_rough_heights(const rc_surface_map* map) {
  Heights heights = read_heights(map);
  if (!(mean_square(heights.z) > 0)) fail(RC_ERR_ARGUMENT, "the map is flat: it has no roughness to judge");
  return heights;
}

rc_surface_power_law judge(const Heights& heights) {
  Spectrum s = spectrum(heights);
  rc_surface_power_law law{};
  law.struct_size = sizeof law;
  find_peaks(s, law);
  find_power_law(s, law);
  return law;
}

}  // namespace

}  // namespace rc::surface

using namespace rc;           // NOLINT: this file is the bridge
using namespace rc::surface;  // NOLINT

const char* rc_surface_last_error(void) { return own_message<rc::surface::Library>; }

void rc_surface_stop_when(const int32_t* flag) { stop_flag<rc::surface::Library> = flag; }

rc_status rc_surface_rmd(const rc_surface_rmd_spec* given, int32_t stage, int32_t crop, double* out) {
  return guard("rc_surface_rmd", [&] {
    const auto spec = read(given, "rc_surface_rmd_spec", rc_surface_rmd_spec RC_SURFACE_RMD_SPEC_INIT);
    check_rmd(spec, stage, crop);
    check_output(out);
    const std::vector<double> z = midpoint_displacement(spec, stage);
    const std::int64_t side = (std::int64_t{1} << stage) + 1, kept = side - crop;
    for (std::int64_t y = 0; y < kept; ++y) std::copy_n(z.begin() + y * side, kept, out + y * kept);
  });
}

rc_status rc_surface_spectral(const rc_surface_spectral_spec* given, double* out) {
  return guard("rc_surface_spectral", [&] {
    const auto spec = read(given, "rc_surface_spectral_spec", rc_surface_spectral_spec RC_SURFACE_SPECTRAL_SPEC_INIT);
    check_spectral(spec);
    check_output(out);
    std::ranges::copy(self_affine(spec), out);
  });
}

rc_status rc_surface_shape(const rc_surface_shape_spec* given, double* out) {
  return guard("rc_surface_shape", [&] {
    const auto spec = read(given, "rc_surface_shape_spec", rc_surface_shape_spec RC_SURFACE_SHAPE_SPEC_INIT);
    check_shape_spec(spec);
    check_output(out);
    shape(spec, out);
  });
}

rc_status rc_surface_analyze(const rc_surface_map* map, rc_surface_statistics* out) {
  return guard("rc_surface_analyze", [&] {
    check_size(out, "rc_surface_statistics");
    write(out, statistics(read_heights(map)));
  });
}

rc_status rc_surface_psd(const rc_surface_map* map, double* q, double* psd, int64_t* modes, int64_t* count) {
  return guard("rc_surface_psd", [&] {
    if (!count) fail(RC_ERR_ARGUMENT, "count is null");
    const bool wanted = q || psd || modes;
    if (wanted && !(q && psd && modes)) fail(RC_ERR_ARGUMENT, "some of q, psd and modes are null; give all or none");
    const std::vector<Ring> all = rings(spectrum(read_heights(map)));
    const auto needed = static_cast<std::int64_t>(all.size());
    if (wanted && *count < needed)
      fail(RC_ERR_ARGUMENT, "the arrays hold ", *count, " rings, ", needed,
           " are needed; a call with NULL arrays returns that number");
    for (std::size_t i = 0; wanted && i < all.size(); ++i) {
      q[i] = all[i].q;
      psd[i] = all[i].power;
      modes[i] = all[i].modes;
    }
    *count = needed;
  });
}

rc_status rc_surface_fit(const rc_surface_map* map, rc_surface_power_law* out) {
  return guard("rc_surface_fit", [&] {
    check_size(out, "rc_surface_power_law");
    write(out, judge(read_rough_heights(map)));
  });
}

rc_status rc_surface_cmr_advice(const rc_surface_map* map, int32_t levels, double approach, rc_surface_cmr* out) {
  return guard("rc_surface_cmr_advice", [&] {
    check_size(out, "rc_surface_cmr");
    check_at_least_zero("approach", approach);
    const Heights heights = read_rough_heights(map);
    const std::int32_t most = most_levels(heights);
    if (levels < 1 || levels > most)
      fail(RC_ERR_ARGUMENT, "levels = ", levels, " is not in 1 .. ", most, ", what leaves 4 of ",
           std::max(heights.nx, heights.ny), " points along the longer side");
    write(out, cmr_advice(heights, judge(heights), levels, approach));
  });
}

rc_status rc_surface_downsample(int64_t nx, int64_t ny, const double* heights, const uint8_t* mask, int32_t filter, double* out,
                                uint8_t* out_mask) {
  return guard("rc_surface_downsample", [&] {
    check_shape(nx, ny);
    if (!heights) fail(RC_ERR_ARGUMENT, "heights is null");
    check_output(out);
    if (filter < RC_SURFACE_SUBSAMPLE || filter > RC_SURFACE_MAX)
      fail(RC_ERR_ARGUMENT, "filter = ", filter, " must be RC_SURFACE_SUBSAMPLE, RC_SURFACE_MEAN or RC_SURFACE_MAX");
    const auto points = static_cast<std::size_t>(nx * ny);
    // The gap is the height, counted downwards.
    std::vector<double> gap(points);
    std::transform(heights, heights + points, gap.begin(), [](double z) { return -z; });
    const std::span<const std::uint8_t> given = mask ? std::span{mask, points} : std::span<const std::uint8_t>{};
    const Filter filters[] = {Filter::subsample, Filter::mean, Filter::max};
    const CoarseGrid coarse = downsample(nx, ny, gap, given, filters[filter - RC_SURFACE_SUBSAMPLE]);
    for (std::size_t i = 0; i < coarse.gap.size(); ++i) {
      const bool there = coarse.mask.empty() || coarse.mask[i] != 0;
      out[i] = there ? -coarse.gap[i] : no_value;
      if (out_mask) out_mask[i] = there ? 1 : 0;
    }
  });
}
