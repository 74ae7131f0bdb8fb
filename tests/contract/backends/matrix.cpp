#include "matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <tuple>

#include "kernel/kernel.h"
#include "kernel/semi_periodic.h"
#include "stand_in_host.h"
#include "support/unit_system.h"

namespace contract {

namespace {

// Real-space coefficients from the eigenvalues, term by term.
Vector periodic_table(const rc_system& s, double zero_mode) {
  const std::int64_t half_x = s.nx / 2 + 1, half_y = s.ny / 2 + 1;
  Vector symbol(static_cast<std::size_t>(half_x * half_y));
  rc::kernel::symbol(*rc::kernel::find(kernel_name(s.boundary)), s.hx, s.hy, s.nx, s.ny, symbol.data());
  symbol[0] = zero_mode;
  const auto cosines = [](std::int64_t n) {
    std::vector<long double> table;
    for (std::int64_t k = 0; k < n; ++k)
      table.push_back(std::cos(2 * std::numbers::pi_v<long double> * static_cast<long double>(k) / static_cast<long double>(n)));
    return table;
  };
  const std::vector<long double> cos_x = cosines(s.nx), cos_y = cosines(s.ny);
  const auto at = [](auto& table, std::int64_t i) { return table[static_cast<std::size_t>(i)]; };
  Vector out;
  for (std::int64_t y = 0; y < s.ny; ++y)
    for (std::int64_t x = 0; x < s.nx; ++x) {
      long double sum = 0;
      for (std::int64_t ky = 0; ky < s.ny; ++ky)
        for (std::int64_t kx = 0; kx < s.nx; ++kx)
          sum += at(symbol, std::min(ky, s.ny - ky) * half_x + std::min(kx, s.nx - kx)) * at(cos_x, kx * x % s.nx) *
                 at(cos_y, ky * y % s.ny);
      out.push_back(static_cast<double>(sum / static_cast<long double>(s.nx * s.ny)));
    }
  return out;
}

Vector free_table(const rc_system& s) {
  Vector out(static_cast<std::size_t>(s.nx * s.ny));
  if (s.boundary != RC_BOUNDARY_FREE) {
    rc::kernel::semi_periodic_coefficients(*rc::kernel::find("love"), s, {0, 0, s.nx, s.ny}, out.data());
    return out;
  }
  rc::kernel::coefficients(*rc::kernel::find(kernel_name(s.boundary)), s.hx, s.hy, s.nx, s.ny, out.data());
  return out;
}

}  // namespace

rc_system halfspace(std::int32_t boundary, std::int64_t nx, std::int64_t ny, double hx, double hy) {
  rc_system system = support::unit_system();
  system.boundary = boundary;
  system.nx = nx;
  system.ny = ny;
  system.hx = hx;
  system.hy = hy;
  return system;
}

Matrix::Matrix(const rc_system& s, double zero_mode) : n_(s.nx * s.ny) {
  const Vector table = s.boundary == RC_BOUNDARY_PERIODIC ? periodic_table(s, zero_mode) : free_table(s);
  entries_.reserve(static_cast<std::size_t>(n_ * n_));
  for (std::int64_t i = 0; i < n_; ++i)
    for (std::int64_t j = 0; j < n_; ++j)
      entries_.push_back(table[static_cast<std::size_t>(std::abs(i / s.nx - j / s.nx) * s.nx + std::abs(i % s.nx - j % s.nx))]);
  for (std::int64_t i = 0; i < n_; ++i)
    norm_ = std::max(norm_, std::accumulate(row(i), row(i) + n_, 0.0, [](double sum, double h) { return sum + std::abs(h); }));
}

const Matrix& matrix_of(const rc_system& s, double zero_mode) {
  static std::map<std::tuple<std::int32_t, std::int64_t, std::int64_t, double, double, double>, Matrix> made;
  const auto [at, is_new] = made.try_emplace({s.boundary, s.nx, s.ny, s.hx, s.hy, zero_mode}, s, zero_mode);
  return at->second;
}

Vector Matrix::product(const Index& rows, const Index& columns, const Vector& x) const {
  Vector y;
  for (std::int64_t i : rows) {
    long double sum = 0;
    for (std::size_t j = 0; j < columns.size(); ++j) sum += static_cast<long double>(row(i)[columns[j]]) * x[j];
    y.push_back(static_cast<double>(sum));
  }
  return y;
}

Vector random_vector(std::size_t n, unsigned seed) {
  std::mt19937 generator(seed);
  Vector x(n);
  for (double& value : x) value = static_cast<double>(generator()) / 2147483648.0 - 1.0;
  return x;
}

double largest_difference(const Vector& a, const Vector& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (!(difference <= largest)) largest = difference;  // a NaN stays
  }
  return largest;
}

}  // namespace contract
