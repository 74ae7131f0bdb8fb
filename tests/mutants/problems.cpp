#include "problems.h"

#include <algorithm>
#include <cmath>

namespace mutants {

Small::Small(std::int64_t nx, std::int64_t ny) {
  given.nx = nx;
  given.ny = ny;
  given.modulus = 2;
  Numbers numbers(static_cast<std::uint64_t>(nx + 100 * ny));
  for (std::int64_t i = 0; i < nx * ny; ++i) gap.push_back(numbers.uniform());
  const double lowest = *std::min_element(gap.begin(), gap.end());
  for (double& h : gap) h -= lowest;
}

void Small::press(double depth, double off, std::uint64_t seed) {
  Numbers numbers(seed);
  compression = depth;
  answer = {};
  answer.pressures.on.n = static_cast<std::int64_t>(points());
  double lowest = 1e300;
  for (std::size_t i = 0; i < points(); ++i)
    if (mask.empty() || mask[i]) lowest = std::min(lowest, gap[i]);
  if (lowest == 1e300) lowest = 0;
  for (std::size_t i = 0; i < points(); ++i) {
    const bool included = mask.empty() || mask[i] != 0;
    const double u = depth - (gap[i] - lowest), random = numbers.uniform();
    const bool pressed = included && u > 0;
    answer.pressures.p.push_back(pressed ? given.modulus * (u + 0.1 * random) : 0);
    const double w = pressed ? off * depth * (2 * numbers.uniform() - 1) : depth * (0.3 + random) - std::min(u, 0.0);
    answer.product.push_back(u + w);
  }
}

void Small::list(const std::vector<std::int64_t>& listed, double beyond) {
  rc::Deflected part;
  part.beyond = beyond;
  part.pressures.on.n = static_cast<std::int64_t>(listed.size());
  part.pressures.on.index = listed;
  for (const std::int64_t i : listed) {
    part.pressures.p.push_back(answer.pressures.p[static_cast<std::size_t>(i)]);
    part.product.push_back(answer.product[static_cast<std::size_t>(i)]);
  }
  answer = part;
}

void Small::cap(double hardness) {
  given.hardness = hardness;
  for (std::size_t i = 0; i < points(); ++i) {
    double& p = answer.pressures.p[i];
    if (!(p > hardness)) continue;
    answer.product[i] -= 0.5 * (p - hardness) / given.modulus;
    p = hardness;
  }
}

void Small::make_dense(double weakest) {
  const auto n = static_cast<std::int64_t>(points());
  matrix.assign(static_cast<std::size_t>(n * n), 0.0);
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j)
      matrix[static_cast<std::size_t>(i * n + j)] =
          std::pow(0.5, std::abs(static_cast<double>(i - j))) + (i == j ? weakest : 0.0);
  given.op = RC_OPERATOR_DENSE;
  given.dense = matrix.data();
  given.dense_ld = n;
}

}  // namespace mutants
