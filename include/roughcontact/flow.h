/* roughcontact-flow: how much fluid leaks through a gap, with an interval that is proven to contain the exact flow. A separate
 * library (libroughcontact-flow), because it links CHOLMOD.
 *
 * Licence: this library's own code is BSD-3-Clause, but it links CHOLMOD, so a program that links it is subject to the GPL,
 * version 2 or later.
 *
 * The model is Reynolds' equation div(g^3/(12 viscosity) grad p) = 0 for a gap g that is constant in each cell. Two cells that
 * share an edge conduct as the halves of both in series: (width/distance) 2 a b/(a + b) with a and b their g^3. Along the flow,
 * inlet and outlet lie half a cell outside of the grid. The flow is K drop/(12 viscosity), K the conductance of this network
 * [length^3].
 *
 * The proof. Dirichlet: no potential has less energy than K. Thomson: no unit flow without sources has less dissipation than 1/K.
 * Rayleigh: K never falls when a gap grows. Whatever solves the equations, the interval is computed from a potential and from a
 * flow that is repaired until it has no sources, and rounding is counted. Gaps that are known up to an error count with it on
 * both sides. docs/development/flow.md derives this.
 *
 * Every function returns an rc_status: RC_OK, a usable one or a negative one, with the text in rc_flow_last_error(). All of them
 * are thread-safe and keep nothing; the caller owns every array. Arrays are doubles in the host's memory. Nothing is written by a
 * call that fails. Sized structs: see roughcontact.h. The same bits in every run with one BLAS.
 */
#ifndef ROUGHCONTACT_FLOW_H
#define ROUGHCONTACT_FLOW_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The calling thread's last failure or stop in this library, as "where: what, value, limit, what to do"; "" if the last call
 *  returned RC_OK. Valid until the thread's next call. */
RC_API const char* rc_flow_last_error(void);
/** As rc_stop_when, of the calling thread's calls of this library: they fail with RC_STOP_CANCELLED. One factorisation of a large
 *  grid takes seconds, in which the flag is not read. */
RC_API void rc_flow_stop_when(const int32_t* flag);

enum { RC_FLOW_X = 1, RC_FLOW_Y = 2 };
enum { RC_FLOW_CLOSED = 1, RC_FLOW_PERIODIC = 2 };

/** A flow: the gap, the fluid and what is wanted. */
typedef struct rc_flow_spec {
  size_t struct_size; /* sizeof(rc_flow_spec)                                                                       */
  int32_t along;      /* RC_FLOW_X (default) or RC_FLOW_Y: from the grid's first side across this axis to its last  */
  int32_t sides;      /* the two sides along the flow. RC_FLOW_CLOSED: walls. RC_FLOW_PERIODIC: a channel leaves at one and comes
                         back at the other. For rc_flow_of_result 0: as the boundary repeats across the flow        */
  double viscosity;   /* dynamic, of the fluid [pressure time], > 0                                                 */
  double pressure_drop; /* inlet less outlet [pressure], > 0                                                         */
  double width;         /* wanted upper - lower over upper, 1e-12 .. 1; default 0.01. The closing pressure: of its interval */
  double memory;        /* most memory for the factor [bytes]; 0: the machine's. Beyond it the equations are solved by
                           conjugate gradients with an incomplete factor                                              */
  /* The grid; ignored where a system is given */
  int64_t nx, ny;           /* cells, >= 1, together at most 2^31 - 1                                                     */
  double hx, hy;            /* cell size [length], > 0                                                                    */
  rc_const_array gap;       /* [nx*ny] g [length], >= 0 and finite; 0: closed                                             */
  rc_const_array gap_error; /* [nx*ny] the exact gap is max(0, g - error) .. g + error [length], error >= 0; so g = error = 0 is
                          proven to be closed. None: the gap is exact                                                */
  /* With a result of a contact */
  rc_const_array mask; /* [n] uint8_t, as the step's: excluded points are closed, because their gap is unknown. None: all   */
  double load;         /* > 0: the load that the step prescribed. The interval then holds at this load, whose exact approach
                          differs a little from the returned one. 0: it holds at the returned approach               */
  rc_array potential;  /* out [nx*ny] the fluid's pressure above the outlet's, over the drop: 1 at the inlet, 0 at the outlet; NaN
                          where nothing flows. None: not wanted                                                      */
} rc_flow_spec;
#define RC_FLOW_SPEC_INIT RC_BEGIN_WITH_TWO(rc_flow_spec, along = RC_FLOW_X, width = 0.01)

/** The answer. The library writes every member. */
typedef struct rc_flow_result {
  size_t struct_size;
  rc_status status;   /* as returned                                                                                */
  int32_t crosses;    /* 1: the gap, without its error, connects inlet and outlet; rc_crossing_find says it of both axes */
  int32_t iterations; /* of conjugate gradients; 0: by the factor                                                   */
  int32_t reserved;
  double flow;         /* [length^3/time], computed from the gap without its error                                   */
  double lower, upper; /* the exact flow lies between these; both 0: closed, proven                                  */
  double constriction; /* the lowest gap on the best path: the largest u for which cells of at least u connect inlet and outlet
                          [length]; 0 if nothing flows                                                               */
  int64_t constriction_x, constriction_y; /* its cell; -1 if nothing flows                                           */
  double gap_error; /* the largest error of the gap that was counted [length]                                     */
  double dropped;   /* share of the cells that the lower bound takes for closed though the gap is above 0 there   */
  double seconds;
} rc_flow_result;
#define RC_FLOW_RESULT_INIT RC_BEGIN_WITH(rc_flow_result, status = RC_ERR_ARGUMENT)

/** @defgroup flow Flow  @{ */
/** The flow through the gap of the spec. RC_OK: the interval is as narrow as wanted. RC_STOP_STALLED: it is wider, because the
 * gap's error or round-off does not allow more; all is written. Errors: ARGUMENT (NaN, negative or infinite gaps: how many and
 * where the first is), SHAPE, MEMORY. */
RC_API rc_status rc_flow_solve(const rc_flow_spec* spec, rc_flow_result* out);
/** The flow through the gap of a contact, whose step gave result, with p and gap as doubles in the host's memory. The gap's error
 * is result->gap_error, with spec->load it follows from result->duality_gap, see docs/development/flow.md; where these are NaN, the
 * interval is 0 to infinity. Closed: points proven in contact, those at the hardness among them, and excluded points. system:
 * HALFSPACE or DENSE. options: the contact's, for the product by which spec->load finds the largest deflection under a unit
 * pressure; may be NULL. The interval does not count errors of backends beyond 2e-11 of the approach. With spec->load the system
 * must have no hardness. Errors: as rc_flow_solve; INCOMPATIBLE and those of rc_product_create. */
RC_API rc_status rc_flow_of_result(const rc_system* system, const rc_options* options, const rc_result* result,
                                   const rc_flow_spec* spec, rc_flow_result* out);
/** @} */

/** Conductances of a cell that repeats along both axes, per pressure gradient. The mean flow is
 *  q = -(1/(12 viscosity)) (xx xy; xy yy) grad p [length^2/time]. Divided by the cube of the mean gap these are the pressure flow
 *  factors of mixed lubrication (Patir & Cheng 1978; the tensor: Elrod 1979). */
typedef struct rc_flow_factors {
  size_t struct_size;
  rc_status status; /* as returned                                                                                */
  int32_t reserved;
  double xx, xy, yy; /* [length^3]                                                                                 */
  double xx_lower, xx_upper, xy_lower, xy_upper, yy_lower, yy_upper; /* the exact ones lie between these             */
  double mean_gap; /* of all cells, the closed ones count as 0 [length]                                          */
  double seconds;
} rc_flow_factors;
#define RC_FLOW_FACTORS_INIT RC_BEGIN_WITH(rc_flow_factors, status = RC_ERR_ARGUMENT)

/** The tensor of the spec's gap; along, sides, viscosity, pressure_drop, load and potential are not read. RC_OK: xx and yy are as
 *  narrow as wanted; RC_STOP_STALLED: wider. Errors: as rc_flow_solve. */
RC_API rc_status rc_flow_factors_find(const rc_flow_spec* spec, rc_flow_factors* out);

/** The pressure at which a seal closes. */
typedef struct rc_flow_closing {
  size_t struct_size;
  rc_status status;    /* as returned                                                                                */
  int32_t steps;       /* of the contact                                                                             */
  double lower, upper; /* mean pressures [pressure]: at the lower one the gap is proven to be open, at the upper one to be closed;
                          0 and 0: it is closed without a load                                                         */
  double area_fraction; /* in contact at the upper one                                                               */
  double constriction;  /* of the gap at the lower one [length]                                                       */
  double seconds;
} rc_flow_closing;
#define RC_FLOW_CLOSING_INIT RC_BEGIN_WITH(rc_flow_closing, status = RC_ERR_ARGUMENT)

/** Presses a surface, warm step after step, until the interval of the pressure at which no path through the gap is left is as
 * narrow as spec->width says, over its upper end; a finer tol of the options allows narrower ones. step: gap and mask; along and
 * sides of the spec, the rest of both is not read. With a hardness each pressure presses the surface as it is given.
 * RC_STOP_STALLED: wider, because the steps between are proven neither open nor closed. Errors: INFEASIBLE (open up to the
 * largest load, or up to modulus), INCOMPATIBLE (no bounds are proven), and those of rc_contact_create and rc_contact_solve. */
RC_API rc_status rc_flow_closing_pressure(const rc_system* system, const rc_options* options, const rc_step* step,
                                          const rc_flow_spec* spec, rc_flow_closing* out);

#ifdef __cplusplus
}
#endif
#endif
