#include "analysis/histogram.h"

#include <algorithm>
#include <cmath>

#include "core/array.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr std::int64_t most_bins = std::int64_t{1} << 40;

// Bins are open below: the largest pressure is in the last one, and no pressure in contact is at the lower end of the first.
std::int64_t bin_of(double p, double upper, std::int64_t bins) {
  const auto k = static_cast<std::int64_t>(std::ceil(p / upper * static_cast<double>(bins))) - 1;
  return std::clamp<std::int64_t>(k, 0, bins - 1);
}

}  // namespace

void fill_histogram(const ContactMap& map, rc_histogram& out) {
  if (out.bins < 1) fail(RC_ERR_ARGUMENT, "rc_histogram.bins = ", out.bins, " must be >= 1");
  if (out.bins > most_bins) fail(RC_ERR_ARGUMENT, "rc_histogram.bins = ", out.bins, " must be <= ", most_bins);
  if (!(std::isfinite(out.upper) && out.upper >= 0))
    fail(RC_ERR_ARGUMENT, "rc_histogram.upper = ", out.upper, " must be finite and >= 0 (0: the largest pressure)");

  out.contacts = out.above = 0;
  out.max_pressure = 0;
  double sum = 0;
  for (std::int64_t i = 0; i < map.points(); ++i) {
    if (!map.touches(i)) continue;
    ++out.contacts;
    sum += map.pressure(i);
    out.max_pressure = std::max(out.max_pressure, map.pressure(i));
  }
  const auto contacts = static_cast<double>(out.contacts);
  out.mean_pressure = out.contacts > 0 ? sum / contacts : 0;
  const double upper = out.upper > 0 ? out.upper : out.max_pressure;
  out.width = upper / static_cast<double>(out.bins);
  if (out.contacts > 0 && !std::isnormal(out.width))
    fail(RC_ERR_ARGUMENT, "bins of ", upper, " / ", out.bins, " are beyond double precision; choose other units");

  std::int64_t* const counts = values_of<std::int64_t>(out.counts);
  double* const density = values_of<double>(out.density);
  if (counts) std::fill_n(counts, out.bins, 0);
  if (density) std::fill_n(density, out.bins, 0.0);
  for (std::int64_t i = 0; i < map.points(); ++i) {
    if (!map.touches(i)) continue;
    if (map.pressure(i) > upper) {
      ++out.above;
      continue;
    }
    const std::int64_t k = bin_of(map.pressure(i), upper, out.bins);
    if (counts) ++counts[k];
    if (density) ++density[k];
  }
  if (density && out.contacts > 0)
    for (std::int64_t k = 0; k < out.bins; ++k) density[k] /= contacts * out.width;
}

}  // namespace rc
