#include "session.h"

#include <algorithm>
#include <climits>
#include <new>

#include "failure.h"
#include "one_thread.h"

namespace rc_cholmod {

Session::Session() {
  if (!cholmod_start(&common_)) throw std::bad_alloc();
  common_.print = 0;
  common_.error_handler = nullptr;
  common_.nmethods = 1;  // no trials: the same input gives the same factor
  common_.final_asis = 1;
  common_.final_ll = 1;  // L D L' would not notice a negative pivot
  common_.quick_return_if_not_posdef = 1;
}

void Session::order(bool as_given) {
  common_.method[0].ordering = as_given ? CHOLMOD_NATURAL : CHOLMOD_AMD;
  common_.postorder = as_given ? 0 : 1;
  common_.supernodal = as_given ? CHOLMOD_SUPERNODAL : CHOLMOD_AUTO;
}

void Session::check() {
  const int status = common_.status;
  common_.status = CHOLMOD_OK;
  if (status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status == CHOLMOD_TOO_LARGE)
    fail(RC_ERR_MEMORY, "the factor has more entries than CHOLMOD's 32-bit integers count; use a backend that stores no matrix");
  if (status < CHOLMOD_OK) fail(RC_ERR_INTERNAL, "CHOLMOD reports error ", status);
}

Session::Sparse Session::sparse(std::int64_t rows, std::int64_t columns, double entries, int stype) {
  if (entries > INT_MAX || rows > INT_MAX)
    fail(RC_ERR_MEMORY, "a matrix of ", entries,
         " entries is more than CHOLMOD's 32-bit integers count; use a backend that stores "
         "no matrix");
  Sparse made(cholmod_allocate_sparse(static_cast<std::size_t>(rows), static_cast<std::size_t>(columns),
                                      static_cast<std::size_t>(entries), 1, 1, stype, CHOLMOD_REAL, &common_),
              {&common_});
  check();
  return made;
}

Session::Factor Session::analyze(cholmod_sparse& A) {
  const OneThread one;
  Factor made(cholmod_analyze(&A, &common_), {&common_});
  check();
  return made;
}

bool Session::factorize(cholmod_sparse& A, double shift, cholmod_factor& L) {
  const OneThread one;
  require_blas_workspace();
  double beta[2] = {shift, 0.0};
  cholmod_factorize_p(&A, beta, nullptr, 0, &L, &common_);
  check();
  return L.minor == L.n;
}

void Session::to_columns(cholmod_factor& L) {
  // Supernodes make factoring fast. Columns are needed to add and delete rows, and solves with columns have no workspace whose
  // allocation CHOLMOD fails to check.
  if (!L.is_super) return;
  const OneThread one;
  cholmod_change_factor(CHOLMOD_REAL, 0, 0, 0, 1, &L, &common_);
  check();
}

void Session::solve(cholmod_factor& L, double* b) {
  cholmod_dense right = {};
  right.nrow = right.nzmax = right.d = L.n;
  right.ncol = 1;
  right.x = b;
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  const OneThread one;
  const Dense x(cholmod_solve(CHOLMOD_A, &L, &right, &common_), {&common_});
  check();
  std::copy_n(static_cast<const double*>(x->x), L.n, b);
}

}  // namespace rc_cholmod
