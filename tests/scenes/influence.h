// H of a scene in extended precision, each kernel from its definition, without the library.
#pragma once

#include "scene.h"

namespace scenes {

/** Relative error that products of the library may have: registry.h promises coefficients to that. */
constexpr Real double_product = 1e-12L;
/** Error of the products of backend "split", relative to the largest product of absolute pressures (backends/split/scheme.h). */
constexpr Real split_product = 1e-11L;

/** [nx*ny] deflection at each offset from a cell under unit pressure. Half-spaces only. */
Reals influence_table(const Scene& scene);

/** H: the table of a half-space, or the scene's matrix. */
class Influence {
 public:
  explicit Influence(const Scene& scene);

  std::size_t points() const { return n_; }
  Real operator()(std::size_t i, std::size_t j) const {
    return table_.empty() ? static_cast<Real>((*matrix_)[i * n_ + j])
                          : table_[distance(row_[i], row_[j]) * nx_ + distance(column_[i], column_[j])];
  }
  /** H v. */
  Reals times(const Reals& v) const;
  /** The largest sum of |H| along a row, at most four times as large for more than 1000 points. */
  Real largest_row() const { return largest_row_; }

 private:
  static std::size_t distance(std::size_t a, std::size_t b) { return a > b ? a - b : b - a; }

  std::size_t n_, nx_;
  const Field* matrix_;
  Reals table_;
  std::vector<std::size_t> row_, column_;
  Real largest_row_ = 0;
};

}  // namespace scenes
