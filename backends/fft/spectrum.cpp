#include "spectrum.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace rc_fft {

namespace {

constexpr std::int64_t rows_per_item = 16;

}  // namespace

Eigenvalues::Eigenvalues(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace)
    : host_(host),
      workspace_(workspace),
      lengths_(lengths),
      half_x_(lengths.x / 2 + 1),
      half_y_(lengths.y / 2 + 1),
      columns_(std::min(half_x_, spec.system->nx)),
      rows_(std::min(half_y_, spec.system->ny)),
      stride_(round_up(half_x_, width)),
      line_(round_up(std::max(lengths.x, lengths.y), width)),
      scratch_(2 * line_ + std::max(rows_per_item * round_up(columns_, width) / 2, lengths.y * width / 2)) {
  workspace_.rows.reserve<double>(half_y_, stride_, lengths);
  workspace_.scratch.reserve<std::complex<double>>(spec.team->threads, scratch_, lengths);
}

Eigenvalues Eigenvalues::free(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace) {
  Eigenvalues result(host, spec, lengths, workspace);
  result.along_x(spec, [&](std::int64_t first, std::int64_t count, double* out) {
    return host->window(host, spec.system, spec.kernel, 0, first, result.columns_, count, out);
  });
  return result;
}

Eigenvalues Eigenvalues::squares(const rc_host* host, const rc_operator_spec& spec, double constant, Lengths lengths,
                                 Workspace& workspace) {
  Eigenvalues result(host, spec, lengths, workspace);
  const std::int64_t columns = result.columns_;
  std::vector<double> table(static_cast<std::size_t>(columns * result.rows_));
  roughcontact::check(host->coefficients(host, spec.system, spec.kernel, columns, result.rows_, table.data()));
  for (double& value : table) value = (value + constant) * (value + constant);
  result.along_x(spec, [&](std::int64_t first, std::int64_t count, double* out) {
    std::copy_n(table.data() + first * columns, count * columns, out);
    return rc_status{RC_OK};
  });
  return result;
}

Eigenvalues Eigenvalues::periodic(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace) {
  Eigenvalues result(host, spec, lengths, workspace);
  double* const table = result.table();
  roughcontact::check(host->symbol(host, spec.system, spec.kernel, table));
  // Spaces the rows out to the stride, from the last row on, because every row moves towards the end.
  for (std::int64_t ky = result.half_y_ - 1; ky >= 0; --ky) {
    double* const row = table + ky * result.stride_;
    std::copy_backward(table + ky * result.half_x_, table + (ky + 1) * result.half_x_, row + result.half_x_);
    std::fill(row + result.half_x_, row + result.stride_, 0.0);
  }
  return result;
}

// rows(first, count, out): coefficients of `count` rows from `first` on, into rows of columns_ values.
template <class Rows> void Eigenvalues::along_x(const rc_operator_spec& spec, const Rows& rows) {
  plans_ = std::make_unique<EvenPlans>(host_, lengths_, scratch(0), scratch(0) + line_);
  std::atomic<std::int64_t> failed{-1};
  const std::int64_t items = (rows_ + rows_per_item - 1) / rows_per_item;
  roughcontact::for_each(*spec.team, items, worth_sharing(lengths_), [&](std::int64_t item, std::int64_t thread) {
    std::complex<double>*const line = scratch(thread), *const waves = line + line_;
    double* const coefficients = reinterpret_cast<double*>(waves + line_);
    const std::int64_t begin = item * rows_per_item, end = std::min(begin + rows_per_item, rows_);
    if (rows(begin, end - begin, coefficients) != RC_OK) {
      failed = begin;
      return;
    }
    // Two real rows in one complex transform. They are even, so their transforms are real and do not mix.
    for (std::int64_t iy = begin; iy < end; iy += 2) {
      const double* const one = coefficients + (iy - begin) * columns_;
      const double* const other = iy + 1 < end ? one + columns_ : nullptr;
      std::fill_n(line, lengths_.x, std::complex<double>{});
      for (std::int64_t ix = 0; ix < columns_; ++ix) {
        const std::complex<double> pair{one[ix], other ? other[ix] : 0.0};
        line[ix] = pair;
        line[ix == 0 ? 0 : lengths_.x - ix] = pair;
      }
      plans_->along_x(line, waves);
      double* const row = table() + iy * stride_;
      for (std::int64_t kx = 0; kx < half_x_; ++kx) row[kx] = waves[kx].real();
      std::fill(row + half_x_, row + stride_, 0.0);
      if (!other) continue;
      for (std::int64_t kx = 0; kx < half_x_; ++kx) row[stride_ + kx] = waves[kx].imag();
      std::fill(row + stride_ + half_x_, row + 2 * stride_, 0.0);
    }
  });
  // Asks again on this thread for the message: those of other threads are not seen here.
  if (failed >= 0) {
    std::vector<double> row(static_cast<std::size_t>(columns_));
    roughcontact::check(rows(failed, 1, row.data()));
    fail(RC_ERR_INTERNAL, "influence coefficients could not be computed at first, but were on a second attempt; try again");
  }
}

// Neighbouring columns are the real and imaginary parts of one complex column, as for rows.
void Eigenvalues::transform_block(std::int64_t block, std::int64_t thread) const {
  constexpr std::int64_t pairs = width / 2;
  std::complex<double>*const column = scratch(thread), *const transformed = column + line_, *const to = waves(thread);
  for (std::int64_t pair = 0; pair < pairs; ++pair) {
    std::fill_n(column, lengths_.y, std::complex<double>{});
    for (std::int64_t iy = 0; iy < rows_; ++iy) {
      const auto* const from = reinterpret_cast<const std::complex<double>*>(table() + iy * stride_ + block * width);
      column[iy] = column[iy == 0 ? 0 : lengths_.y - iy] = from[pair];
    }
    plans_->along_y(column, transformed);
    for (std::int64_t ky = 0; ky < half_y_; ++ky) to[ky * pairs + pair] = transformed[ky];
  }
}

}  // namespace rc_fft
