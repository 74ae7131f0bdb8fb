#include "common/symmetric_matrix.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/serial_eigen.h"

namespace rc_common {

namespace {

using Tile = Eigen::Map<const Eigen::MatrixXd>;
using VectorIn = Eigen::Map<const Eigen::VectorXd>;
using VectorOut = Eigen::Map<Eigen::VectorXd>;

// The part of x that one tile multiplies, from its first nonzero to its last.
struct Support {
  std::int64_t first, count;
};

Support support(const double* x, std::int64_t n) {
  const auto nonzero = [](double value) { return value != 0.0; };
  const double* first = std::find_if(x, x + n, nonzero);
  const double* last = x + n;
  while (last > first && last[-1] == 0.0) --last;
  return {first - x, last - first};
}

}  // namespace

SymmetricMatrix::SymmetricMatrix(std::int64_t n, const ColumnSource& source)
    : n_(n),
      tiles_((n + tile_size - 1) / tile_size),
      numbers_(new double[static_cast<std::size_t>(tile_offset(tiles_ - 1, tiles_ - 1) +
                                                   tile_rows(tiles_ - 1) * tile_rows(tiles_ - 1))]) {
  for (std::int64_t i = 0; i < tiles_; ++i)
    for (std::int64_t j = 0; j <= i; ++j) {
      const std::int64_t rows = tile_rows(i);
      double* tile = numbers_.get() + tile_offset(i, j);
      for (std::int64_t k = 0; k < tile_rows(j); ++k) source(i * tile_size, rows, j * tile_size + k, tile + k * rows);
    }
}

double SymmetricMatrix::bytes(double n) {
  const double full = std::floor(n / tile_size), rest = n - full * tile_size;
  return sizeof(double) * (0.5 * tile_size * tile_size * full * (full + 1.0) + rest * n);
}

std::int64_t SymmetricMatrix::tile_rows(std::int64_t tile) const { return std::min(tile_size, n_ - tile * tile_size); }

// Tiles lie row by row; only those of the last row have fewer than tile_size rows.
std::int64_t SymmetricMatrix::tile_offset(std::int64_t row_tile, std::int64_t column_tile) const {
  return tile_size * (tile_size * (row_tile * (row_tile + 1) / 2) + tile_rows(row_tile) * column_tile);
}

void SymmetricMatrix::multiply(const double* x, double* y) const {
  std::vector<Support> supports(static_cast<std::size_t>(tiles_));
  for (std::int64_t i = 0; i < tiles_; ++i) supports[static_cast<std::size_t>(i)] = support(x + i * tile_size, tile_rows(i));

  std::fill_n(y, n_, 0.0);
  for (std::int64_t i = 0; i < tiles_; ++i) {
    const Support in_rows = supports[static_cast<std::size_t>(i)];
    const VectorIn x_i(x + i * tile_size, tile_rows(i));
    VectorOut y_i(y + i * tile_size, tile_rows(i));
    for (std::int64_t j = 0; j <= i; ++j) {
      const Support in_columns = supports[static_cast<std::size_t>(j)];
      const Tile tile(numbers_.get() + tile_offset(i, j), tile_rows(i), tile_rows(j));
      const VectorIn x_j(x + j * tile_size, tile_rows(j));
      VectorOut y_j(y + j * tile_size, tile_rows(j));
      if (in_columns.count > 0)
        y_i.noalias() += tile.middleCols(in_columns.first, in_columns.count) * x_j.segment(in_columns.first, in_columns.count);
      if (i != j && in_rows.count > 0)
        y_j.noalias() += tile.middleRows(in_rows.first, in_rows.count).transpose() * x_i.segment(in_rows.first, in_rows.count);
    }
  }
}

}  // namespace rc_common
