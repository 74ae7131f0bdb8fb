/* roughcontact: derivatives of a step: of its pressures, gap, load and approach by undeformed gap, target and modulus. */
#ifndef ROUGHCONTACT_DERIVATIVES_H
#define ROUGHCONTACT_DERIVATIVES_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup derivatives Derivatives of a step
 *  The step is the last one that the contact solved, also in a history, and has returned RC_OK. Surface, mask, control and
 *  boundary are its own. Points in contact stay in contact, the others stay open, those at the hardness keep it: the equations of
 *  the points with 0 < p < hardness are solved for the change, by at most two solves on this set. The surface is the one that the
 *  step pressed, with the plastic indentation of the steps before it.
 *
 *  The answer of a step is a piecewise smooth function of its data. Where a point has p = 0 and g = 0 at once, derivatives are
 *  one-sided; those of a point with p > 0 are returned. `undecided` counts the points at which the step did not prove which of
 *  the two holds. The contact area is constant between such places and jumps there: it has no derivative.
 *
 *  Masked points have derivative 0; what is given for them is ignored (it may be NaN). System DENSE and CALLBACK have no modulus.
 *  Both calls multiply with H: rc_contact_cancel and option time_limit stop them. They leave the contact as it is, except that its
 *  operators may prepare for other points: the next step's answer is the same to round-off.
 *  Memory: a few arrays over the points in contact; for dJ_dgap, products over the points where it is not 0.
 *  Status: RC_OK: solved to a relative residual of 300 tol, but of 1e-11 at least and 1e-4 at most. RC_STOP_STALLED: written,
 *  round-off kept a larger residual; `error` counts it. Other positive values: stopped. Nothing is written by a call that fails or
 *  is stopped.
 *  Errors: ARGUMENT (the step did not return RC_OK; NaN or infinite input; load control if no point carries pressure, or if
 *  each point that does is at the hardness: the load does not determine the approach then), NUMERIC (H is not positive definite, or
 *  so badly scaled that conjugate gradients lower no residual), INCOMPATIBLE, MEMORY, EXTERNAL, BUSY.
 *  @{ */

/** Reverse mode: the derivatives of one number J that is computed from the step's answer. The caller sets how J changes with each
 *  part of the answer, and gets how it changes with each datum. If dJ_dp and dJ_dgap are none and dJ_dload and dJ_dapproach 0, J is
 *  the load in approach control, and the approach in load control. */
typedef struct rc_gradient {
  size_t struct_size;
  rc_const_array dJ_dp;  /* double [n] by the pressures; none: 0                                                     */
  rc_const_array dJ_dgap; /* double [n] by the deformed gap; none: 0                                                 */
  double dJ_dload;       /* by the load hx hy sum(p)                                                                 */
  double dJ_dapproach;   /* by the approach                                                                          */
  rc_array dJ_dundeformed_gap; /* out, double [n]; none: not wanted                                                  */
  double dJ_dtarget;     /* out: by the approach in approach control, else by the load                           */
  double dJ_dmodulus;    /* out; NaN where the system has no modulus                                                 */
  double error;          /* out: the Euclidean norm of the error that the solves leave in dJ_dundeformed_gap is at
                            most this; NaN where no bound of H's eigenvalues is known. The step's own tolerance is
                            not in it                                                                                */
  int64_t undecided;     /* out: points neither proven to be in contact nor to be open; -1: nothing is proven        */
  int64_t products;      /* out: products with H                                                                     */
} rc_gradient;
#define RC_GRADIENT_INIT RC_BEGIN(rc_gradient)

/** Forward mode: how the answer changes with given changes of the data. */
typedef struct rc_tangent {
  size_t struct_size;
  rc_const_array dundeformed_gap; /* double [n] change of the undeformed gap [length]; none: 0                       */
  double dtarget;        /* of the approach [length], or in load control of the load [force]                         */
  double dmodulus;       /* of E* [force/length^2]; must be 0 where the system has no modulus                        */
  rc_array dp;           /* out, double [n]: change of the pressures [force/length^2]; none: not wanted              */
  rc_array dgap;         /* out, double [n]: of the deformed gap [length], 0 at points in contact; none: not wanted, which
                            saves a product over all points                                                          */
  double dload;          /* out [force]                                                                              */
  double dapproach;      /* out [length]                                                                             */
  double error;          /* out: the same for dp                                                                     */
  int64_t undecided;     /* out, as in rc_gradient                                                                   */
  int64_t products;      /* out                                                                                      */
} rc_tangent;
#define RC_TANGENT_INIT RC_BEGIN(rc_tangent)

RC_API rc_status rc_contact_gradient(rc_contact *contact, rc_gradient *gradient);
RC_API rc_status rc_contact_tangent(rc_contact *contact, rc_tangent *tangent);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
