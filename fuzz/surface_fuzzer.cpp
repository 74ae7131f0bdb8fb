// The surface library: every generator and every analysis, with numbers from the bytes. A refused call writes nothing and says
// why. Generated heights are finite.
#include <roughcontact/surface.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "bytes.h"
#include "require.h"

namespace {

using fuzz::Bytes, fuzz::require;

constexpr double untouched = 12345.678;

// Any bits, or a number near 1.
double number(Bytes& bytes) {
  const int kind = bytes.byte();
  if (kind < 160) return (bytes.whole() + kind / 160.0) / 8;
  if (kind < 240) return std::pow(10.0, bytes.whole() * 2.5) * (1 + kind % 8);
  std::uint64_t bits = 0;
  for (int k = 0; k < 8; ++k) bits = bits << 8 | bytes.byte();
  return std::bit_cast<double>(bits);
}

std::int64_t side(Bytes& bytes) {
  const int value = bytes.whole();
  return value >= 0 ? value % 33 : value == -1 ? INT64_MAX : value == -2 ? -1 : 1;
}

bool finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool kept(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return value == untouched; });
}

void require_result(rc_status status, bool nothing_written) {
  require(status == RC_OK || status == RC_ERR_ARGUMENT || status == RC_ERR_SHAPE || status == RC_ERR_MEMORY,
          "a documented status");
  require((status == RC_OK) == (rc_surface_last_error()[0] == '\0'), "what is refused is explained");
  require(status == RC_OK || nothing_written, "a refused call writes nothing");
}

void made(rc_status status, const std::vector<double>& out) {
  require_result(status, kept(out));
  if (status == RC_OK) require(finite(out), "heights are finite");
}

// For a grid that is refused an array of one: nothing may be written.
std::vector<double> room(std::int64_t nx, std::int64_t ny) {
  const bool small = nx >= 1 && ny >= 1 && nx <= 64 && ny <= 64;
  return std::vector<double>(small ? static_cast<std::size_t>(nx * ny) : 1, untouched);
}

void generate(Bytes& bytes, std::size_t kind) {
  if (kind == 0) {
    rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
    spec.seed = bytes.byte();
    spec.levels = bytes.byte() % 6;
    const std::int32_t stage = bytes.whole() % 6, crop = bytes.byte() % 3;
    spec.additions = bytes.byte() % 3;
    spec.hurst = number(bytes);
    spec.sigma = number(bytes);
    spec.rms_height = number(bytes);
    const std::int64_t points = (std::int64_t{1} << std::max(stage, 0)) + 1;
    std::vector<double> out(static_cast<std::size_t>(crop == 1 ? (points - 1) * (points - 1) : points * points), untouched);
    made(rc_surface_rmd(&spec, stage, crop, out.data()), out);
  } else if (kind == 1) {
    rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
    spec.seed = bytes.byte();
    spec.nx = side(bytes);
    spec.ny = side(bytes);
    for (double* value : {&spec.hx, &spec.hy, &spec.hurst, &spec.q_low, &spec.q_rolloff, &spec.q_high, &spec.rms_height})
      if (bytes.flag()) *value = number(bytes);
    spec.rms_slope = bytes.flag() ? number(bytes) : spec.rms_height > 0 ? 0 : 1;
    spec.fixed_amplitudes = bytes.byte() % 3;
    std::vector<double> out = room(spec.nx, spec.ny);
    made(rc_surface_spectral(&spec, out.data()), out);
  } else {
    rc_surface_shape_spec spec = RC_SURFACE_SHAPE_SPEC_INIT;
    spec.shape = bytes.byte() % 7;
    spec.seed = bytes.byte();
    spec.nx = side(bytes);
    spec.ny = side(bytes);
    for (double* value : {&spec.hx, &spec.hy, &spec.radius, &spec.height, &spec.period_x, &spec.period_y})
      if (bytes.flag()) *value = number(bytes);
    std::vector<double> out = room(spec.nx, spec.ny);
    made(rc_surface_shape(&spec, out.data()), out);
  }
}

template <class Struct> Struct filled() {
  Struct out;
  std::memset(&out, 0x5a, sizeof out);
  out.struct_size = sizeof out;
  return out;
}

template <class Struct> bool same(const Struct& a, const Struct& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void analyze(Bytes& bytes) {
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = side(bytes);
  map.ny = side(bytes);
  map.hx = bytes.flag() ? number(bytes) : 1;
  map.hy = bytes.flag() ? number(bytes) : map.hx;
  map.periodic = bytes.byte() % 3;
  map.trend = bytes.byte() % 4;
  const double unit = bytes.flag() ? number(bytes) : 1, offset = bytes.flag() ? number(bytes) : 0;
  const std::int32_t levels = bytes.whole() % 8;
  const double approach = bytes.flag() ? number(bytes) : 0;
  std::vector<double> heights = room(map.nx, map.ny);
  std::vector<std::uint8_t> mask(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const int value = bytes.whole();
    heights[i] = value == -128 ? number(bytes) : unit * (value / 16.0) + offset;
    mask[i] = value % 3 != 0;
  }
  map.heights = heights.data();

  const auto no_statistics = filled<rc_surface_statistics>();
  auto statistics = no_statistics;
  require_result(rc_surface_analyze(&map, &statistics), same(statistics, no_statistics));

  std::int64_t count = 0;
  const rc_status counted = rc_surface_psd(&map, nullptr, nullptr, nullptr, &count);
  if (counted == RC_OK) {
    require(count >= 0 && count <= map.nx * map.ny, "no more rings than modes");
    std::vector<double> q(static_cast<std::size_t>(count), untouched), psd = q;
    std::vector<std::int64_t> modes(static_cast<std::size_t>(count));
    require_result(rc_surface_psd(&map, q.data(), psd.data(), modes.data(), &count), kept(q) && kept(psd));
  }
  const auto no_law = filled<rc_surface_power_law>();
  auto law = no_law;
  require_result(rc_surface_fit(&map, &law), same(law, no_law));
  const auto no_advice = filled<rc_surface_cmr>();
  auto advice = no_advice;
  require_result(rc_surface_cmr_advice(&map, levels, approach, &advice), same(advice, no_advice));

  const std::int64_t nx = map.nx >= 1 && map.nx <= 64 ? (map.nx + 1) / 2 : 1,
                     ny = map.ny >= 1 && map.ny <= 64 ? (map.ny + 1) / 2 : 1;
  std::vector<double> coarse(static_cast<std::size_t>(nx * ny), untouched);
  std::vector<std::uint8_t> coarse_mask(coarse.size());
  const bool masked = bytes.flag();
  require_result(rc_surface_downsample(map.nx, map.ny, heights.data(), masked ? mask.data() : nullptr, bytes.byte() % 5,
                                       coarse.data(), bytes.flag() ? coarse_mask.data() : nullptr),
                 kept(coarse));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const std::size_t kind = bytes.below(6);
  if (kind < 3) {
    generate(bytes, kind);
  } else {
    analyze(bytes);
  }
  return 0;
}
