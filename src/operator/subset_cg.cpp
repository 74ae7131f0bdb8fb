// H[a,a] x = b by conjugate gradients on the full product, for backends that cannot factor.
#include <algorithm>
#include <cmath>

#include "core/conjugate_gradients.h"
#include "core/error.h"
#include "core/stall.h"
#include "core/sums.h"
#include "operator/operator.h"

namespace rc {

rc_status Operator::subset_by_products(std::span<const std::int64_t> a, const double* b, double* x, double tol) {
  constexpr double attained = 1e-15;    // least relative residual that products in double precision can reach
  constexpr double progress = 0.9;      // the residual falls where it is below this share of the least one before
  constexpr std::size_t patience = 39;  // iterations without such a fall, once the answer is acceptable
  // Before that more: the residual of some H falls only in the last of m iterations, and round-off delays it further.
  constexpr std::size_t for_each_point = 2, most_patience = 1000;
  constexpr double acceptable = 1e-11;  // above this, stopping early is a failure
  const std::size_t m = a.size(), n = static_cast<std::size_t>(trial_.n);
  std::vector<double> spread(n, 0.0), product(n), r(b, b + m), best(m, 0.0);
  const auto multiply = [&](const double* v, std::vector<double>& q) {
    for (std::size_t k = 0; k < m; ++k) spread[static_cast<std::size_t>(a[k])] = v[k];
    const rc_status status = apply(spread.data(), product.data());
    for (std::size_t k = 0; k < m; ++k) q[k] = product[static_cast<std::size_t>(a[k])];
    return status;
  };

  double size_b = 0;
  for (std::size_t k = 0; k < m; ++k) size_b = std::max(size_b, std::abs(b[k]));
  const bool started = std::any_of(x, x + m, [](double value) { return value != 0; });
  if (size_b == 0) {
    std::fill(x, x + m, 0.0);
    return RC_OK;
  }
  const auto size_r = [&] {
    double largest = 0;
    for (const double value : r) largest = std::max(largest, std::abs(value) / size_b);
    return largest;
  };
  if (started) {
    if (const rc_status status = multiply(x, r); status != RC_OK) return status;
    for (std::size_t k = 0; k < m; ++k) r[k] = b[k] - r[k];
    if (!(size_r() < 1)) {  // no better than x = 0
      std::fill(x, x + m, 0.0);
      std::copy(b, b + m, r.begin());
    }
  }

  double least = size_r();
  std::copy(x, x + m, best.begin());
  Stall stalls_late(progress, patience, Stall::Mark::least),
      stalls_early(progress, static_cast<std::int64_t>(std::clamp(for_each_point * m, patience, most_patience)),
                   Stall::Mark::least);
  const auto enough = [&](int, double rr) {
    const double size = size_r();
    if (size < least) {
      least = size;
      std::copy(x, x + m, best.begin());
    }
    const bool late = stalls_late(size), early = stalls_early(size);
    return (least <= acceptable ? late : early) || least <= std::max(tol, attained) || rr == 0;
  };
  const ConjugateGradientsEnd end = conjugate_gradients(
      {x, m}, r, size_b, sum_in_order,
      [&](const std::vector<double>& t, std::vector<double>& q) { return multiply(t.data(), q); }, enough);
  if (end.status != 0) return end.status;
  if (!end.definite() && !(least <= acceptable)) {
    set_message(join("the operator is not positive definite: t'Ht = ", end.curvature, " on a set of ", m, " points").c_str());
    return RC_ERR_NUMERIC;
  }
  std::copy(best.begin(), best.end(), x);
  if (least > std::max(acceptable, tol)) {
    set_message(join("conjugate gradients on ", m, " points stopped at a relative residual of ", least).c_str());
    return RC_STOP_STALLED;
  }
  return RC_OK;
}

}  // namespace rc
