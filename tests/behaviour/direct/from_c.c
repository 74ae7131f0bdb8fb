#include "callers.h"

rc_status matrix_from_c(int32_t which, int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol,
                        int64_t max_iter, rc_direct* result) {
  switch (which) {
    case GREEDY:
      return rc_greedy(n, H, ld, u, p, w, tol, max_iter, result);
    case POLONSKY_KEER:
      return rc_polonsky_keer(n, H, ld, u, p, w, tol, max_iter, result);
    case NNLS:
      return rc_nnls(n, H, ld, u, p, w, tol, max_iter, result);
    case GP:
      return rc_gp(n, H, ld, u, p, w, tol, max_iter, result);
    default:
      return rc_admm(n, H, ld, u, p, w, tol, max_iter, result);
  }
}

rc_status cascade_from_c(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double* heights, double delta,
                         int64_t levels, double h, const char* inner, double* p, rc_direct* result) {
  return rc_cmr(nx, ny, hx, hy, modulus, heights, delta, levels, h, inner, p, result);
}
