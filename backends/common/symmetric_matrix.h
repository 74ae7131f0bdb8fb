// A symmetric matrix. The lower triangle is stored in square tiles, so that a product reads every stored number from memory once,
// for both triangles.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace rc_common {

// Writes the entries (first_row + k, column), 0 <= k < rows, to out[k].
using ColumnSource = std::function<void(std::int64_t first_row, std::int64_t rows, std::int64_t column, double* out)>;

class SymmetricMatrix {
 public:
  SymmetricMatrix(std::int64_t n, const ColumnSource&);

  // Stored bytes: n^2/2 numbers and half a row of tiles more, since tiles on the diagonal are full.
  static double bytes(double n);

  // y = A x
  void multiply(const double* x, double* y) const;

 private:
  static constexpr std::int64_t tile_size = 256;  // 512 KiB: stays in the second-level cache until its second use

  std::int64_t tile_rows(std::int64_t tile) const;
  std::int64_t tile_offset(std::int64_t row_tile, std::int64_t column_tile) const;

  std::int64_t n_, tiles_;
  std::unique_ptr<double[]> numbers_;
};

}  // namespace rc_common
