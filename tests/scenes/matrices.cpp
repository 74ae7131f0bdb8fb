#include "matrices.h"

#include <cmath>
#include <numeric>

namespace scenes {

namespace {

// Off-diagonals that are not positive, half of them 0, and rows that are a little more than balanced.
Field m_matrix(std::size_t n, double shift, double scale, Random& random) {
  Field matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      matrix[i * n + j] = matrix[j * n + i] = random.chance(0.5) ? 0 : -scale * random.uniform();
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = matrix.begin() + static_cast<std::ptrdiff_t>(i * n);
    const double others = -std::accumulate(row, row + static_cast<std::ptrdiff_t>(n), 0.0);
    matrix[i * n + i] = others + scale * (shift + random.uniform());
  }
  return matrix;
}

}  // namespace

Field random_matrix(std::size_t n, Random& random) {
  const std::int64_t kind = random.below(6);
  const double shift = random.decades(-4, 0), scale = random.decades(-3, 3), reach = random.decades(-1, 1);
  if (kind == 4) return m_matrix(n, shift, scale, random);
  const std::size_t m = n + 2;
  Field factor(n * m), matrix(n * n), x(n), y(n);
  for (double& value : factor) value = kind == 0 || kind == 5 ? random.normal() : std::abs(random.normal());
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = random.uniform(0, std::sqrt(static_cast<double>(n)));
    y[i] = random.uniform(0, std::sqrt(static_cast<double>(n)));
  }
  const auto entry = [&](std::size_t i, std::size_t j) {
    const double apart = static_cast<double>(i) - static_cast<double>(j);
    if (kind == 2) return std::exp(-std::abs(apart) / reach) + (i == j ? shift : 0);
    if (kind == 3) return i == j ? 1 + shift : 1 / std::sqrt(1 + std::pow(x[i] - x[j], 2) + std::pow(y[i] - y[j], 2));
    const auto row = [&](std::size_t k) { return factor.begin() + static_cast<std::ptrdiff_t>(k * m); };
    return std::inner_product(row(i), row(i + 1), row(j), 0.0) / static_cast<double>(m) + (i == j ? shift : 0);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) matrix[i * n + j] = matrix[j * n + i] = scale * entry(i, j);
  if (kind == 5) {  // rows and columns of other units
    Field units(n);
    for (double& unit : units) unit = random.decades(-1, 1);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) matrix[i * n + j] *= units[i] * units[j];
  }
  return matrix;
}

}  // namespace scenes
