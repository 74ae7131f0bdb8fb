#include "factor.h"

#include <limits>
#include <numeric>
#include <vector>

#include "failure.h"
#include "one_thread.h"

namespace rc_cholmod {

namespace {

[[noreturn]] void refuse(std::int64_t slot, std::int64_t size) {
  fail(RC_ERR_NUMERIC, "the matrix is not positive definite: it has no pivot ", slot + 1, " of ", size,
       "; it must be symmetric positive definite on every set of points (a periodic one with zero mode 0 is not on all of them)");
}

}  // namespace

// The pattern holds every slot from the start, free ones with zeros, so that rows come and go without moving a column.
Factor::Factor(Session& session, std::int64_t size, std::int64_t slots, const rc_common::ColumnSource& source, double shift)
    : session_(session) {
  const double entries = 0.5 * static_cast<double>(slots) * (static_cast<double>(slots) + 1.0);
  Session::Sparse A = session.sparse(slots, slots, entries, -1);
  int *column = columns_of(*A), *row = rows_of(*A);
  double* value = values_of(*A);
  std::vector<double> diagonal(static_cast<std::size_t>(size));
  column[0] = 0;
  for (std::int64_t j = 0; j < slots; ++j) {
    const std::int64_t count = slots - j;
    std::iota(row, row + count, static_cast<int>(j));
    std::fill_n(value, count, 0.0);
    if (j < size) {
      source(j, size - j, j, value);
      diagonal[static_cast<std::size_t>(j)] = value[0] + shift;
    } else {
      value[0] = 1.0;
    }
    row += count;
    value += count;
    column[j + 1] = column[j] + static_cast<int>(count);
  }
  session.order(true);
  L_ = session.analyze(*A);
  if (!session.factorize(*A, shift, *L_)) refuse(static_cast<std::int64_t>(L_->minor), size);
  A.reset();
  session.to_columns(*L_);
  const double rounding = static_cast<double>(size) * std::numeric_limits<double>::epsilon();
  for (std::int64_t j = 0; j < size; ++j)
    if (!(pivot(j) > rounding * diagonal[static_cast<std::size_t>(j)])) refuse(j, size);
}

double Factor::pivot(std::int64_t slot) const { return static_cast<const double*>(L_->x)[static_cast<const int*>(L_->p)[slot]]; }

void Factor::remove(std::int64_t slot) {
  const OneThread one;
  cholmod_rowdel(static_cast<std::size_t>(slot), nullptr, L_.get(), session_.common());
  session_.check();
}

bool Factor::add(std::int64_t slot, std::int64_t count, const std::int64_t* slots_of_row, const double* entries) {
  const Session::Sparse row = session_.sparse(slots(), 1, static_cast<double>(count), 0);
  columns_of(*row)[0] = 0;
  columns_of(*row)[1] = static_cast<int>(count);
  std::copy_n(slots_of_row, count, rows_of(*row));
  std::copy_n(entries, count, values_of(*row));
  const OneThread one;
  cholmod_rowadd(static_cast<std::size_t>(slot), row.get(), L_.get(), session_.common());
  const bool definite = session_.common()->status == CHOLMOD_OK;
  session_.check();
  // Adding a row changes the rows after it by subtraction, so their pivots may have become too small.
  for (std::int64_t j = slot; definite && j < slots(); ++j)
    if (!(pivot(j) > 0.0)) return false;
  return definite;
}

}  // namespace rc_cholmod
