// The method: the radial PSD is cut into straight lines on logarithmic axes. The longest line that falls as steeply as a
// self-affine surface's, or more steeply, is the power law; it is fitted again without its ends. The roll-off is the knee of
// "flat, then this line", if that fits the lower end much better than the line alone. Beyond the cut-off the PSD stays below the
// line.
#include "power_law.h"

#include <gsl/gsl_sf_psi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "line_fit.h"
#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

constexpr double bin_width = 0.25 * 0.69314718055994531;  // a quarter octave
constexpr double no_power = 1e-20;                        // relative to the largest bin
constexpr double model_variance = 0.3 * 0.3;              // so that the waviness of real spectra does not make pieces of its own
constexpr double piece_price = 12;                        // in squared deviations
constexpr std::size_t shortest_piece = 3;
constexpr double largest_error = 0.5;     // of a Hurst exponent that is of any use
constexpr double shortest_range = 1.151;  // half a decade, as a logarithm
constexpr double noticeable_bend = 0.15;  // in the Hurst exponent
constexpr double left_for_good = 0.7;     // below the line, as a logarithm

struct Columns {
  std::vector<double> x, y, variance;
};

Columns columns(const std::vector<Bin>& bins, std::size_t first, std::size_t end, double extra) {
  Columns result;
  for (std::size_t i = first; i < end; ++i) {
    result.x.push_back(bins[i].x);
    result.y.push_back(bins[i].y);
    result.variance.push_back(bins[i].variance + extra);
  }
  return result;
}

struct Range {
  std::size_t first = 0, end = 0;
  bool empty() const { return first == end; }
};

Line fit(const std::vector<Bin>& bins, const Range& range) {
  const Columns points = columns(bins, range.first, range.end, 0);
  return fit_line(points.x, points.y, points.variance);
}

Range longest_power_law(const std::vector<Bin>& bins, int dimensions) {
  const Columns all = columns(bins, 0, bins.size(), model_variance);
  const auto cuts = cut_into_lines(all.x, all.y, all.variance, shortest_piece, piece_price);
  Range best;
  double longest = shortest_range;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Range range{cuts[k], cuts[k + 1]};
    const double length = bins[range.end - 1].x - bins[range.first].x + bin_width;
    if (range.end - range.first < shortest_piece || length < longest) continue;
    const Columns piece = columns(bins, range.first, range.end, model_variance);
    if (fit_line(piece.x, piece.y, piece.variance).slope > -dimensions) continue;
    best = range;
    longest = length;
  }
  return best;
}

// Sampling folds waves beyond the Nyquist wave number back. If the surface has such waves (or the instrument noise), the spectrum
// bends upwards in the last two octaves, and they are left out.
void leave_out_aliases(const std::vector<Bin>& bins, double nyquist, Range& range, Line& line) {
  Range lower = range;
  while (lower.end > lower.first && bins[lower.end - 1].x > std::log(nyquist / 4)) --lower.end;
  if (lower.end == range.end || lower.end - lower.first < 2 * shortest_piece) return;
  const Line below = fit(bins, lower);
  const Range upper{lower.end, bins.size()};
  if (upper.end - upper.first < shortest_piece) return;
  if (fit(bins, upper).slope < below.slope + below.slope_error + noticeable_bend) return;
  range = lower;
  line = below;
}

// Squared deviations of the bins below `end` from the line that is flat below the knee.
double misfit(const std::vector<Bin>& bins, std::size_t end, const Line& line, double knee) {
  double sum = 0;
  for (std::size_t i = 0; i < end; ++i) {
    const double d = bins[i].y - line.at(std::max(bins[i].x, knee));
    sum += d * d / (bins[i].variance + model_variance);
  }
  return sum;
}

double find_roll_off(const std::vector<Bin>& bins, const Range& range, const Line& line) {
  double best = bins.front().x, least = misfit(bins, range.end, line, best);
  const double line_alone = least;
  constexpr double step = 0.01;  // of ln q
  const auto steps = std::lround((bins[range.end - 1].x - bins.front().x) / step);
  for (long k = 0; k < steps; ++k) {
    const double knee = bins.front().x + step * static_cast<double>(k);
    const double here = misfit(bins, range.end, line, knee);
    if (here < least) {
      best = knee;
      least = here;
    }
  }
  const auto below = std::ranges::count_if(bins, [best](const Bin& bin) { return bin.x < best; });
  return below >= 2 && line_alone - least > piece_price ? std::exp(best) : no_value;
}

double find_cut_off(const std::vector<Bin>& bins, const Range& range, const Line& line, double nyquist) {
  std::size_t i = bins.size();
  while (i > range.first && bins[i - 1].y < line.at(bins[i - 1].x) - left_for_good) --i;
  if (i < bins.size() && i > 0) return std::exp(0.5 * (bins[i].x + bins[i - 1].x));
  const double last = bins.back().x + 0.5 * bin_width;  // bins without power are not in the list
  return last < std::log(nyquist) - 1.01 * bin_width ? std::exp(last) : no_value;
}

}  // namespace

std::vector<Bin> logarithmic_bins(const Spectrum& s) {
  struct Sum {
    double log_q = 0, power = 0, modes = 0;
  };
  std::vector<Sum> sums;
  const double lowest = std::log(lowest_wave(s));
  double total = 0;
  for (std::int64_t ky = 0; ky < s.ny; ++ky) {
    stop_if_asked();
    for (std::int64_t kx = 0; kx < s.nx; ++kx) {
      const double q = s.q(kx, ky);
      total += s.at(kx, ky);
      if (!(q > 0) || q > s.nyquist * (1 + 1e-12) || s.texture[s.index(kx, ky)]) continue;
      const auto bin = static_cast<std::size_t>(std::max(0L, std::lround((std::log(q) - lowest) / bin_width)));
      if (bin >= sums.size()) sums.resize(bin + 1);
      sums[bin].log_q += std::log(q);
      sums[bin].power += s.at(kx, ky);
      sums[bin].modes += 1;
    }
  }

  double largest = 0;
  for (const Sum& sum : sums) largest = std::max(largest, sum.modes > 0 ? sum.power / sum.modes : 0);
  std::vector<Bin> bins;
  for (const Sum& sum : sums) {
    if (!(sum.modes > 0) || !(sum.power / sum.modes > no_power * largest)) continue;
    // The mean of m exponential variables is Gamma distributed: ln of it has mean psi(m) - ln m and variance psi'(m).
    const double m = 1 + std::max(0.0, sum.modes - 2) / s.shared;  // two conjugate modes are one variable
    gsl_sf_result psi{}, psi1{};                                   // arguments are positive: none of GSL's errors can occur
    gsl_sf_psi_e(m, &psi);
    gsl_sf_psi_1_e(m, &psi1);
    bins.push_back(
        {sum.log_q / sum.modes, std::log(sum.power / sum.modes) - (psi.val - std::log(m)), psi1.val, sum.power / total});
  }
  return bins;
}

void find_power_law(const Spectrum& s, rc_surface_power_law& law) {
  law.hurst = law.hurst_error = law.slope = law.prefactor = law.q_min = law.q_max = law.q_rolloff = law.q_cutoff = no_value;
  const std::vector<Bin> bins = logarithmic_bins(s);
  if (bins.size() < shortest_piece) return;
  const Range range = longest_power_law(bins, s.dimensions);
  if (range.empty()) return;

  // Leaves out the bins at the ends: a knee may lie in them. Under a window the lowest bins also hold what leaks from the trend.
  Range inner = range;
  if (inner.first > 0) ++inner.first;
  if (inner.end < bins.size()) --inner.end;
  if (inner.end - inner.first < shortest_piece) inner = range;
  const double under_window = std::log(4 * lowest_wave(s));
  while (s.windowed && bins[inner.first].x < under_window && inner.end - inner.first > 2 * shortest_piece) ++inner.first;
  Line line = fit(bins, inner);
  // A short flat part may have been taken as a part of the line.
  const double roll_off = find_roll_off(bins, inner, line);
  Range above = inner;
  while (above.first < above.end && bins[above.first].x < std::log(roll_off) + bin_width) ++above.first;
  if (above.first > inner.first && above.end - above.first >= shortest_piece) {
    inner = above;
    line = fit(bins, inner);
  }
  leave_out_aliases(bins, s.nyquist, inner, line);
  if (line.slope_error / 2 > largest_error) return;

  law.slope = line.slope;
  law.hurst = -(line.slope + s.dimensions) / 2;
  law.hurst_error = line.slope_error / 2;
  law.prefactor = std::exp(line.intercept);
  law.q_min = std::exp(bins[inner.first].x - 0.5 * bin_width);
  law.q_max = std::min(std::exp(bins[inner.end - 1].x + 0.5 * bin_width), s.nyquist);
  law.q_rolloff = find_roll_off(bins, inner, line);
  law.q_cutoff = find_cut_off(bins, inner, line, s.nyquist);
}

}  // namespace rc::surface
