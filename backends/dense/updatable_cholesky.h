// Cholesky factor A = L L^T of a matrix that gains and loses unknowns.
//
// New unknowns are appended: their rows of L are solved for and their Schur complement is factored. Appending to an empty factor
// is the factorization itself. When an unknown leaves, its column of L becomes a positive rank-one term of the trailing block,
// which plane rotations absorb (Golub & Van Loan, Matrix Computations, 6.5). That subtracts nothing and is always stable.
//
// L is kept in panels of rows, each as long as its last row. That takes half a square, and a growing factor moves no panel. Where
// it rests, a small one is kept as a triangle alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/symmetric_matrix.h"

namespace rc_dense {

using rc_common::ColumnSource;

class UpdatableCholesky {
 public:
  struct BadPivot {
    std::int64_t unknown;
    double value;
  };

  std::int64_t size() const { return size_; }
  // Bytes of the panels for this many unknowns: n^2/2 numbers and half a panel more.
  static double bytes(std::int64_t unknowns);

  void clear() { truncate(0); }
  // Appends unknowns; `source` is asked for entries (row, column) of A, row >= column, of new rows only. On a pivot that is not
  // positive the factor is as before.
  [[nodiscard]] std::optional<BadPivot> append(std::int64_t count, const ColumnSource& source);
  // Forgets the unknowns from `size` on.
  void truncate(std::int64_t size);
  // Removes these unknowns, which are ascending; those after them move up.
  void remove(std::span<const std::int64_t> removed);
  // b = A^-1 b
  void solve(double* b) const;
  // Until unknowns are next appended, removed or forgotten no solve may follow.
  void rest();

 private:
  static constexpr std::int64_t panel_rows = 128;

  // Column j of panel i.
  double* at(std::int64_t i, std::int64_t j) const { return panels_[static_cast<std::size_t>(i)].get() + j * panel_rows; }
  // The entry (row, column).
  double* entry(std::int64_t row, std::int64_t column) const { return at(row / panel_rows, column) + row % panel_rows; }
  template <class Visit> void for_column(std::int64_t column, std::int64_t first, std::int64_t last, const Visit&) const;

  void wake();
  void reserve(std::int64_t unknowns);
  void forward(double* x, std::int64_t n) const;
  std::optional<BadPivot> append_row(const ColumnSource&, double rounding);
  std::optional<BadPivot> append_to_panel(std::int64_t last, const ColumnSource&, double rounding);
  void remove_batch(std::span<const std::int64_t> removed);

  std::int64_t size_ = 0;
  std::vector<std::unique_ptr<double[]>> panels_;  // by columns of stride panel_rows; what is above the diagonal is never used
  std::vector<double> triangle_;                   // at rest: the columns of L from the diagonal on
};

// Whether removing the ascending `removed` of n unknowns by rotations costs less than factoring again everything from the first
// of them on, if `added` unknowns are appended in either case. It counts operations, so the choice is reproducible.
bool rotations_pay(std::int64_t n, std::span<const std::int64_t> removed, std::int64_t added);

}  // namespace rc_dense
