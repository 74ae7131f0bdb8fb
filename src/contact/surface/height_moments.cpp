#include "contact/surface/height_moments.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "contact/surface/step_surface.h"
#include "core/chunks.h"

namespace rc {

namespace {

// Moments of a number of heights. + joins those of two sets without cancellation.
struct Moments {
  double n = 0, mean = 0, square = 0;  // square: the sum of squared differences to the mean

  Moments operator+(const Moments& b) const {
    if (b.n == 0) return *this;
    const double all = n + b.n, apart = b.mean - mean;
    return {all, mean + apart * (b.n / all), square + b.square + apart * apart * (n / all * b.n)};
  }
};

// The sum of term(0) .. term(n-1).
template <class Term> double sum_of_points(std::int64_t n, const Term& term) {
  constexpr std::int64_t lanes = 8;
  double sum[lanes] = {};
  std::int64_t k = 0;
  for (; k + lanes <= n; k += lanes)
    for (std::int64_t lane = 0; lane < lanes; ++lane) sum[lane] += term(k + lane);
  for (; k < n; ++k) sum[0] += term(k);
  return std::accumulate(sum, sum + lanes, 0.0);
}

}  // namespace

HeightMoments moments_of(const StepSurface& surface) {
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    constexpr std::int64_t together = 512;
    double height[together];
    Moments all;
    for (std::int64_t first = begin; first < begin + count; first += together) {
      std::int64_t n = std::min(together, begin + count - first);
      heights_of({}, surface, static_cast<std::size_t>(first), static_cast<std::size_t>(n), height);
      if (!surface.range().whole) {
        const std::int64_t read = n;
        n = 0;
        for (std::int64_t k = 0; k < read; ++k)
          if (surface.included(static_cast<std::size_t>(first + k))) height[n++] = height[k];
      }
      const double mean =
          sum_of_points(n, [&](std::int64_t k) { return height[k]; }) / static_cast<double>(std::max<std::int64_t>(n, 1));
      all = all + Moments{static_cast<double>(n), mean,
                          sum_of_points(n, [&](std::int64_t k) { return (height[k] - mean) * (height[k] - mean); })};
    }
    return all;
  };
  const SurfacePoints& points = surface.points();
  const Moments all = reduce<Moments>(points.count(), points.team(), body, {}, {}, points.chunks());
  return {all.mean, all.square};
}

}  // namespace rc
