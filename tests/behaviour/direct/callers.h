/* The direct routines by number, through C and through Fortran. */
#ifndef DIRECT_CALLERS_H
#define DIRECT_CALLERS_H

#include <roughcontact/direct.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { GREEDY, POLONSKY_KEER, NNLS, GP, ADMM, ROUTINES };

typedef rc_status (*matrix_caller)(int32_t which, int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w,
                                   double tol, int64_t max_iter, rc_direct* result);
/* `inner` must not be null. */
typedef rc_status (*cascade_caller)(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double* heights,
                                    double delta, int64_t levels, double h, const char* inner, double* p, rc_direct* result);

rc_status matrix_from_c(int32_t which, int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol,
                        int64_t max_iter, rc_direct* result);
rc_status cascade_from_c(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double* heights, double delta,
                         int64_t levels, double h, const char* inner, double* p, rc_direct* result);
/* With arrays as Fortran declares them. w and result are always given, or both absent. */
rc_status matrix_from_fortran(int32_t which, int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w,
                              double tol, int64_t max_iter, rc_direct* result);
rc_status cascade_from_fortran(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double* heights, double delta,
                               int64_t levels, double h, const char* inner, double* p, rc_direct* result);

#ifdef __cplusplus
}
#endif
#endif
