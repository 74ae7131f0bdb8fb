// The periodic kernel: a pressure wave exp(i q.x) deflects the half-space by 2/(E* |q|) times itself (Johnson, Contact Mechanics
// (1985), section 13.2), for every wave of the grid, q = 2 pi (kx/(nx hx), ky/(ny hy)).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/kernels.h"

namespace rc::kernel {

namespace {

struct Matrix {
  Matrix(std::int64_t row_count, std::int64_t column_count)
      : Matrix(row_count, column_count, std::vector<double>(static_cast<std::size_t>(row_count * column_count))) {}
  Matrix(std::int64_t row_count, std::int64_t column_count, std::vector<double> values)
      : rows(row_count), columns(column_count), value(std::move(values)) {}
  double* row(std::int64_t i) { return value.data() + i * columns; }
  const double* row(std::int64_t i) const { return value.data() + i * columns; }

  std::int64_t rows, columns;
  std::vector<double> value;
};

// Summed block by block, which bounds the growth of round-off and keeps the block of b in cache.
Matrix operator*(const Matrix& a, const Matrix& b) {
  constexpr std::int64_t block = 64, unroll = 4;
  Matrix product(a.rows, b.columns);
  std::vector<double> partial(static_cast<std::size_t>(b.columns));
  for (std::int64_t first = 0; first < b.rows; first += block) {
    const std::int64_t last = std::min(first + block, b.rows);
    for (std::int64_t i = 0; i < a.rows; ++i) {
      const double* ai = a.row(i);
      double* sum = partial.data();
      std::fill_n(sum, b.columns, 0.0);
      std::int64_t k = first;
      for (; k + unroll <= last; k += unroll) {
        const double a0 = ai[k], a1 = ai[k + 1], a2 = ai[k + 2], a3 = ai[k + 3];
        const double *b0 = b.row(k), *b1 = b.row(k + 1), *b2 = b.row(k + 2), *b3 = b.row(k + 3);
        for (std::int64_t j = 0; j < b.columns; ++j) sum[j] += (a0 * b0[j] + a1 * b1[j]) + (a2 * b2[j] + a3 * b3[j]);
      }
      for (; k < last; ++k)
        for (std::int64_t j = 0; j < b.columns; ++j) sum[j] += ai[k] * b.row(k)[j];
      double* total = product.row(i);
      for (std::int64_t j = 0; j < b.columns; ++j) total[j] += sum[j];
    }
  }
  return product;
}

// The inverse transform of an even function on n points: cosines(i, k) is the share of wave number k = 0..n/2 at offset i. A wave
// and its conjugate count together, but the mean and, for even n, the highest wave are their own conjugates.
class Cosines {
 public:
  explicit Cosines(std::int64_t n) : n_(n), value_(cosines_of_a_turn(n)) {}
  double operator()(std::int64_t i, std::int64_t k) const {
    const double pair = k == 0 || 2 * k == n_ ? 1 : 2;
    return pair / static_cast<double>(n_) * value_[static_cast<std::size_t>(i * k % n_)];
  }

 private:
  std::int64_t n_;
  std::vector<double> value_;  // of each part of a turn
};

}  // namespace

std::vector<double> cosines_of_a_turn(std::int64_t n) {
  std::vector<double> value;
  for (std::int64_t i = 0; i < n; ++i)
    value.push_back(std::cos(2 * std::numbers::pi * (static_cast<double>(i) / static_cast<double>(n))));
  return value;
}

void symbol(const Kernel&, double hx, double hy, std::int64_t nx, std::int64_t ny, double* out) {
  // Waves in units of the longer side's, so that their squares neither overflow nor vanish.
  const double lx = static_cast<double>(nx) * hx, ly = static_cast<double>(ny) * hy, longer = std::max(lx, ly);
  const double x = longer / lx, y = longer / ly, factor = longer / std::numbers::pi;
  double* value = out;
  for (std::int64_t ky = 0; ky <= ny / 2; ++ky) {
    const double along_y = y * static_cast<double>(ky), square = along_y * along_y;
    for (std::int64_t kx = 0; kx <= nx / 2; ++kx) {
      const double along_x = x * static_cast<double>(kx);
      *value++ = factor / std::sqrt(along_x * along_x + square);
    }
  }
  out[0] = 0;
}

void from_symbol(std::vector<double> symbol, std::int64_t nx, std::int64_t ny, std::int64_t mx, std::int64_t my, double* out) {
  // Offsets beyond half the period repeat the nearer ones.
  const std::int64_t half_x = nx / 2 + 1, half_y = ny / 2 + 1;
  const std::int64_t distinct_x = std::min(mx, half_x), distinct_y = std::min(my, half_y);

  const Matrix eigenvalues{half_y, half_x, std::move(symbol)};
  Matrix to_x(half_x, distinct_x), to_y(distinct_y, half_y);
  const Cosines along_x(nx), along_y(ny);
  for (std::int64_t k = 0; k < half_x; ++k)
    for (std::int64_t i = 0; i < distinct_x; ++i) to_x.row(k)[i] = along_x(i, k);
  for (std::int64_t i = 0; i < distinct_y; ++i)
    for (std::int64_t k = 0; k < half_y; ++k) to_y.row(i)[k] = along_y(i, k);

  const Matrix coefficient = to_y * (eigenvalues * to_x);
  for (std::int64_t iy = 0; iy < my; ++iy)
    for (std::int64_t ix = 0; ix < mx; ++ix) *out++ = coefficient.row(std::min(iy, ny - iy))[std::min(ix, nx - ix)];
}

void periodic_coefficients(const Kernel& kernel, double hx, double hy, std::int64_t nx, std::int64_t ny, std::int64_t mx,
                           std::int64_t my, double* out) {
  std::vector<double> eigenvalues(static_cast<std::size_t>((nx / 2 + 1) * (ny / 2 + 1)));
  symbol(kernel, hx, hy, nx, ny, eigenvalues.data());
  from_symbol(std::move(eigenvalues), nx, ny, mx, my, out);
}

}  // namespace rc::kernel
