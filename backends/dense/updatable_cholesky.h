// Cholesky factor A = L L^T of a matrix that gains and loses unknowns.
//
// New unknowns go to the end: a triangular solve for their rows and a factor of their Schur complement, so that appending to
// nothing is the factorization itself. An unknown that leaves turns its column of L into a positive rank-one term of the
// trailing block, which plane rotations absorb (Golub & Van Loan, Matrix Computations, 6.5): no subtraction, always stable.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "symmetric_matrix.h"

namespace rc_dense {

class UpdatableCholesky {
 public:
  struct BadPivot {
    std::int64_t unknown;
    double value;
  };

  std::int64_t size() const { return size_; }
  std::int64_t capacity() const { return capacity_; }
  static double bytes(double capacity) { return sizeof(double) * capacity * capacity; }

  void clear();
  // Room for this many unknowns without moving what is there.
  void reserve(std::int64_t capacity);
  // Appends unknowns to a factor with room for them; `source` is asked for entries (row, column) of A, row >= column, of new
  // rows only. On a pivot that is not positive the factor is as before.
  [[nodiscard]] std::optional<BadPivot> append(std::int64_t count, const ColumnSource& source);
  // Forgets the unknowns from `size` on.
  void truncate(std::int64_t size) { size_ = size; }
  // Takes out these unknowns, ascending; those after them move up.
  void remove(std::span<const std::int64_t> removed);
  // b = A^-1 b
  void solve(double* b) const;

 private:
  double* column(std::int64_t j) const { return numbers_.get() + j * capacity_; }

  std::int64_t size_ = 0, capacity_ = 0;
  std::unique_ptr<double[]> numbers_;  // L by columns of stride capacity_; what is above the diagonal is never touched
};

// Whether taking out the ascending `removed` of n unknowns by rotations costs less than factoring again everything from the
// first of them on, when `added` unknowns follow in either case. Counts decide, not clocks: the choice is reproducible.
bool rotations_pay(std::int64_t n, std::span<const std::int64_t> removed, std::int64_t added);

}  // namespace rc_dense
