/* roughcontact: products with the influence matrix, for programs whose own solver needs deflections: lubrication, multigrid,
 * time steps. */
#ifndef ROUGHCONTACT_PRODUCT_H
#define ROUGHCONTACT_PRODUCT_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup product Product u = H p  @{ */
/** One grid's influence matrix: its spectrum, plans, factors. One thread at a time. */
typedef struct rc_product rc_product;

/** options may be NULL; those of backends, threads and tol are used (tol: with 1e-5 and more products may be in single
 *  precision). system is copied, but not what its pointers refer to. A hardness has no effect. Errors: as rc_contact_create. */
RC_API rc_status rc_product_create(const rc_system *system, const rc_options *options, rc_product **out);
/** NULL: nothing happens. */
RC_API void rc_product_destroy(rc_product *product);

/** Deflections u = H p [length] under pressures p [force/length^2] of any sign, at all nx*ny points. Periodic: the mean pressure
 *  deflects nothing, so the mean of u is 0. The value of point (ix, iy) is at ix*p_x + iy*p_y of p and ix*u_x + iy*u_y of u:
 *  1 and nx for rows one after the other, ny and 1 for columns. p and u may be one array with the same distances. u is written
 *  if the status is RC_OK. Errors: ARGUMENT (also distances at which points of u coincide), MEMORY, EXTERNAL, NUMERIC (a
 *  deflection is not finite), BUSY. */
RC_API rc_status rc_product_apply(rc_product *product, const double *p, int64_t p_x, int64_t p_y, double *u, int64_t u_x,
                                  int64_t u_y);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
