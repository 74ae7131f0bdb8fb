#include "spectral.h"

#include <algorithm>
#include <cmath>

#include "fourier.h"
#include "gaussian.h"
#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

// The square root of the PSD up to a factor.
class Amplitude {
 public:
  explicit Amplitude(const rc_surface_spectral_spec& spec)
      : low_(spec.q_low), roll_off_(spec.q_rolloff), high_(spec.q_high > 0 ? spec.q_high : pi / std::max(spec.hx, spec.hy)) {
    const int dimensions = spec.nx > 1 && spec.ny > 1 ? 2 : 1;
    exponent_ = -0.5 * dimensions - spec.hurst;
  }

  // Round-off must not exclude the ends of the band.
  double operator()(double q) const {
    if (!(q > 0) || q < low_ * (1 - 1e-12) || q > high_ * (1 + 1e-12)) return 0;
    return std::pow(std::max(q, roll_off_) / high_, exponent_);
  }

 private:
  double low_, roll_off_, high_, exponent_;
};

}  // namespace

std::vector<double> self_affine(const rc_surface_spectral_spec& spec) {
  const auto points = static_cast<std::size_t>(spec.nx * spec.ny);
  std::vector<Complex> a(points);
  Gaussian random{spec.seed};
  for (Complex& value : a) value = random();
  fourier(a, spec.nx, spec.ny, Direction::forward);

  const Amplitude amplitude{spec};
  const double dx = 2 * pi / (static_cast<double>(spec.nx) * spec.hx), dy = 2 * pi / (static_cast<double>(spec.ny) * spec.hy);
  double height = 0, slope = 0;
  for (std::int64_t iy = 0; iy < spec.ny; ++iy) {
    stop_if_asked();
    for (std::int64_t ix = 0; ix < spec.nx; ++ix) {
      Complex& value = a[static_cast<std::size_t>(iy * spec.nx + ix)];
      const double q =
          std::hypot(dx * static_cast<double>(signed_index(ix, spec.nx)), dy * static_cast<double>(signed_index(iy, spec.ny)));
      const double wanted = amplitude(q), size = std::abs(value);
      value = spec.fixed_amplitudes ? (size > 0 ? value * (wanted / size) : Complex{wanted}) : value * wanted;
      height += std::norm(value);
      slope += q * q * std::norm(value);
    }
  }
  if (!(height > 0)) fail(RC_ERR_ARGUMENT, "no wave of the grid lies between the cut-offs q_low and q_high");

  const double scale = spec.rms_height > 0 ? spec.rms_height / std::sqrt(height) : spec.rms_slope / std::sqrt(slope);
  fourier(a, spec.nx, spec.ny, Direction::backward);
  std::vector<double> z(points);
  std::ranges::transform(a, z.begin(), [scale](Complex value) { return scale * value.real(); });
  return z;
}

namespace {

// 1 at multiples of the period, 0 half way between.
double triangle(double x, double period) {
  if (!(period > 0)) return 1;
  const double t = std::abs(x / period - std::floor(x / period) - 0.5);
  return 2 * t;
}

double wave(double x, double period) { return period > 0 ? std::cos(2 * pi * std::remainder(x / period, 1.0)) : 1; }

double cap(double r2, const rc_surface_shape_spec& spec) {
  const double radius = spec.radius;
  if (spec.shape == RC_SURFACE_PARABOLOID) return -r2 / (2 * radius);
  const double root2 = radius * radius - r2;
  return root2 > 0 ? -r2 / (radius + std::sqrt(root2)) : -radius;  // sqrt(R^2 - r^2) - R without its cancellation
}

}  // namespace

void shape(const rc_surface_shape_spec& spec, double* out) {
  Gaussian random{spec.seed};
  for (std::int64_t iy = 0; iy < spec.ny; ++iy) {
    stop_if_asked();
    for (std::int64_t ix = 0; ix < spec.nx; ++ix, ++out) {
      const double x = static_cast<double>(ix) * spec.hx, y = static_cast<double>(iy) * spec.hy;
      switch (spec.shape) {
        case RC_SURFACE_WAVES:
          *out = spec.height * wave(x, spec.period_x) * wave(y, spec.period_y);
          break;
        case RC_SURFACE_PYRAMIDS:
          *out = spec.height * std::min(triangle(x, spec.period_x), triangle(y, spec.period_y));
          break;
        case RC_SURFACE_NOISE:
          *out = spec.height * random();
          break;
        default: {
          const double dx = x - 0.5 * static_cast<double>(spec.nx - 1) * spec.hx;
          const double dy = y - 0.5 * static_cast<double>(spec.ny - 1) * spec.hy;
          *out = cap(dx * dx + dy * dy, spec);
        }
      }
    }
  }
}

}  // namespace rc::surface
