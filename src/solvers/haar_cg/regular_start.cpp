#include "solvers/haar_cg/regular_start.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/sums.h"

namespace rc {

namespace {

constexpr int most_waves = 3;
constexpr double dot_rounding = 1e-10;  // of a vector's size: what is smaller is 0

double dot_of(const Vector& a, const Vector& b) {
  return sum_of(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

void remove_mean(Vector& v) {
  const double mean = sum_of(v.size(), [&](std::size_t i) { return v[i]; }) / static_cast<double>(v.size());
  for (double& value : v) value -= mean;
}

// A periodic operator on nx x ny values with another eigenvalue for nearly every wave, at the cost of a pass: sums of neighbours.
void sum_neighbours(std::int64_t nx, std::int64_t ny, const Vector& v, Vector& out) {
  constexpr double along_y = 0.7320508;
  const auto at = [&](std::int64_t x, std::int64_t y) { return v[static_cast<std::size_t>(y * nx + x)]; };
  for (std::int64_t y = 0; y < ny; ++y)
    for (std::int64_t x = 0; x < nx; ++x)
      out[static_cast<std::size_t>(y * nx + x)] = at(x > 0 ? x - 1 : nx - 1, y) + at(x + 1 < nx ? x + 1 : 0, y) +
                                                  along_y * (at(x, y > 0 ? y - 1 : ny - 1) + at(x, y + 1 < ny ? y + 1 : 0));
}

// Whether these periodic values, whose mean is 0, are a sum of few waves: products with the operator above then span a space of
// as few dimensions, which Lanczos' method finds.
bool few_waves(std::int64_t nx, std::int64_t ny, Vector v) {
  Vector before(v.size(), 0.0), next(v.size());
  double size = std::sqrt(dot_of(v, v)), link = 0;
  if (!(size > 0)) return true;
  for (double& value : v) value /= size;
  for (int k = 0; k < most_waves; ++k) {
    sum_neighbours(nx, ny, v, next);
    const double own = dot_of(v, next);
    for (std::size_t i = 0; i < v.size(); ++i) next[i] -= own * v[i] + link * before[i];
    link = std::sqrt(dot_of(next, next));
    if (link <= dot_rounding) return true;
    for (std::size_t i = 0; i < v.size(); ++i) {
      before[i] = v[i];
      v[i] = next[i] / link;
    }
  }
  return false;
}

// The surface pressed flat: p such that H p follows it but for a constant, by conjugate gradients among vectors whose mean is 0.
bool press_flat(const Problem& problem, const Vector& height, std::span<double> p) {
  const auto n = static_cast<double>(p.size());
  Vector found(p.size(), problem.load() / n), left = height, t = left, q(p.size());
  const double first = dot_of(left, left);
  for (int k = 0; k < most_waves && dot_of(left, left) > dot_rounding * dot_rounding * first; ++k) {
    problem.apply(t, q);
    remove_mean(q);
    const double curvature = dot_of(t, q), before = dot_of(left, left);
    if (!(curvature > 0)) return false;
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i] += before / curvature * t[i];
      left[i] -= before / curvature * q[i];
    }
    const double beta = dot_of(left, left) / before;
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = left[i] + beta * t[i];
  }
  const auto [least, most] = std::minmax_element(found.begin(), found.end());
  if (*least < 0 || *most > problem.cap()) return false;
  std::copy(found.begin(), found.end(), p.begin());
  return true;
}

// The compenetration of the upper points, where there are only two heights.
std::optional<double> upper_of_two(const Problem& problem, std::int64_t n) {
  const double first = problem.compenetration(0);
  std::optional<double> second;
  for (std::int64_t i = 1; i < n; ++i) {
    const double value = problem.compenetration(i);
    if (value == first || value == second) continue;
    if (second) return std::nullopt;
    second = value;
  }
  return std::max(first, second.value_or(first));
}

// The upper points alone, with equal pressures: in approach control those of least energy.
bool press_upper(const Problem& problem, double upper, std::span<double> p) {
  Vector found(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) found[i] = problem.compenetration(static_cast<std::int64_t>(i)) == upper ? 1.0 : 0.0;
  double size = problem.load() / dot_of(found, found);
  if (!problem.load_control()) {
    Vector product(p.size());
    problem.apply(found, product);
    const double curvature = dot_of(found, product);
    if (!(curvature > 0 && upper > 0)) return false;
    size = upper * dot_of(found, found) / curvature;
  }
  if (size > problem.cap()) return false;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = size * found[i];
  return true;
}

}  // namespace

bool start_regular(const Problem& problem, std::span<double> p) {
  const auto n = static_cast<std::int64_t>(p.size());
  const rc_grid& grid = *problem.grid();
  const auto heights = [&](std::int64_t count) {
    Vector height(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) height[static_cast<std::size_t>(i)] = problem.compenetration(i);
    remove_mean(height);
    return height;
  };
  if (problem.load_control() && grid.boundary == RC_BOUNDARY_PERIODIC && grid.nx * grid.ny == n &&
      few_waves(grid.nx, 1, heights(grid.nx))) {  // one row tells most others
    const Vector height = heights(n);
    if (few_waves(grid.nx, grid.ny, height) && press_flat(problem, height, p)) return true;
  }
  const std::optional<double> upper = upper_of_two(problem, n);
  return upper && press_upper(problem, *upper, p);
}

}  // namespace rc
