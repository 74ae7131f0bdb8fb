#include "transform.h"

#include <algorithm>
#include <type_traits>

namespace rc_fft {

namespace {

// Below this many points waking the helpers costs more than they save.
constexpr double least_parallel = 16384;

// A line is cleared once per so many rows.
constexpr std::int64_t rows_per_item = 8;

// A constant count for whole blocks lets the compiler unroll.
template <class Copy> void with_width(std::int64_t width, const Copy& copy) {
  if (width == columns_per_block)
    copy(std::integral_constant<std::int64_t, columns_per_block>{});
  else
    copy(width);
}

void scale_column(double* z, const double* factor, std::int64_t n) {
  const std::int64_t half = n / 2;
  for (std::int64_t k = 0; k <= half; ++k) {
    z[2 * k] *= factor[k];
    z[2 * k + 1] *= factor[k];
  }
  for (std::int64_t k = half + 1; k < n; ++k) {
    z[2 * k] *= factor[n - k];
    z[2 * k + 1] *= factor[n - k];
  }
}

}  // namespace

Layout::Layout(Lengths l) : lengths(l), half_x(l.x / 2 + 1), half_y(l.y / 2 + 1) {
  row_stride = aligned(2 * half_x);
  // Rows a multiple of 4096 bytes apart would compete for the same cache sets.
  if (row_stride % 512 == 0) row_stride += 2 * columns_per_block;
  column_stride = aligned(2 * l.y) + 2 * columns_per_block;
  scratch = std::max(aligned(l.x) + row_stride, columns_per_block * column_stride);
}

Transform::Transform(const rc_host* host, Lengths lengths, std::int64_t rows, unsigned effort, Workspace& workspace,
                     const rc_team& team)
    : layout_(lengths),
      workspace_(workspace),
      team_(team),
      parallel_(static_cast<double>(lengths.x) * static_cast<double>(lengths.y) >= least_parallel) {
  reserve(rows);
  spectrum_.reserve(layout_.half_x, layout_.half_y, lengths);
  plans_.emplace(host, lengths, effort, scratch(0), row(0), scratch(0));
}

void Transform::reserve(std::int64_t rows) {
  // While eigenvalues are made, the rows hold half_y rows of half_x real values.
  workspace_.rows.reserve(std::max(rows, (layout_.half_y + 1) / 2), layout_.row_stride, layout_.lengths);
  workspace_.scratch.reserve(team_.threads, layout_.scratch, layout_.lengths);
}

void Transform::multiply(const Points& sources, std::int64_t x0, std::int64_t y0, const double* x, const Points& targets,
                         double* y) {
  reserve(targets.rows());
  rows_forward(sources, x0, y0, x);
  columns(y0, sources.rows(), targets.rows());
  rows_backward(targets, y);
}

void Transform::rows_forward(const Points& sources, std::int64_t x0, std::int64_t y0, const double* x) {
  const std::int64_t items = (sources.rows() + rows_per_item - 1) / rows_per_item;
  roughcontact::for_each(team_, items, parallel_, [&](std::int64_t item, std::int64_t thread) {
    double* const line = scratch(thread);
    std::fill_n(line, layout_.lengths.x, 0.0);
    const std::int64_t end = std::min((item + 1) * rows_per_item, sources.rows());
    for (std::int64_t i = item * rows_per_item; i < end; ++i) {
      if (sources.row_is_zero(i, x)) {
        std::fill_n(row(y0 + i), 2 * layout_.half_x, 0.0);
      } else {
        sources.scatter(i, x, line + x0);
        plans_->line_to_row(line, row(y0 + i));
      }
    }
  });
}

void Transform::columns(std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows) {
  roughcontact::for_each(team_, layout_.blocks(), parallel_, [&](std::int64_t block, std::int64_t thread) {
    const std::int64_t first = block * columns_per_block;
    const std::int64_t stride = layout_.column_stride, length = layout_.lengths.y;
    double* const block_columns = scratch(thread);
    with_width(std::min(columns_per_block, layout_.half_x - first), [&](auto width) {
      for (std::int64_t iy = y0; iy < y0 + source_rows; ++iy) {
        const double* const from = row(iy) + 2 * first;
        for (std::int64_t c = 0; c < width; ++c) {
          block_columns[c * stride + 2 * iy] = from[2 * c];
          block_columns[c * stride + 2 * iy + 1] = from[2 * c + 1];
        }
      }
      for (std::int64_t c = 0; c < width; ++c) {
        double* const column = block_columns + c * stride;
        std::fill(column, column + 2 * y0, 0.0);
        std::fill(column + 2 * (y0 + source_rows), column + 2 * length, 0.0);
        plans_->forward(column);
        scale_column(column, eigenvalues(first + c), length);
        plans_->backward(column);
      }
      for (std::int64_t iy = 0; iy < target_rows; ++iy) {
        double* const to = row(iy) + 2 * first;
        for (std::int64_t c = 0; c < width; ++c) {
          to[2 * c] = block_columns[c * stride + 2 * iy];
          to[2 * c + 1] = block_columns[c * stride + 2 * iy + 1];
        }
      }
    });
  });
}

void Transform::rows_backward(const Points& targets, double* y) {
  const std::int64_t items = (targets.rows() + rows_per_item - 1) / rows_per_item;
  roughcontact::for_each(team_, items, parallel_, [&](std::int64_t item, std::int64_t thread) {
    double* const line = scratch(thread);
    const std::int64_t end = std::min((item + 1) * rows_per_item, targets.rows());
    for (std::int64_t i = item * rows_per_item; i < end; ++i) {
      if (targets.row_is_empty(i)) continue;
      plans_->row_to_line(row(i), line);
      targets.gather(i, line, y);
    }
  });
}

}  // namespace rc_fft
