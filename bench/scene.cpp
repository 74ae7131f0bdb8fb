#include "scene.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <new>
#include <numbers>

namespace bench {

namespace {

constexpr double pi = std::numbers::pi;

// One step of splitmix64 (Steele, Lea & Flood 2014), as a hash.
std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double random_phase(std::uint64_t seed, std::int64_t kx, std::int64_t ky) {
  const std::uint64_t wave = (static_cast<std::uint64_t>(kx) << 32) ^ static_cast<std::uint32_t>(ky);
  return 2 * pi * std::ldexp(static_cast<double>(mix(mix(seed) ^ wave) >> 11), -53);
}

// Squared distance of each cell's centre from the middle of the square.
template <class Value> Field radial(std::int64_t n, const Value& value) {
  Field field;
  field.reserve(static_cast<std::size_t>(n * n));
  const auto offset = [n](std::int64_t i) { return (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 0.5; };
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix) field.push_back(value(offset(ix) * offset(ix) + offset(iy) * offset(iy)));
  return field;
}

}  // namespace

Field self_affine_gap(std::int64_t n, const SelfAffine& surface) {
  const std::int64_t half = n / 2 + 1, width = 2 * half;
  const double cut_off = surface.cut_off > 0 ? surface.cut_off : static_cast<double>(n) / 8;
  const std::unique_ptr<double[], void (*)(void*)> storage(fftw_alloc_real(static_cast<std::size_t>(n * width)), fftw_free);
  if (!storage) throw std::bad_alloc();
  auto* const spectrum = reinterpret_cast<std::complex<double>*>(storage.get());
  std::fill_n(spectrum, n * half, std::complex<double>());

  double square_slope = 0;
  const auto longest = static_cast<std::int64_t>(cut_off);
  for (std::int64_t ky = -longest; ky <= longest; ++ky) {
    for (std::int64_t kx = 0; kx <= longest; ++kx) {
      const double k = std::hypot(static_cast<double>(kx), static_cast<double>(ky));
      if (k > cut_off || (kx == 0 && ky <= 0)) continue;
      const double amplitude = std::pow(std::max(k, surface.roll_off), -(1 + surface.hurst));
      square_slope += 2 * std::pow(2 * pi * k * amplitude, 2);
      // Half a cell further: the centre of the first cell.
      const double phase = random_phase(surface.seed, kx, ky) + pi * static_cast<double>(kx + ky) / static_cast<double>(n);
      spectrum[(ky < 0 ? ky + n : ky) * half + kx] = std::polar(amplitude, phase);
      if (kx == 0) spectrum[(n - ky) * half] = std::polar(amplitude, -phase);
    }
  }
  const int size = static_cast<int>(n);
  fftw_plan plan = fftw_plan_dft_c2r_2d(size, size, reinterpret_cast<fftw_complex*>(spectrum), storage.get(), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);

  const double scale = surface.rms_slope / std::sqrt(square_slope);
  Field gap(static_cast<std::size_t>(n * n));
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix)
      gap[static_cast<std::size_t>(iy * n + ix)] = scale * storage[static_cast<std::size_t>(iy * width + ix)];
  return gap;
}

double Hertz::approach() const { return contact_radius * contact_radius; }
double Hertz::load() const { return 4.0 / 3.0 * std::pow(contact_radius, 3); }
double Hertz::contact_area() const { return pi * contact_radius * contact_radius; }

Field Hertz::gap(std::int64_t n) const {
  return radial(n, [](double square) { return square / 2; });
}

Field Hertz::pressure(std::int64_t n) const {
  return radial(n, [a = contact_radius](double square) { return 2 / pi * std::sqrt(std::max(0.0, a * a - square)); });
}

}  // namespace bench
