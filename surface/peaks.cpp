// A texture is a wave with much more power than the others of its length, and than longer and shorter waves of its direction.
// The first test: the powers of a Gaussian surface are exponentially distributed. The second: a surface with a lay is no texture.
#include "peaks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

constexpr std::int64_t fewest_waves = 4;  // over the map: fewer waves look like roughness
constexpr double least_share = 0.02;
constexpr double above_direction = 8;
constexpr std::int64_t cluster = 2;  // a wave under a window spreads over this many modes to each side
constexpr std::size_t most_candidates = 64;

struct Candidate {
  std::int64_t kx, ky;
  double power;
};

// Visits the modes up to `reach` away, along the directions that the map has.
template <class Visit> void around(const Spectrum& s, std::int64_t kx, std::int64_t ky, std::int64_t reach, const Visit& visit) {
  const std::int64_t reach_x = s.nx > 1 ? reach : 0, reach_y = s.ny > 1 ? reach : 0;
  for (std::int64_t y = ky - reach_y; y <= ky + reach_y; ++y)
    for (std::int64_t x = kx - reach_x; x <= kx + reach_x; ++x) visit(x, y);
}

double largest_around(const Spectrum& s, std::int64_t kx, std::int64_t ky, std::int64_t reach) {
  double largest = 0;
  around(s, kx, ky, reach, [&](std::int64_t x, std::int64_t y) { largest = std::max(largest, s.at(x, y)); });
  return largest;
}

std::size_t octave(double q, double lowest) { return static_cast<std::size_t>(std::max(0.0, 4 * std::log2(q / lowest) + 0.5)); }

// Visits half of the modes; the others are their conjugates.
template <class Visit> void half_of_the_modes(const Spectrum& s, const Visit& visit) {
  for (std::int64_t ky = 0; ky <= s.ny / 2; ++ky) {
    stop_if_asked();
    for (std::int64_t kx = ky == 0 ? 1 : -((s.nx - 1) / 2); kx <= s.nx / 2; ++kx) visit(kx, ky);
  }
}

// The mean power of waves of about one length. It follows from their median, which peaks do not move.
std::vector<double> backgrounds(const Spectrum& s, double lowest) {
  std::vector<std::vector<double>> values;
  half_of_the_modes(s, [&](auto kx, auto ky) {
    const double q = std::hypot(s.dx * static_cast<double>(kx), s.dy * static_cast<double>(ky));
    const std::size_t bin = octave(q, lowest);
    if (bin >= values.size()) values.resize(bin + 1);
    values[bin].push_back(s.at(kx, ky));
  });
  std::vector<double> means;
  for (auto& bin : values) {
    const auto middle = bin.begin() + static_cast<std::ptrdiff_t>(bin.size() / 2);
    if (!bin.empty()) std::nth_element(bin.begin(), middle, bin.end());
    means.push_back(bin.empty() ? 0 : *middle / std::log(2.0));
  }
  return means;
}

// A wave. Its wave number is the centre of power of its modes, so it lies between the grid lines of the spectrum.
struct Wave {
  double kx = 0, ky = 0, power = 0;
};

Wave wave_at(const Spectrum& s, const Candidate& c) {
  Wave wave;
  around(s, c.kx, c.ky, cluster, [&](std::int64_t kx, std::int64_t ky) {
    const double here = s.at(kx, ky);
    wave.power += here;
    wave.kx += here * static_cast<double>(kx);
    wave.ky += here * static_cast<double>(ky);
  });
  wave.kx /= wave.power;
  wave.ky /= wave.power;
  return wave;
}

// Whether a wave stands above the waves of its direction that are neither part of it nor its harmonics.
bool above_its_direction(const Spectrum& s, const Candidate& c, const Wave& wave) {
  const double size = std::max(std::abs(wave.kx), std::abs(wave.ky));
  std::vector<double> others;
  for (const double t : {0.3, 0.4, 0.6, 0.7, 1.35, 1.6, 2.5, 3.5}) {
    const auto kx = std::llround(t * wave.kx), ky = std::llround(t * wave.ky);
    if (std::abs(kx) > s.nx / 2 || std::abs(ky) > s.ny / 2) continue;
    if (std::abs(t - 1) * size < static_cast<double>(cluster) + 0.5) continue;
    others.push_back(largest_around(s, kx, ky, 1));
  }
  if (others.empty()) return false;
  const auto middle = others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2);
  std::ranges::nth_element(others, middle);
  return c.power > above_direction * *middle;
}

std::vector<Candidate> candidates(const Spectrum& s) {
  const double lowest = lowest_wave(s);
  const std::vector<double> background = backgrounds(s, lowest);
  // Powers are exponential: of N waves one exceeds ln N + 7 times the mean by chance with probability 0.1 %.
  const double factor = std::log(static_cast<double>(s.power.size())) + 7;
  std::vector<Candidate> found;
  half_of_the_modes(s, [&](auto kx, auto ky) {
    if (std::max(std::abs(kx), ky) < fewest_waves) return;
    const double power = s.at(kx, ky);
    const double q = std::hypot(s.dx * static_cast<double>(kx), s.dy * static_cast<double>(ky));
    if (!(power > factor * background[octave(q, lowest)]) || power < largest_around(s, kx, ky, cluster)) return;
    found.push_back({kx, ky, power});
  });
  std::ranges::sort(found, [](const Candidate& a, const Candidate& b) { return a.power > b.power; });
  if (found.size() > most_candidates) found.resize(most_candidates);
  return found;
}

}  // namespace

void find_peaks(Spectrum& s, rc_surface_power_law& law) {
  law.peaks = 0;
  double total = 0;
  for (const double power : s.power) total += power;
  for (const Candidate& c : candidates(s)) {
    if (law.peaks == RC_SURFACE_PEAKS) break;
    const Wave wave = wave_at(s, c);
    if (2 * wave.power / total < least_share || !above_its_direction(s, c, wave)) continue;
    law.peak_qx[law.peaks] = s.dx * wave.kx;
    law.peak_qy[law.peaks] = s.dy * wave.ky;
    law.peak_share[law.peaks] = std::min(1.0, 2 * wave.power / total);
    ++law.peaks;
    around(s, c.kx, c.ky, cluster, [&s](std::int64_t kx, std::int64_t ky) {
      s.texture[s.index(kx, ky)] = true;
      s.texture[s.index(-kx, -ky)] = true;
    });
  }
}

}  // namespace rc::surface
