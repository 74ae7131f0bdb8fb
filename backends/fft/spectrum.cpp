#include "spectrum.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace rc_fft {

Eigenvalues::Eigenvalues(const rc_operator_spec& spec, bool coefficients, Lengths lengths, Workspace& workspace)
    : workspace_(workspace),
      lengths_(lengths),
      axes_(lengths),
      coefficients_(coefficients),
      row_length_(std::min(axes_.x->waves(), spec.system->nx)),
      rows_(std::min(axes_.y->waves(), spec.system->ny)),
      stride_(round_up(axes_.x->waves(), columns)),
      scratch_((std::max(Fourier<double>::scratch_rows(lengths.x), Fourier<double>::scratch_rows(lengths.y)) + 2 * row_length_) *
               row_size<double>) {
  workspace_.rows.reserve<double>(axes_.y->waves(), stride_, lengths);
  workspace_.scratch.reserve<double>(spec.team->threads, scratch_, lengths);
}

Eigenvalues Eigenvalues::free(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace) {
  Eigenvalues result(spec, true, lengths, workspace);
  result.along_x(spec, [&](std::int64_t first, std::int64_t count, double* out) {
    return host->window(host, spec.system, spec.kernel, 0, first, result.row_length_, count, out);
  });
  return result;
}

Eigenvalues Eigenvalues::squares(const rc_host* host, const rc_operator_spec& spec, double constant, Lengths lengths,
                                 Workspace& workspace) {
  Eigenvalues result(spec, true, lengths, workspace);
  const std::int64_t length = result.row_length_;
  std::vector<double> table(static_cast<std::size_t>(length * result.rows_));
  roughcontact::check(host->coefficients(host, spec.system, spec.kernel, length, result.rows_, table.data()));
  for (double& value : table) value = (value + constant) * (value + constant);
  result.along_x(spec, [&](std::int64_t first, std::int64_t count, double* out) {
    std::copy_n(table.data() + first * length, count * length, out);
    return rc_status{RC_OK};
  });
  return result;
}

Eigenvalues Eigenvalues::periodic(const rc_host* host, const rc_operator_spec& spec, Lengths lengths, Workspace& workspace) {
  Eigenvalues result(spec, false, lengths, workspace);
  double* const table = result.table();
  roughcontact::check(host->symbol(host, spec.system, spec.kernel, table));
  // Puts the waves in their order and the rows out to the stride, from the last row on, because every row moves towards the end.
  const Fourier<double>& along = *result.axes_.x;
  const std::int64_t waves = along.waves();
  std::vector<double> row(static_cast<std::size_t>(waves));
  for (std::int64_t ky = result.axes_.y->waves() - 1; ky >= 0; --ky) {
    std::copy_n(table + ky * waves, waves, row.begin());
    double* const to = table + ky * result.stride_;
    for (std::int64_t kx = 0; kx < waves; ++kx) to[along.rank(kx)] = row[static_cast<std::size_t>(kx)];
    std::fill(to + waves, to + result.stride_, 0.0);
  }
  return result;
}

// rows(first, count, out): coefficients of `count` rows from `first` on, into rows of row_length_ values.
template <class Rows> void Eigenvalues::along_x(const rc_operator_spec& spec, const Rows& rows) {
  constexpr std::int64_t most = most_lines<double>;
  const Fourier<double>& along = *axes_.x;
  std::atomic<std::int64_t> failed{-1};
  const std::int64_t items = (rows_ + most - 1) / most;
  roughcontact::for_each(*spec.team, items, worth_sharing(lengths_), [&](std::int64_t item, std::int64_t thread) {
    double *const sequences = scratch(thread) + Fourier<double>::scratch_rows(lengths_.x) * row_size<double>,
                  *const coefficients = sequences + row_length_ * row_size<double>;
    const std::int64_t begin = item * most, count = std::min(most, rows_ - begin);
    if (rows(begin, count, coefficients) != RC_OK) {
      failed = begin;
      return;
    }
    for (std::int64_t i = 0; i < row_length_; ++i)
      for (std::int64_t row = 0; row < most; ++row)
        sequences[i * most + row] = row < count ? coefficients[row * row_length_ + i] : 0;
    // Two real rows in one complex sequence. They are even, so their transforms are real and do not mix.
    EvenSource<double> source(sequences, most, row_length_, along.length());
    along.forward(source, scratch(thread));
    for (std::int64_t row = 0; row < count; ++row) {
      double* const to = table() + (begin + row) * stride_;
      for (std::int64_t rank = 0; rank < along.waves(); ++rank) to[rank] = scratch(thread)[along.rows()[rank].row * most + row];
      std::fill(to + along.waves(), to + stride_, 0.0);
    }
  });
  // Asks again on this thread for the message: those of other threads are not seen here.
  if (failed >= 0) {
    std::vector<double> row(static_cast<std::size_t>(row_length_));
    roughcontact::check(rows(failed, 1, row.data()));
    fail(RC_ERR_INTERNAL, "influence coefficients could not be computed at first, but were on a second attempt; try again");
  }
}

}  // namespace rc_fft
