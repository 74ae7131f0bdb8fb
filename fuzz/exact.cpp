#include "exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuzz {

namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

// x of H[set,set] x = u[set]; nothing where the matrix is singular to rounding.
std::optional<std::vector<Real>> solve(const std::vector<Real>& h, const std::vector<Real>& u,
                                       const std::vector<std::size_t>& set) {
  const std::size_t n = u.size(), m = set.size();
  std::vector<Real> factor(m * m), x(m);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = h[set[i] * n + set[j]];
      for (std::size_t k = 0; k < j; ++k) sum -= factor[i * m + k] * factor[j * m + k];
      if (i == j) {
        if (!(sum > 1e3L * epsilon * static_cast<Real>(m) * h[set[i] * n + set[i]])) return {};
        factor[i * m + i] = std::sqrt(sum);
      } else {
        factor[i * m + j] = sum / factor[j * m + j];
      }
    }
  for (std::size_t i = 0; i < m; ++i) {
    Real sum = u[set[i]];
    for (std::size_t k = 0; k < i; ++k) sum -= factor[i * m + k] * x[k];
    x[i] = sum / factor[i * m + i];
  }
  for (std::size_t i = m; i-- > 0;) {
    Real sum = x[i];
    for (std::size_t k = i + 1; k < m; ++k) sum -= factor[k * m + i] * x[k];
    x[i] = sum / factor[i * m + i];
  }
  return x;
}

}  // namespace

std::optional<std::vector<Real>> exact_pressures(const std::vector<Real>& h, const std::vector<Real>& u,
                                                 const std::vector<bool>& open, Real cap) {
  enum class At : char { zero, free, most };
  const std::size_t n = u.size();
  std::vector<At> at(n, At::zero);
  for (std::size_t i = 0; i < n; ++i)
    if (open[i] && u[i] > 0) at[i] = At::free;
  std::size_t fewest = n + 1;
  int blocks_left = 8;
  for (int pass = 0; pass < 400; ++pass) {
    std::vector<std::size_t> set, wrong;
    std::vector<Real> p(n), right(u);
    for (std::size_t i = 0; i < n; ++i) {
      if (at[i] == At::free) set.push_back(i);
      if (at[i] != At::most) continue;
      p[i] = cap;
      for (std::size_t j = 0; j < n; ++j) right[j] -= h[j * n + i] * cap;
    }
    const auto x = solve(h, right, set);
    if (!x) return {};
    Real largest = 0;
    for (std::size_t k = 0; k < set.size(); ++k) {
      p[set[k]] = (*x)[k];
      largest = std::max(largest, std::abs((*x)[k]));
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (at[i] == At::free) {
        if (p[i] < -1e3L * epsilon * largest || p[i] > cap + 1e3L * epsilon * largest) wrong.push_back(i);
        continue;
      }
      if (!open[i]) continue;
      Real w = -u[i], size = std::abs(u[i]);
      for (std::size_t j = 0; j < n; ++j) {
        w += h[i * n + j] * p[j];
        size += std::abs(h[i * n + j] * p[j]);
      }
      if ((at[i] == At::zero ? -w : w) > 1e3L * epsilon * size) wrong.push_back(i);
    }
    if (wrong.empty()) {
      for (Real& value : p) value = std::min(std::max<Real>(value, 0), cap);
      return p;
    }
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      blocks_left = 8;
    } else {
      --blocks_left;
    }
    if (blocks_left <= 0) wrong = {wrong.back()};
    for (const std::size_t i : wrong) at[i] = at[i] != At::free ? At::free : p[i] > 0 ? At::most : At::zero;
  }
  return {};
}

}  // namespace fuzz
