#include "contact/proof/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rc {

namespace {

struct Terms {
  double largest_product = 0, largest_gap = 0, sum_of_gaps = 0;

  friend Terms operator+(const Terms& a, const Terms& b) {
    return {std::max(a.largest_product, b.largest_product), std::max(a.largest_gap, b.largest_gap),
            a.sum_of_gaps + b.sum_of_gaps};
  }
};

constexpr double largest_double = std::numeric_limits<double>::max();

// By pieces of rows, whose borders do not depend on how many processes share them.
double sum_by_pieces(const StepSurface& surface, double compression, const Deflected& answer) {
  const auto add = [&](Terms& part, std::size_t k) {
    const std::size_t i = answer.point(k);
    if (surface.included(i)) part.sum_of_gaps += answer.product[k] - (compression - surface.height(i));
  };
  const auto itself = [](std::size_t k) { return k; };
  return surface.points().sum_over<Terms>(answer.size(), itself, add).sum_of_gaps;
}

}  // namespace

void mark_near(const StepSurface& surface, const TrialSet& on, std::span<const double> product, double compression, double limit,
               std::int64_t begin, std::int64_t count, Marks& marks) {
  constexpr std::size_t lanes = 4;
  double gap[Marks::together];
  const auto end = static_cast<std::size_t>(begin + count);
  for (auto first = static_cast<std::size_t>(begin); first < end; first += Marks::together) {
    const std::size_t n = std::min(Marks::together, end - first);
    heights_of(on, surface, first, n, gap);
    for (std::size_t k = 0; k < n; ++k) gap[k] = product[first + k] - (compression - gap[k]);
    const auto apart = [&](std::size_t k) { return (gap[k] > limit) & (gap[k] <= largest_double); };
    double open[lanes] = {};  // how many, counted first: few points are near
    for (std::size_t k = 0; k + lanes <= n; k += lanes)
      for (std::size_t lane = 0; lane < lanes; ++lane) open[lane] += apart(k + lane) ? 1.0 : 0.0;
    const bool none = open[0] + open[1] + open[2] + open[3] == static_cast<double>(n);
    std::uint64_t marked = 0;
    for (std::size_t k = 0; !none && k < n; ++k) marked |= static_cast<std::uint64_t>(!apart(k)) << k;
    marks.set(first, marked);
  }
}

Survey survey(const StepSurface& surface, double compression, const Deflected& answer) {
  const auto n = static_cast<std::int64_t>(answer.size());
  Marks touching(n);
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    constexpr std::size_t lanes = 8;
    double product_of[lanes] = {}, gap_of[lanes] = {};  // largest
    double sum[lanes] = {};                             // of gaps
    double gap[Marks::together], flag[Marks::together];
    const auto end = static_cast<std::size_t>(begin + count);
    for (auto first = static_cast<std::size_t>(begin); first < end; first += Marks::together) {
      const std::size_t n_here = std::min(Marks::together, end - first);
      const double *const product = answer.product.data() + first, *const p = answer.p().data() + first;
      heights_of(answer.on(), surface, first, n_here, gap);
      for (std::size_t k = 0; k < n_here; ++k) gap[k] = product[k] - (compression - gap[k]);
      // No branch for each value: it would be predicted wrongly.
      const auto touches = [&](std::size_t k) { return (p[k] != 0) | !((gap[k] >= 0) & (gap[k] <= largest_double)); };
      for (std::size_t k = 0; k < n_here; ++k) flag[k] = touches(k) ? 1.0 : 0.0;
      std::uint64_t marked = 0;
      std::size_t k = 0;
      for (; k + lanes <= n_here; k += lanes) {
        const double any =
            ((flag[k] + flag[k + 1]) + (flag[k + 2] + flag[k + 3])) + ((flag[k + 4] + flag[k + 5]) + (flag[k + 6] + flag[k + 7]));
        for (std::size_t lane = 0; any > 0 && lane < lanes; ++lane)
          marked |= static_cast<std::uint64_t>(flag[k + lane] > 0) << (k + lane);
      }
      for (; k < n_here; ++k) marked |= static_cast<std::uint64_t>(touches(k)) << k;
      touching.set(first, marked);
      if (!surface.range().whole)
        for (k = 0; k < n_here; ++k)
          if (!surface.included(answer.point(first + k))) gap[k] = 0;
      const auto larger = [](double& largest, double value) { largest = largest < std::abs(value) ? std::abs(value) : largest; };
      for (k = 0; k + lanes <= n_here; k += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          larger(product_of[lane], product[k + lane]);
          larger(gap_of[lane], gap[k + lane]);
          sum[lane] += gap[k + lane];
        }
      for (; k < n_here; ++k) {
        larger(product_of[0], product[k]);
        larger(gap_of[0], gap[k]);
        sum[0] += gap[k];
      }
    }
    return Terms{*std::max_element(product_of, product_of + lanes), *std::max_element(gap_of, gap_of + lanes),
                 std::accumulate(sum, sum + lanes, 0.0)};
  };
  const Terms mine = reduce<Terms>(n, surface.points().team(), body), all = surface.points().rows().united(mine);
  return {touching.list(), all.largest_product, all.largest_gap,
          surface.points().rows().shared() ? sum_by_pieces(surface, compression, answer) : mine.sum_of_gaps};
}

}  // namespace rc
