#include "contact/proof/plausibility.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rc {

namespace {

constexpr std::int64_t most_samples = 32;  // along each side
constexpr std::size_t least_judged_points = 16;
constexpr double most_mean_pressure = 0.1;  // over E*
constexpr double least_hardness = 1e-3;     // over E*; metals, polymers and ceramics have 4e-3 to 0.1
constexpr double most_tilt = 0.5;
constexpr double most_of_punch = 0.5;  // stiffness over that of the grid as a flat punch
constexpr double rim_width = 0.025;
constexpr std::int64_t least_rimmed = 16;  // points along a side

struct Sample {
  double x, y, z;
};

std::vector<Sample> samples_of(const StepSurface& surface, std::int64_t nx, std::int64_t ny) {
  const std::int64_t mx = std::min(nx, most_samples), my = std::min(ny, most_samples);
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(mx * my));
  for (std::int64_t j = 0; j < my; ++j)
    for (std::int64_t i = 0; i < mx; ++i) {
      const std::int64_t x = (2 * i + 1) * nx / (2 * mx), row = (2 * j + 1) * ny / (2 * my),
                         y = row - surface.points().rows().first();
      const auto point = static_cast<std::size_t>(y * nx + x);
      if (y < 0 || y >= surface.points().count() / nx) continue;  // another process's
      if (surface.included(point))
        samples.push_back({static_cast<double>(x), static_cast<double>(row), surface.height(point) / surface.range().width()});
    }
  return surface.points().rows().joined(std::move(samples));
}

// The mean height of the samples at x or y = place.
double mean_at(const std::vector<Sample>& samples, double Sample::*axis, double place) {
  double sum = 0, n = 0;
  for (const Sample& s : samples) {
    sum += s.*axis == place ? s.z : 0;
    n += s.*axis == place ? 1 : 0;
  }
  return sum / n;
}

// Whether the heights jump from one end of an axis to the other by more than half of what a plane of this slope rises.
bool jumps(const std::vector<Sample>& samples, double Sample::*axis, double slope, std::int64_t points) {
  const auto [least, most] = std::ranges::minmax(samples, {}, axis);
  const double step = mean_at(samples, axis, most.*axis) - mean_at(samples, axis, least.*axis);
  return std::abs(step) > 0.5 * std::abs(slope) * static_cast<double>(points) && slope != 0;
}

std::string text(const char* format, double value) {
  char written[96];
  std::snprintf(written, sizeof written, format, value);
  return written;
}

}  // namespace

double plane_share(const StepSurface& surface, std::int64_t nx, std::int64_t ny, bool periodic) {
  if (!(surface.range().width() > 0)) return 0;
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
  // A wave as long as the grid looks like a plane to the fit, but repeats.
  if (periodic && !(xx > 0 && jumps(samples, &Sample::x, xz / xx, nx)) && !(yy > 0 && jumps(samples, &Sample::y, yz / yy, ny)))
    return 0;
  if (determinant > 1e-9 * xx * yy) return (xz * xz * yy - 2 * xz * yz * xy + yz * yz * xx) / determinant / zz;
  return std::max(xx > 0 ? xz * xz / xx : 0, yy > 0 ? yz * yz / yy : 0) / zz;  // points on a line
}

RimPoints::RimPoints(const rc_system& system, std::int64_t first_row)
    : nx_(system.nx),
      ny_(system.ny),
      first_row_(first_row),
      wide_(static_cast<std::int64_t>(std::ceil(rim_width * static_cast<double>(nx_)))),
      high_(static_cast<std::int64_t>(std::ceil(rim_width * static_cast<double>(ny_)))),
      rows_per_point_(1 / static_cast<double>(nx_)),
      any_(system.op == RC_OPERATOR_HALFSPACE && system.boundary == RC_BOUNDARY_FREE && std::min(nx_, ny_) >= least_rimmed) {}

double RimPoints::share() const {
  const double inner = static_cast<double>((nx_ - 2 * wide_) * (ny_ - 2 * high_));
  return any_ ? 1 - inner / (static_cast<double>(nx_) * static_cast<double>(ny_)) : 0;
}

std::string edge_effects(double of_punch, const Rim& rim, double tilt) {
  std::string seen;
  if (tilt > most_tilt) return seen;  // such a map touches at its edge because of that
  if (rim.load > rim.points)
    seen = text("%.0f %% of the load", 100 * rim.load) + (rim.largest ? " and the largest pressure" : "") + " at the rim";
  else if (rim.largest)
    seen = "the largest pressure at the rim";
  if (of_punch > most_of_punch) seen += (seen.empty() ? "" : ", ") + text("stiffness %.2g of a flat punch", of_punch);
  return seen.empty() ? "" : "free edges: " + seen + " (a sample is periodic)";
}

bool isolated_peak(const System& system, const StepSurface& surface, const Deflected& answer,
                   std::span<const std::size_t> touching) {
  struct Peak {
    double p = 0;
    std::int64_t point = -1;
    Peak operator+(const Peak& b) const { return b.p > p || (b.p == p && b.point < point) ? b : *this; }
  };
  struct Count {
    std::int64_t n = 0;
    Count operator+(const Count& b) const { return {n + b.n}; }
  };
  const rc_system& s = system.given;
  const std::int64_t first = surface.points().rows().first() * s.nx;
  const auto place = [&](std::size_t k) { return first + static_cast<std::int64_t>(answer.point(k)); };
  const Peak peak = surface.points().combined_over<Peak>(touching, [&](Peak& part, std::size_t k) {
    part = part + Peak{answer.p()[k], place(k)};
  });
  if (peak.point < 0) return false;
  const bool joins_x = system.periodic() || s.boundary == RC_BOUNDARY_PERIODIC_X,
             joins_y = system.periodic() || s.boundary == RC_BOUNDARY_PERIODIC_Y;
  std::vector<std::int64_t> around;
  for (const std::int64_t dy : {-1, 0, 1})
    for (const std::int64_t dx : {-1, 0, 1}) {
      std::int64_t x = peak.point % s.nx + dx, y = peak.point / s.nx + dy;
      if (joins_x) x = (x + s.nx) % s.nx;
      if (joins_y) y = (y + s.ny) % s.ny;
      const std::int64_t point = y * s.nx + x;
      if (x >= 0 && x < s.nx && y >= 0 && y < s.ny && point != peak.point) around.push_back(point);
    }
  if (around.empty()) return true;
  const auto [least, most] = std::ranges::minmax(around);
  const Count loaded =
      surface.points().combined_over<Count>(touching, [&, least = least, most = most](Count& part, std::size_t k) {
        const std::int64_t point = place(k);
        if (point >= least && point <= most && answer.p()[k] > 0 && std::ranges::count(around, point) > 0) ++part.n;
      });
  return loaded.n == 0;
}

std::vector<std::string> doubts(const System& system, double mean_pressure, std::int64_t contacts, double compression,
                                double tilt) {
  const rc_system& s = system.given;
  std::vector<std::string> remarks;
  if (mean_pressure > most_mean_pressure * s.modulus)
    remarks.push_back(text("mean pressure %.3g E*: check the units", mean_pressure / s.modulus));
  if (s.hardness > 0 && s.hardness < least_hardness * s.modulus)
    remarks.push_back(text("hardness %.3g E*: check the units", s.hardness / s.modulus));
  if (compression > std::max(s.hx * static_cast<double>(s.nx), s.hy * static_cast<double>(s.ny)))
    remarks.emplace_back("approach above the grid's side: check the units");
  if (contacts == 1 && system.points() > 1) remarks.emplace_back("one point in contact: check the pitch, or the map for a spike");
  if (tilt > most_tilt) remarks.push_back(text("a plane is %.0f %% of the heights' variance: level them", 100 * tilt));
  return remarks;
}

}  // namespace rc
