#include "updatable_cholesky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/serial_eigen.h"

namespace rc_dense {

namespace {

using Panel = Eigen::Map<Eigen::MatrixXd>;
using Part = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr Eigen::Index block_size = 32;

// Rows fewer than this are appended one by one, as contiguous vectors.
constexpr std::int64_t few_rows = 5;

constexpr std::int64_t most_packed = 1024;  // unknowns of a factor that is small

// Factors a small block in place, column by column. A pivot must be larger than what rounding leaves of it in a singular
// matrix.
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

// Replaces A's lower triangle by L, one block of columns after the other.
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

void rotate(double c, double s, std::int64_t n, double* __restrict a, double* __restrict b) {
  for (std::int64_t i = 0; i < n; ++i) {
    const double ai = a[i], bi = b[i];
    a[i] = c * ai + s * bi;
    b[i] = c * bi - s * ai;
  }
}

}  // namespace

double UpdatableCholesky::bytes(std::int64_t unknowns) {
  constexpr auto width = static_cast<double>(panel_rows);
  const double panels = std::ceil(static_cast<double>(unknowns) / width);
  return sizeof(double) * width * width * panels * (panels + 1.0) / 2.0;
}

void UpdatableCholesky::reserve(std::int64_t unknowns) {
  const std::int64_t wanted = (unknowns + panel_rows - 1) / panel_rows;
  for (auto i = static_cast<std::int64_t>(panels_.size()); i < wanted; ++i) {
    std::unique_ptr<double[]> panel(new double[static_cast<std::size_t>(panel_rows * panel_rows * (i + 1))]);
    panels_.push_back(std::move(panel));
  }
}

void UpdatableCholesky::rest() {
  if (size_ > most_packed || panels_.empty() || !triangle_.empty()) return;
  triangle_.reserve(static_cast<std::size_t>(size_ * (size_ + 1) / 2));
  for (std::int64_t j = 0; j < size_; ++j)
    for_column(j, j, size_,
               [this](const double* from, std::int64_t count) { triangle_.insert(triangle_.end(), from, from + count); });
  panels_.clear();
}

void UpdatableCholesky::wake() {
  if (triangle_.empty()) return;
  reserve(size_);
  const double* from = triangle_.data();
  for (std::int64_t j = 0; j < size_; ++j)
    for_column(j, j, size_, [&from](double* to, std::int64_t count) {
      std::copy_n(from, count, to);
      from += count;
    });
  triangle_ = std::vector<double>();
}

void UpdatableCholesky::truncate(std::int64_t size) {
  if (size == 0)
    triangle_ = std::vector<double>();
  else
    wake();
  size_ = size;
  panels_.resize(static_cast<std::size_t>((size + panel_rows - 1) / panel_rows));
}

// visit(where, count) for the rows first .. last of a column, in order, in pieces that are contiguous.
template <class Visit>
void UpdatableCholesky::for_column(std::int64_t column, std::int64_t first, std::int64_t last, const Visit& visit) const {
  while (first < last) {
    const std::int64_t end = std::min(last, (first / panel_rows + 1) * panel_rows);
    visit(entry(first, column), end - first);
    first = end;
  }
}

std::optional<UpdatableCholesky::BadPivot> UpdatableCholesky::append(std::int64_t count, const ColumnSource& source) {
  wake();
  const std::int64_t before = size_, end = size_ + count;
  const double rounding = static_cast<double>(end) * std::numeric_limits<double>::epsilon();
  try {
    reserve(end);
    while (size_ < end) {
      const std::int64_t last = std::min(end, (size_ / panel_rows + 1) * panel_rows);
      const bool few = last - size_ < few_rows;
      if (auto bad = few ? append_row(source, rounding) : append_to_panel(last, source, rounding)) {
        truncate(before);
        return bad;
      }
    }
  } catch (...) {
    truncate(before);
    throw;
  }
  return std::nullopt;
}

std::optional<UpdatableCholesky::BadPivot> UpdatableCholesky::append_row(const ColumnSource& source, double rounding) {
  const std::int64_t n = size_;
  Eigen::VectorXd row(n + 1);
  for (std::int64_t j = 0; j <= n; ++j) source(n, 1, j, row.data() + j);
  forward(row.data(), n);
  const double pivot = row(n) - row.head(n).squaredNorm();
  if (!(pivot > rounding * row(n))) return BadPivot{n, pivot};
  row(n) = std::sqrt(pivot);
  for (std::int64_t j = 0; j <= n; ++j) *entry(n, j) = row(j);
  size_ = n + 1;
  return std::nullopt;
}

// Appends the rows size() .. last of one panel: solves with each panel before it and with its present rows, factors the rest.
std::optional<UpdatableCholesky::BadPivot> UpdatableCholesky::append_to_panel(std::int64_t last, const ColumnSource& source,
                                                                              double rounding) {
  const std::int64_t index = size_ / panel_rows, first = index * panel_rows, present = size_ - first, rows = last - size_;
  for (std::int64_t j = 0; j < last; ++j) {
    const std::int64_t row = std::max(size_, j);
    source(row, last - row, j, entry(row, j));
  }
  Panel panel(at(index, 0), panel_rows, first + panel_rows);
  auto added = panel.middleRows(present, rows);
  auto corner = added.middleCols(first + present, rows);
  const Eigen::VectorXd smallest_pivot = rounding * corner.diagonal();
  for (std::int64_t k = 0; k < index; ++k) {
    const std::int64_t done = k * panel_rows;
    const Panel above(at(k, 0), panel_rows, done + panel_rows);
    auto block = added.middleCols(done, panel_rows);
    if (k > 0) block.noalias() -= added.leftCols(done) * above.leftCols(done).transpose();
    above.rightCols(panel_rows).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(block);
  }
  if (present > 0) {
    const auto own = panel.topRows(present);
    auto block = added.middleCols(first, present);
    if (index > 0) block.noalias() -= added.leftCols(first) * own.leftCols(first).transpose();
    own.middleCols(first, present).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(block);
  }
  if (size_ > 0) corner.selfadjointView<Eigen::Lower>().rankUpdate(added.leftCols(size_), -1.0);
  if (auto bad = factor(corner, smallest_pivot)) {
    bad->unknown += size_;
    return bad;
  }
  size_ = last;
  return std::nullopt;
}

// Removes in batches, the last unknowns first, because the rank-one terms of a batch take memory.
void UpdatableCholesky::remove(std::span<const std::int64_t> removed) {
  wake();
  constexpr std::int64_t most_numbers = 4194304;
  while (!removed.empty()) {
    const auto batch = static_cast<std::size_t>(std::max<std::int64_t>(16, most_numbers / size_));
    const std::size_t left = removed.size() - std::min(removed.size(), batch);
    remove_batch(removed.subspan(left));
    removed = removed.first(left);
  }
}

void UpdatableCholesky::remove_batch(std::span<const std::int64_t> removed) {
  const std::int64_t n = size_, first = removed.front(), kept = n - static_cast<std::int64_t>(removed.size());
  // Column a: the rank-one term left by removed[a], rows first .. kept of the new numbering.
  Eigen::MatrixXd terms(kept - first, static_cast<Eigen::Index>(removed.size()));
  Eigen::VectorXd column(n - first);
  // Copies the rows from `row` on, without the removed ones.
  const auto copy_kept = [this, n](std::int64_t j, std::int64_t row, std::span<const std::int64_t> without, double* to) {
    const auto copy = [&to](const double* from, std::int64_t count) { to = std::copy_n(from, count, to); };
    for (const std::int64_t next : without) {
      for_column(j, row, next, copy);
      row = next + 1;
    }
    for_column(j, row, n, copy);
  };

  Eigen::Index active = 0;
  for (std::int64_t j = 0; j < n; ++j) {
    const std::int64_t moved = j - active, row = std::max(moved, first);  // of the new numbering
    const auto still_in = removed.subspan(static_cast<std::size_t>(active));
    if (!still_in.empty() && still_in.front() == j) {
      copy_kept(j, j + 1, still_in.subspan(1), terms.col(active).data() + (row - first));
      ++active;
      continue;
    }
    double* l = column.data();
    copy_kept(j, std::max(j, first), still_in, l);
    for (Eigen::Index a = 0; a < active; ++a) {
      double* term = terms.col(a).data() + (row - first);
      const double diagonal = std::hypot(l[0], term[0]);
      const double c = l[0] / diagonal, s = term[0] / diagonal;
      l[0] = diagonal;
      rotate(c, s, kept - row - 1, l + 1, term + 1);
    }
    for_column(moved, row, kept, [&l](double* to, std::int64_t count) {
      std::copy_n(l, count, to);
      l += count;
    });
  }
  truncate(kept);
}

// The first n of x = L^-1 x.
void UpdatableCholesky::forward(double* x, std::int64_t n) const {
  for (std::int64_t first = 0; first < n; first += panel_rows) {
    const std::int64_t rows = std::min(panel_rows, n - first);
    const Panel panel(at(first / panel_rows, 0), panel_rows, first + panel_rows);
    Eigen::Map<Eigen::VectorXd> part(x + first, rows);
    if (first > 0) part.noalias() -= panel.topLeftCorner(rows, first) * Eigen::Map<const Eigen::VectorXd>(x, first);
    panel.block(0, first, rows, rows).triangularView<Eigen::Lower>().solveInPlace(part);
  }
}

void UpdatableCholesky::solve(double* b) const {
  forward(b, size_);
  for (auto i = static_cast<std::int64_t>(panels_.size()) - 1; i >= 0; --i) {
    const std::int64_t first = i * panel_rows, rows = std::min(panel_rows, size_ - first);
    const Panel panel(at(i, 0), panel_rows, first + panel_rows);
    Eigen::Map<Eigen::VectorXd> part(b + first, rows);
    panel.block(0, first, rows, rows).triangularView<Eigen::Lower>().transpose().solveInPlace(part);
    if (first > 0) Eigen::Map<Eigen::VectorXd>(b, first).noalias() -= panel.topLeftCorner(rows, first).transpose() * part;
  }
}

bool rotations_pay(std::int64_t n, std::span<const std::int64_t> removed, std::int64_t added) {
  // Time of an operation of a rotation over one of a blocked factorization, measured near the break-even for n = 500 .. 4000:
  // 1 with two numbers per vector register, 2 with eight.
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
