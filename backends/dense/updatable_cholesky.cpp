#include "updatable_cholesky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "serial_eigen.h"

namespace rc_dense {

namespace {

using Block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Part = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr Eigen::Index block_size = 96;

// L of a small block in place, column by column. A pivot must exceed what rounding leaves of its diagonal entry in a
// singular matrix.
std::optional<UpdatableCholesky::BadPivot> factor_small(Part A, const Eigen::Ref<const Eigen::VectorXd>& smallest_pivot) {
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    const Eigen::Index below = A.rows() - j - 1;
    const double pivot = A(j, j) - A.row(j).head(j).squaredNorm();
    if (!(pivot > smallest_pivot(j))) return UpdatableCholesky::BadPivot{j, pivot};
    A(j, j) = std::sqrt(pivot);
    A.col(j).tail(below).noalias() -= A.bottomLeftCorner(below, j) * A.row(j).head(j).transpose();
    A.col(j).tail(below) /= A(j, j);
  }
  return std::nullopt;
}

// L in the place of A's lower triangle, by blocks of columns.
std::optional<UpdatableCholesky::BadPivot> factor(Part A, const Eigen::VectorXd& smallest_pivot) {
  const Eigen::Index n = A.rows();
  for (Eigen::Index k = 0; k < n; k += block_size) {
    const Eigen::Index width = std::min(block_size, n - k), below = n - k - width;
    auto diagonal = A.block(k, k, width, width);
    auto panel = A.block(k + width, k, below, width);
    if (auto bad = factor_small(diagonal, smallest_pivot.segment(k, width))) {
      bad->unknown += k;
      return bad;
    }
    if (below == 0) break;
    diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(panel);
    A.bottomRightCorner(below, below).selfadjointView<Eigen::Lower>().rankUpdate(panel, -1.0);
  }
  return std::nullopt;
}

// Copies from[row .. n) without the removed rows.
void copy_kept(const double* from, std::int64_t row, std::int64_t n, std::span<const std::int64_t> removed, double* to) {
  for (const std::int64_t next : removed) {
    to = std::copy(from + row, from + next, to);
    row = next + 1;
  }
  std::copy(from + row, from + n, to);
}

void rotate(double c, double s, std::int64_t n, double* __restrict a, double* __restrict b) {
  for (std::int64_t i = 0; i < n; ++i) {
    const double ai = a[i], bi = b[i];
    a[i] = c * ai + s * bi;
    b[i] = c * bi - s * ai;
  }
}

}  // namespace

void UpdatableCholesky::clear() {
  numbers_.reset();
  size_ = capacity_ = 0;
}

void UpdatableCholesky::reserve(std::int64_t capacity) {
  if (capacity <= capacity_) return;
  if (size_ == 0) clear();
  const auto stride = static_cast<std::size_t>(capacity);
  std::unique_ptr<double[]> numbers(new double[stride * stride]);
  for (std::int64_t j = 0; j < size_; ++j) std::copy(column(j) + j, column(j) + size_, numbers.get() + j * capacity + j);
  numbers_ = std::move(numbers);
  capacity_ = capacity;
}

std::optional<UpdatableCholesky::BadPivot> UpdatableCholesky::append(std::int64_t count, const ColumnSource& source) {
  const std::int64_t n = size_;
  if (count == 0) return std::nullopt;
  for (std::int64_t j = 0; j < n + count; ++j) {
    const std::int64_t row = std::max(n, j);
    source(row, n + count - row, j, column(j) + row);
  }
  Block L(numbers_.get(), n, n, Eigen::OuterStride<>(capacity_));
  Block rows(numbers_.get() + n, count, n, Eigen::OuterStride<>(capacity_));
  Block corner(column(n) + n, count, count, Eigen::OuterStride<>(capacity_));
  const double rounding = static_cast<double>(n + count) * std::numeric_limits<double>::epsilon();
  const Eigen::VectorXd smallest_pivot = rounding * corner.diagonal();

  if (count <= 4) {  // few rows solve faster one by one as contiguous vectors
    Eigen::VectorXd row(n);
    for (Eigen::Index i = 0; i < count; ++i) {
      row = rows.row(i);
      L.triangularView<Eigen::Lower>().solveInPlace(row);
      rows.row(i) = row;
    }
  } else {
    L.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rows);
  }
  if (n > 0) corner.selfadjointView<Eigen::Lower>().rankUpdate(rows, -1.0);
  if (auto bad = factor(corner, smallest_pivot)) {
    bad->unknown += n;
    return bad;
  }
  size_ = n + count;
  return std::nullopt;
}

void UpdatableCholesky::remove(std::span<const std::int64_t> removed) {
  if (removed.empty()) return;
  const std::int64_t n = size_, first = removed.front(), kept = n - static_cast<std::int64_t>(removed.size());
  // Column a: the rank-one term left by removed[a], rows first .. kept of the new numbering.
  Eigen::MatrixXd terms(kept - first, static_cast<Eigen::Index>(removed.size()));

  Eigen::Index active = 0;
  for (std::int64_t j = 0; j < n; ++j) {
    const std::int64_t row = j - active;  // of the new numbering
    const auto still_in = removed.subspan(static_cast<std::size_t>(active));
    if (!still_in.empty() && still_in.front() == j) {
      copy_kept(column(j), j + 1, n, still_in.subspan(1), terms.col(active).data() + (row - first));
      ++active;
      continue;
    }
    double* l = column(row) + row;
    copy_kept(column(j), j, n, still_in, l);
    for (Eigen::Index a = 0; a < active; ++a) {
      double* term = terms.col(a).data() + (row - first);
      const double diagonal = std::hypot(l[0], term[0]);
      const double c = l[0] / diagonal, s = term[0] / diagonal;
      l[0] = diagonal;
      rotate(c, s, kept - row - 1, l + 1, term + 1);
    }
  }
  size_ = kept;
}

void UpdatableCholesky::solve(double* b) const {
  const Block L(numbers_.get(), size_, size_, Eigen::OuterStride<>(capacity_));
  Eigen::Map<Eigen::VectorXd> x(b, size_);
  L.triangularView<Eigen::Lower>().solveInPlace(x);
  L.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
}

bool rotations_pay(std::int64_t n, std::span<const std::int64_t> removed, std::int64_t added) {
  // Time of a rotation's operation in units of that of a blocked factorization, measured near the break-even for
  // n = 500 .. 4000: 1 with two numbers per vector register, 2 with eight.
  constexpr double rotation_weight = 1.5;
  const auto cube = [](double k) { return k * k * k / 3.0; };
  double rotations = 0.0;
  for (const std::int64_t k : removed) {
    const double trailing = static_cast<double>(n - k);
    rotations += 3.0 * trailing * trailing;
  }
  const double kept = static_cast<double>(n) - static_cast<double>(removed.size());
  const double grown = kept + static_cast<double>(added);
  const double append_to_all = cube(grown) - cube(kept);
  const double append_to_leading = cube(grown) - cube(static_cast<double>(removed.front()));
  return rotation_weight * rotations + append_to_all < append_to_leading;
}

}  // namespace rc_dense
