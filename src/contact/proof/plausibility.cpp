#include "contact/proof/plausibility.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rc {

namespace {

constexpr std::int64_t most_samples = 32;  // along each side
constexpr std::size_t least_judged_points = 16;
constexpr double most_mean_pressure = 0.1;  // over E*
constexpr double most_tilt = 0.5;

struct Sample {
  double x, y, z;
};

std::vector<Sample> samples_of(const StepSurface& surface, std::int64_t nx, std::int64_t ny) {
  const std::int64_t mx = std::min(nx, most_samples), my = std::min(ny, most_samples);
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(mx * my));
  for (std::int64_t j = 0; j < my; ++j)
    for (std::int64_t i = 0; i < mx; ++i) {
      const std::int64_t x = (2 * i + 1) * nx / (2 * mx), row = (2 * j + 1) * ny / (2 * my), y = row - surface.first_row();
      const auto point = static_cast<std::size_t>(y * nx + x);
      if (y < 0 || y >= surface.points() / nx) continue;  // another rank's
      if (surface.included(point))
        samples.push_back({static_cast<double>(x), static_cast<double>(row), surface.height(point) / surface.range()});
    }
  return surface.ranks() ? surface.ranks()->of_any(samples) : samples;
}

std::string text(const char* format, double value) {
  char written[96];
  std::snprintf(written, sizeof written, format, value);
  return written;
}

}  // namespace

double plane_share(const StepSurface& surface, std::int64_t nx, std::int64_t ny) {
  if (!(surface.range() > 0)) return 0;
  const std::vector<Sample> samples = samples_of(surface, nx, ny);
  if (samples.size() < least_judged_points) return 0;
  const double n = static_cast<double>(samples.size());
  Sample mean{};
  for (const Sample& s : samples) mean = {mean.x + s.x, mean.y + s.y, mean.z + s.z};
  mean = {mean.x / n, mean.y / n, mean.z / n};
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  for (const Sample& s : samples) {
    const double x = s.x - mean.x, y = s.y - mean.y, z = s.z - mean.z;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xz += x * z;
    yz += y * z;
    zz += z * z;
  }
  if (!(zz > 0)) return 0;
  const double determinant = xx * yy - xy * xy;
  if (determinant > 1e-9 * xx * yy) return (xz * xz * yy - 2 * xz * yz * xy + yz * yz * xx) / determinant / zz;
  return std::max(xx > 0 ? xz * xz / xx : 0, yy > 0 ? yz * yz / yy : 0) / zz;  // points on a line
}

std::vector<std::string> doubts(const System& system, const rc_result& result, double compression, double tilt) {
  const rc_system& s = system.given;
  std::vector<std::string> remarks;
  if (result.mean_pressure > most_mean_pressure * s.modulus)
    remarks.push_back(text("mean pressure %.3g E*: check the units", result.mean_pressure / s.modulus));
  if (compression > std::max(s.hx * static_cast<double>(s.nx), s.hy * static_cast<double>(s.ny)))
    remarks.push_back("approach above the grid's side: check the units");
  if (result.contacts == 1 && system.points() > 1) remarks.push_back("one point in contact: check the pitch");
  if (tilt > most_tilt) remarks.push_back(text("a plane is %.0f %% of the heights' variance: level them", 100 * tilt));
  return remarks;
}

}  // namespace rc
