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

/** Deflections u = H p [length] under pressures p [force/length^2] of any sign, at all points; both double [nx*ny], they may be one
 *  array. Periodic: the mean pressure deflects nothing, so the mean of u is 0. u is written if the status is RC_OK.
 *  Errors: ARGUMENT, MEMORY, EXTERNAL, NUMERIC (a deflection is not finite), BUSY. */
RC_API rc_status rc_product_apply(rc_product *product, rc_const_array p, rc_array u);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
