// CHOLMOD's workspace and settings, one per operator. It prints nothing, and failures become exceptions.
#pragma once

#include <cholmod.h>

#include <cstdint>
#include <memory>

namespace rc_cholmod {

class Session {
 public:
  Session();
  ~Session() { cholmod_finish(&common_); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  cholmod_common* common() { return &common_; }
  // Sets the order of the unknowns: as given, or one that keeps the factor sparse.
  void order(bool as_given);
  // Throws if CHOLMOD reported a failure since the last call, unless a matrix was merely not positive definite.
  void check();

  template <class Object, int (*release)(Object**, cholmod_common*)> struct Release {
    cholmod_common* common;
    void operator()(Object* object) const { release(&object, common); }
  };
  using Sparse = std::unique_ptr<cholmod_sparse, Release<cholmod_sparse, cholmod_free_sparse>>;
  using Factor = std::unique_ptr<cholmod_factor, Release<cholmod_factor, cholmod_free_factor>>;
  using Dense = std::unique_ptr<cholmod_dense, Release<cholmod_dense, cholmod_free_dense>>;

  // A matrix with room for `entries`; stype as CHOLMOD's: -1 the lower triangle of a symmetric matrix, 0 all of it.
  Sparse sparse(std::int64_t rows, std::int64_t columns, double entries, int stype);
  Factor analyze(cholmod_sparse&);
  // Factors A + shift I. False if it is not positive definite: then the factor's `minor` says where.
  bool factorize(cholmod_sparse&, double shift, cholmod_factor&);
  // Converts a factor in supernodes, if it has any, to L D L' by columns.
  void to_columns(cholmod_factor&);
  // b = A^-1 b for the A that was factored.
  void solve(cholmod_factor&, double* b);

 private:
  cholmod_common common_;
};

inline int* columns_of(cholmod_sparse& A) { return static_cast<int*>(A.p); }
inline int* rows_of(cholmod_sparse& A) { return static_cast<int*>(A.i); }
inline double* values_of(cholmod_sparse& A) { return static_cast<double*>(A.x); }

}  // namespace rc_cholmod
