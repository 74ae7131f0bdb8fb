#include "transform.h"

#include <algorithm>

namespace rc_fft {

namespace {

// A thread takes this many rows at a time, and clears its line once for them.
constexpr std::int64_t rows_per_item = 8;

}  // namespace

template <class Real> Layout<Real>::Layout(Lengths l) : lengths(l), half_x(l.x / 2 + 1), half_y(l.y / 2 + 1) {
  constexpr std::int64_t width = columns_per_block<Real>;
  row_stride = round_up(half_x, width);
  // Rows a multiple of 4096 bytes apart would compete for the same cache sets.
  if (row_stride % (32 * width) == 0) row_stride += width;
  column = round_up(l.y, 16);
  scratch = std::max({round_up(l.x, width), width * ColumnProduct<Real>::scratch_rows(l.y), 2 * column});
}

template <class Real>
Transform<Real>::Transform(const rc_host* host, Lengths lengths, std::int64_t rows, Planning& planning, Workspace& workspace,
                           const rc_team& team)
    : layout_(lengths), workspace_(workspace), team_(team), parallel_(worth_sharing(lengths)) {
  reserve(rows);
  spectrum_.reserve<Real>(layout_.blocks() * width, layout_.half_y, lengths);
  if (has_small_factors(lengths.y)) own_columns_.emplace(lengths.y);
  plans_.emplace(host, lengths, planning, line(0), row(0), scratch(0), scratch(0) + layout_.column);
}

template <class Real> void Transform<Real>::reserve(std::int64_t rows) {
  workspace_.rows.reserve<Complex>(rows, layout_.row_stride, layout_.lengths);
  workspace_.scratch.reserve<Complex>(team_.threads, layout_.scratch, layout_.lengths);
}

template <class Real> double Transform<Real>::scale() const {
  return 1.0 / (plans_->gain() * static_cast<double>(layout_.lengths.y));
}

template <class Real> void Transform<Real>::load(const Eigenvalues& source) {
  const double factor = scale();
  roughcontact::for_each(team_, source.blocks(), parallel_, [&](std::int64_t wide, std::int64_t thread) {
    constexpr std::int64_t parts = Eigenvalues::width / width;
    const std::int64_t first = wide * parts, last = std::min(first + parts, layout_.blocks());
    source.along_y(wide, thread, [&](std::int64_t ky, const double* values) {
      for (std::int64_t block = first; block < last; ++block) {
        Real* const to = eigenvalues(block, ky);
        const double* const from = values + (block - first) * width;
        for (std::int64_t c = 0; c < width; ++c) to[c] = static_cast<Real>(factor * from[c]);
      }
    });
  });
}

template <class Real> template <class Other> void Transform<Real>::load(const Transform<Other>& source) {
  for (std::int64_t kx = 0; kx < layout_.half_x; ++kx)
    for (std::int64_t ky = 0; ky < layout_.half_y; ++ky)
      eigenvalues(kx / width, ky)[kx % width] = static_cast<Real>(source.eigenvalues(kx / source.width, ky)[kx % source.width]);
}

template <class Real>
template <class Outer>
void Transform<Real>::multiply(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x, const Points& targets,
                               Outer* y, const Conversion& convert) {
  reserve(targets.rows());
  rows_forward(sources, x0, y0, x, convert);
  columns(y0, sources.rows(), targets.rows());
  rows_backward(targets, y, convert);
}

template <class Real>
template <class Outer>
void Transform<Real>::rows_forward(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x,
                                   const Conversion& convert) {
  const std::int64_t items = (sources.rows() + rows_per_item - 1) / rows_per_item;
  roughcontact::for_each(team_, items, parallel_, [&](std::int64_t item, std::int64_t thread) {
    Real* const padded = line(thread);
    std::fill_n(padded, layout_.lengths.x, Real{0});
    const std::int64_t end = std::min((item + 1) * rows_per_item, sources.rows());
    for (std::int64_t i = item * rows_per_item; i < end; ++i) {
      Complex* const transformed = row(y0 + i);
      if (convert.mean == 0 && sources.row_is_zero(i, x)) {
        std::fill_n(transformed, layout_.blocks() * width, Complex{});
      } else {
        sources.scatter(i, x, padded + x0, convert);
        plans_->line_to_row(padded, transformed);
        std::fill(transformed + layout_.half_x, transformed + layout_.blocks() * width, Complex{});
      }
    }
  });
}

template <class Real> void Transform<Real>::columns(std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows) {
  roughcontact::for_each(team_, layout_.blocks(), parallel_, [&](std::int64_t block, std::int64_t thread) {
    if (own_columns_)
      own_columns_->multiply({row(0) + block * width, layout_.row_stride, y0, source_rows, target_rows,
                              spectrum_.data<Real>() + block * layout_.half_y * width, scratch(thread)});
    else
      columns_by_fftw(block, scratch(thread), y0, source_rows, target_rows);
  });
}

template <class Real>
void Transform<Real>::columns_by_fftw(std::int64_t block, Complex* column, std::int64_t y0, std::int64_t source_rows,
                                      std::int64_t target_rows) {
  const std::int64_t length = layout_.lengths.y;
  Complex* const waves = column + layout_.column;
  for (std::int64_t c = 0; c < width; ++c) {
    Complex* const at = row(0) + block * width + c;
    std::fill_n(column, length, Complex{});
    for (std::int64_t iy = y0; iy < y0 + source_rows; ++iy) column[iy] = at[iy * layout_.row_stride];
    plans_->column_to_waves(column, waves);
    for (std::int64_t k = 0; k < length; ++k) waves[k] *= eigenvalues(block, std::min(k, length - k))[c];
    plans_->waves_to_column(waves, column);
    for (std::int64_t iy = 0; iy < target_rows; ++iy) at[iy * layout_.row_stride] = column[iy];
  }
}

template <class Real>
template <class Outer>
void Transform<Real>::rows_backward(const Points& targets, Outer* y, const Conversion& convert) {
  const std::int64_t items = (targets.rows() + rows_per_item - 1) / rows_per_item;
  roughcontact::for_each(team_, items, parallel_, [&](std::int64_t item, std::int64_t thread) {
    const std::int64_t end = std::min((item + 1) * rows_per_item, targets.rows());
    for (std::int64_t i = item * rows_per_item; i < end; ++i) {
      if (targets.row_is_empty(i)) continue;
      plans_->row_to_line(row(i), line(thread));
      targets.gather(i, line(thread), y, convert);
    }
  });
}

template struct Layout<double>;
template struct Layout<float>;
template class Transform<double>;
template class Transform<float>;
template void Transform<float>::load(const Transform<double>&);
template void Transform<double>::multiply(const Points&, std::int64_t, std::int64_t, const double*, const Points&, double*,
                                          const Conversion&);
template void Transform<float>::multiply(const Points&, std::int64_t, std::int64_t, const float*, const Points&, float*,
                                         const Conversion&);
template void Transform<float>::multiply(const Points&, std::int64_t, std::int64_t, const double*, const Points&, double*,
                                         const Conversion&);

}  // namespace rc_fft
