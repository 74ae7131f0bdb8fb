#include "spectrum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fourier.h"
#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

// Hann's window at the middles of n cells; its mean square is 3/8 from n = 3 on.
std::vector<double> hann(std::int64_t n) {
  std::vector<double> window;
  for (std::int64_t k = 0; k < n; ++k) {
    const double s = std::sin(pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
    window.push_back(s * s);
  }
  return window;
}

void apply_window(const Heights& heights, std::vector<Complex>& values) {
  const auto wx = hann(heights.nx), wy = hann(heights.ny);
  double weight = 0, level = 0, square = 0;
  const auto each = [&](const auto& visit) {
    std::size_t i = 0;
    for (const double y : wy)
      for (const double x : wx) visit(x * y, values[i++]);
  };
  each([&](double w, const Complex& z) {
    weight += w;
    square += w * w;
    level += w * z.real();
  });
  level /= weight;
  const double scale = 1 / std::sqrt(square / static_cast<double>(values.size()));
  each([&](double w, Complex& z) { z = (z - level) * (w * scale); });
}

std::int64_t modulo(std::int64_t k, std::int64_t n) { return ((k % n) + n) % n; }

}  // namespace

double Spectrum::q(std::int64_t kx, std::int64_t ky) const {
  return std::hypot(dx * static_cast<double>(signed_index(kx, nx)), dy * static_cast<double>(signed_index(ky, ny)));
}

std::size_t Spectrum::index(std::int64_t kx, std::int64_t ky) const {
  return static_cast<std::size_t>(modulo(ky, ny) * nx + modulo(kx, nx));
}

Spectrum spectrum(const Heights& heights) {
  Spectrum result{heights.nx,
                  heights.ny,
                  2 * pi / (static_cast<double>(heights.nx) * heights.hx),
                  2 * pi / (static_cast<double>(heights.ny) * heights.hy),
                  heights.area(),
                  std::max(heights.dimensions(), 1),
                  0,
                  !heights.periodic,
                  2,
                  {},
                  {}};
  const double pitch = std::max(heights.nx > 1 ? heights.hx : 0, heights.ny > 1 ? heights.hy : 0);
  result.nyquist = pitch > 0 ? pi / pitch : 0;

  std::vector<Complex> a(heights.z.begin(), heights.z.end());
  if (!heights.periodic) {
    apply_window(heights, a);
    // Sum over k of |DFT(w^2)_k / DFT(w^2)_0|^2 for w^2 = sin^4: neighbouring modes are correlated.
    result.shared *= std::pow(1 + 2 * (4.0 / 9 + 1.0 / 36), result.dimensions);
  }
  fourier(a, heights.nx, heights.ny, Direction::forward);
  const auto points = static_cast<double>(a.size());
  result.power.reserve(a.size());
  for (const Complex value : a) result.power.push_back(std::norm(value / points) * result.area);
  result.power.front() = 0;
  result.texture.assign(a.size(), false);
  return result;
}

double lowest_wave(const Spectrum& s) { return s.nx == 1 ? s.dy : s.ny == 1 ? s.dx : std::min(s.dx, s.dy); }

namespace {

// The index of the outermost ring.
std::int64_t last_ring(const Spectrum& s, double width) {
  const double last = s.q(s.nx / 2, s.ny / 2) / width;
  if (last < 9e18) return std::llround(last);
  fail(RC_ERR_ARGUMENT, "map.hx and map.hy make the wave numbers of one wave ", s.dx, " along x and ", s.dy,
       " along y, of the shortest wave ", last, " times the least of them, limit 9e18; give pitches of similar size");
}

void add(Ring& ring, double q, double power) {
  ring.q += q;
  ring.power += power;
  ++ring.modes;
}

// Sums over the modes of every ring, in an array with a place for every ring.
std::vector<Ring> dense_sums(const Spectrum& s, double width, std::int64_t last) {
  std::vector<Ring> all(static_cast<std::size_t>(last) + 1);
  for (std::int64_t ky = 0; ky < s.ny; ++ky) {
    stop_if_asked();
    for (std::int64_t kx = 0; kx < s.nx; ++kx) {
      if (kx == 0 && ky == 0) continue;
      const double q = s.q(kx, ky);
      add(all[static_cast<std::size_t>(std::llround(q / width))], q, s.at(kx, ky));
    }
  }
  std::erase_if(all, [](const Ring& ring) { return ring.modes == 0; });
  return all;
}

// The same for pitches that differ so much that most rings are empty.
std::vector<Ring> sparse_sums(const Spectrum& s, double width) {
  std::vector<std::pair<std::int64_t, std::int64_t>> modes;  // ring, ky*nx + kx
  modes.reserve(s.power.size());
  for (std::int64_t i = 1; i < s.nx * s.ny; ++i) modes.emplace_back(std::llround(s.q(i % s.nx, i / s.nx) / width), i);
  std::ranges::sort(modes);
  std::vector<Ring> all;
  std::int64_t current = -1;
  for (const auto& [number, i] : modes) {
    if (number != current) all.emplace_back();
    current = number;
    add(all.back(), s.q(i % s.nx, i / s.nx), s.power[static_cast<std::size_t>(i)]);
  }
  return all;
}

}  // namespace

std::vector<Ring> rings(const Spectrum& s) {
  const double width = lowest_wave(s);
  const std::int64_t last = last_ring(s, width), modes = s.nx * s.ny;
  std::vector<Ring> all = last <= 2 * modes ? dense_sums(s, width, last) : sparse_sums(s, width);
  for (Ring& ring : all) {
    ring.q /= static_cast<double>(ring.modes);
    ring.power /= static_cast<double>(ring.modes);
  }
  return all;
}

}  // namespace rc::surface
