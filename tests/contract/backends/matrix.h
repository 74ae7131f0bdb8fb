// H as a full matrix: the reference for every backend's products.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <vector>

namespace contract {

using Vector = std::vector<double>;
using Index = std::vector<std::int64_t>;

rc_system halfspace(std::int32_t boundary, std::int64_t nx, std::int64_t ny, double hx, double hy);

// All n x n entries, n = nx*ny; zero_mode: as in rc_domain.
class Matrix {
 public:
  explicit Matrix(const rc_system& system, double zero_mode = 0.0);

  std::int64_t size() const { return n_; }
  const double* row(std::int64_t i) const { return entries_.data() + i * n_; }
  // H[rows, columns] x.
  Vector product(const Index& rows, const Index& columns, const Vector& x) const;
  // Largest sum of |entries| in a row, by which errors are measured.
  double norm() const { return norm_; }

 private:
  std::int64_t n_;
  Vector entries_;
  double norm_ = 0;
};

// The matrix of a system. It is kept for other backends and cases that ask for it again.
const Matrix& matrix_of(const rc_system& system, double zero_mode);

Vector random_vector(std::size_t n, unsigned seed);
double largest_difference(const Vector& a, const Vector& b);

}  // namespace contract
