/* roughcontact: the algorithms of Bemporad & Paggi (2015) on a matrix of the caller's, one call each. Arrays are plain pointers, as
 * in LAPACK, whose layout of matrices they share. */
#ifndef ROUGHCONTACT_DIRECT_H
#define ROUGHCONTACT_DIRECT_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Results of a direct routine besides p and w. */
typedef struct rc_direct {
  size_t struct_size;
  rc_status status;     /* as returned                                                                               */
  int32_t reserved;     /* 0                                                                                         */
  int64_t iterations;   /* of the solver                                                                             */
  int64_t products;     /* products with H, the certificate's included                                               */
  int64_t contacts;     /* values p > 0                                                                              */
  double load;          /* sum of p; rc_cmr: normal force [force]                                                    */
  double energy;        /* 1/2 p'Hp - u'p; rc_cmr: [force length]                                                    */
  double kkt;           /* the largest kkt_* residual, see rc_result                                                 */
  double duality_gap, load_lower, load_upper; /* as in rc_result                                                     */
  char note[512];       /* as in rc_result                                                                           */
} rc_direct;
#define RC_DIRECT_INIT RC_BEGIN_WITH(rc_direct, status = RC_ERR_ARGUMENT)

/** @defgroup direct Direct routines: one call, plain arguments, no handles
 *  Minimise 1/2 p'Hp - u'p over p >= 0 for the caller's symmetric positive definite n x n matrix H (row stride ld >= n):
 *  the method of that name, certified like every answer. p [n]: start in, solution out (zeros are a good start);
 *  w [n]: out, Hp - u, or NULL. With influence coefficients per force p are forces. tol: largest residual relative to
 *  max(u), 1e-16 .. 0.1. result may be NULL. p and w are written whenever the status is >= 0.
 *  Errors: ARGUMENT, SHAPE, OPTION (tol or max_iter out of range), MEMORY, NUMERIC.
 *  @{ */
/** Greedy active set (Algorithm 1): on some matrices it ends with an answer that is not certified. */
RC_API rc_status rc_greedy(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol,
                           int64_t max_iter, rc_direct *result);
/** Constrained conjugate gradients (Algorithm 2). */
RC_API rc_status rc_polonsky_keer(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol,
                                  int64_t max_iter, rc_direct *result);
/** Non-negative least squares, finite and exact (Algorithm 3). */
RC_API rc_status rc_nnls(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol,
                         int64_t max_iter, rc_direct *result);
/** Accelerated gradient projection (Algorithm 4). */
RC_API rc_status rc_gp(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol,
                       int64_t max_iter, rc_direct *result);
/** Alternating direction method of multipliers (Algorithm 5). */
RC_API rc_status rc_admm(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol,
                         int64_t max_iter, rc_direct *result);
/** Cascade multi-resolution (Algorithm 6) on a height map of nx*ny cells hx x hy, free boundaries, tolerance 1e-8.
 *  heights: the largest touches first; approach: from there; levels: grids of the cascade, the given one
 *  included; radius: of influence in coarse cells, >= 1; inner: solver on every level, NULL: chosen by the core;
 *  p [nx*ny]: pressures out [force/length^2]. Errors: as above, and NO_SOLVER, INCOMPATIBLE. */
RC_API rc_status rc_cmr(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double *heights, double approach,
                        int64_t levels, double radius, const char *inner, double *p, rc_direct *result);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
