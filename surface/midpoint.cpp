#include "midpoint.h"

#include <cmath>
#include <cstdint>

#include "gaussian.h"
#include "heights.h"

namespace rc::surface {

namespace {

class Vertices {
 public:
  Vertices(const rc_surface_rmd_spec& spec, int stage)
      : spec_(spec),
        last_(std::int64_t{1} << stage),
        z_(static_cast<std::size_t>((last_ + 1) * (last_ + 1))),
        random_(spec.seed) {
    deviation_ = spec.sigma;
    displace(0, 0, last_, last_);
    // Each half stage shrinks distances by sqrt(2) and heights by 2^(-H/2).
    const double shrink = portable_exp(-0.5 * spec.hurst * ln2);
    for (std::int64_t step = last_; step > 1; step /= 2) {
      const std::int64_t half = step / 2;
      deviation_ *= shrink;
      centres(step, half);
      if (spec_.additions) displace(0, 0, step, last_);
      deviation_ *= shrink;
      edges(step, half);
      if (spec_.additions) {
        displace(0, 0, step, last_);
        displace(half, half, step, last_);
      }
    }
  }

  std::vector<double> take() && { return std::move(z_); }

 private:
  double& at(std::int64_t x, std::int64_t y) { return z_[static_cast<std::size_t>(y * (last_ + 1) + x)]; }

  void displace(std::int64_t x0, std::int64_t y0, std::int64_t step, std::int64_t end) {
    for (std::int64_t y = y0; y <= end; y += step)
      for (std::int64_t x = x0; x <= end; x += step) at(x, y) += deviation_ * random_();
  }

  void centres(std::int64_t step, std::int64_t half) {
    for (std::int64_t y = half; y < last_; y += step) {
      for (std::int64_t x = half; x < last_; x += step) {
        const double corners =
            (at(x - half, y - half) + at(x + half, y - half)) + (at(x - half, y + half) + at(x + half, y + half));
        at(x, y) = 0.25 * corners + deviation_ * random_();
      }
    }
  }

  // Midpoints of the squares' sides: means of their two ends and of the one or two centres beside them.
  void edges(std::int64_t step, std::int64_t half) {
    for (std::int64_t y = 0; y <= last_; y += half) {
      for (std::int64_t x = (y / half) % 2 == 0 ? half : 0; x <= last_; x += step) {
        double sum = 0;
        int neighbours = 0;
        const auto add = [&](std::int64_t nx, std::int64_t ny) {
          if (nx < 0 || ny < 0 || nx > last_ || ny > last_) return;
          sum += at(nx, ny);
          ++neighbours;
        };
        add(x, y - half);
        add(x - half, y);
        add(x + half, y);
        add(x, y + half);
        at(x, y) = sum / neighbours + deviation_ * random_();
      }
    }
  }

  const rc_surface_rmd_spec& spec_;
  std::int64_t last_;
  std::vector<double> z_;
  Gaussian random_;
  double deviation_ = 0;
};

}  // namespace

std::vector<double> midpoint_displacement(const rc_surface_rmd_spec& given, int stage) {
  rc_surface_rmd_spec spec = given;
  if (!(spec.rms_height > 0)) return Vertices(spec, stage).take();

  // All stages draw from one random sequence, coarse ones first, so a stage does not depend on those after it.
  spec.sigma = 1;
  std::vector<double> z = Vertices(spec, spec.levels).take();
  const double scale = spec.rms_height / std::sqrt(variance(z));
  if (stage < spec.levels) z = Vertices(spec, stage).take();
  for (double& value : z) value *= scale;
  return z;
}

}  // namespace rc::surface
