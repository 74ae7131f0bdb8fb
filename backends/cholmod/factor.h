// A factor of entries of H on numbered slots, some of them free. A free slot is a row and column of the identity matrix.
#pragma once

#include <cstdint>

#include "common/symmetric_matrix.h"
#include "session.h"

namespace rc_cholmod {

class Factor {
 public:
  // Factors the first `size` of `slots` slots, plus `shift` times the identity. Throws RC_ERR_NUMERIC.
  Factor(Session&, std::int64_t size, std::int64_t slots, const rc_common::ColumnSource&, double shift);

  // The most that is held while a factor is made [bytes]: the lower triangle with its row numbers and CHOLMOD's square.
  static double bytes(double slots) { return 14.0 * slots * slots; }

  std::int64_t slots() const { return static_cast<std::int64_t>(L_->n); }
  // b = A^-1 b, over the slots.
  void solve(double* b) { session_.solve(*L_, b); }
  void remove(std::int64_t slot);
  // Fills a free slot with a row of `count` entries in ascending slots, the diagonal's among them. False if the matrix is then
  // not positive definite: the factor must not be used any further.
  bool add(std::int64_t slot, std::int64_t count, const std::int64_t* slots, const double* entries);

 private:
  double pivot(std::int64_t slot) const;

  Session& session_;
  Session::Factor L_{nullptr, {nullptr}};
};

}  // namespace rc_cholmod
