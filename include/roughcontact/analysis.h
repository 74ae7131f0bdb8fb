/* roughcontact: analysis of a contact: area, connected patches, distribution of pressure, percolation, conductance. */
#ifndef ROUGHCONTACT_ANALYSIS_H
#define ROUGHCONTACT_ANALYSIS_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Area and perimeter of a contact, by rc_area_measure. The library writes every member. */
typedef struct rc_area {
  size_t struct_size;
  int64_t contacts;     /* points with p > 0                                                                         */
  double area;          /* contacts hx hy [length^2]                                                                 */
  double perimeter;     /* edges between a cell in contact and one that is not [length]; outside of a free grid
                           and where the mask is 0 nothing is in contact                                             */
  double corrected_area; /* area less what the cells at its border add, see rc_area_measure [length^2]               */
} rc_area;
#define RC_AREA_INIT RC_BEGIN(rc_area)

/** Connected parts of a contact, by rc_patches_find. The caller sets neighbours, room and the arrays, each of which may
 *  be none. Patches are numbered from 0 by their lowest point number, whatever their size. */
typedef struct rc_patches {
  size_t struct_size;
  int32_t neighbours;   /* 4: points are connected across edges; 8: across corners as well                           */
  int32_t reserved;     /* 0                                                                                         */
  int64_t room;         /* length of the arrays from `cells` to `peak`: the first `room` patches are written         */
  rc_array label;       /* out, int64_t [nx*ny]: number of the patch; -1: no contact                                 */
  rc_array cells;       /* out, int64_t: points of the patch                                                         */
  rc_array area;        /* out, double: cells hx hy [length^2]                                                       */
  rc_array perimeter;   /* out, double [length], as rc_area.perimeter                                                */
  rc_array load;        /* out, double: hx hy sum(p) [force]                                                         */
  rc_array mean_pressure; /* out, double: load / area [force/length^2]                                               */
  rc_array max_pressure; /* out, double [force/length^2]                                                             */
  rc_array peak;        /* out, int64_t: the point with max_pressure, of equal ones the first                        */
  int64_t count;        /* out: patches, also those beyond room                                                      */
} rc_patches;
#define RC_PATCHES_INIT RC_BEGIN_WITH(rc_patches, neighbours = 4)

/** Distribution of pressure over the points in contact, by rc_histogram_fill. The caller sets bins, upper and the
 *  arrays, each of which may be none. Bin k holds the pressures k width < p <= (k + 1) width, to round-off. */
typedef struct rc_histogram {
  size_t struct_size;
  int64_t bins;         /* 1 .. 2^40                                                                                 */
  double upper;         /* end of the last bin [force/length^2]; 0: the largest pressure                             */
  rc_array counts;      /* out, int64_t [bins] points; their sum and `above` are `contacts`                          */
  rc_array density;     /* out, double [bins]: share of the contact per pressure: counts / (contacts width)
                           [length^2/force]; width sum(density) + above / contacts = 1. Times contacts / (nx*ny):
                           share of all points. 0 without contact                                                    */
  double width;         /* out, of a bin [force/length^2]: edges are at k width, k = 0 .. bins                       */
  int64_t contacts;     /* out: points with p > 0                                                                    */
  int64_t above;        /* out: points with p > upper                                                                */
  double mean_pressure; /* out, of the points in contact [force/length^2]; 0 without contact                         */
  double max_pressure;  /* out [force/length^2]                                                                      */
} rc_histogram;
#define RC_HISTOGRAM_INIT RC_BEGIN(rc_histogram)

/* The axes that rc_crossing_find reports; X + Y: both axes.                        */
enum { RC_CROSSES_NONE = 0, RC_CROSSES_X = 1, RC_CROSSES_Y = 2 };

/** @defgroup analysis Analysis: area, patches, histogram, percolation
 *  Functions of pressures, the caller's or a result's, without handles; any thread. Of the system they use nx, ny, hx, hy and the
 *  boundary: RC_BOUNDARY_PERIODIC joins opposite sides of the grid, _X and _Y those of their axis. For DENSE and CALLBACK
 *  the points are taken as a free grid of nx by ny. p, double [nx*ny]: >= 0; a point is in contact where p > 0. mask, uint8_t
 *  [nx*ny]: 0: not in contact, its p is ignored (it may be NaN); none: all points. Nothing is written by a call that fails. The
 *  same bits in every run.
 *  Errors: ARGUMENT (null, NaN or negative p, the struct's own limits), SHAPE (nx, ny), MEMORY.
 *  @{ */
/** Area, perimeter, and the area corrected for the grid: cells that touch in part carry pressure as well, so that the area of a
 *  solved contact is too large by about (pi - 1 + ln 2)/24 = 0.118 cells for every edge of its border (Yastrebov, Anciaux &
 *  Molinari, Tribology International 114 (2017) 161; an edge counts with the pitch across it, which makes hx hy of each). Edges
 *  at the border of a free grid and of the mask are left out: there the body ends, not the contact.
 *  The corrected area is between 0.527 and 1 times the area. It is meaningful if patches are several cells wide, not for
 *  single cells (0.527 cells each) or a checkerboard, and cells that were chosen by their centres need no correction. */
RC_API rc_status rc_area_measure(const rc_system *system, rc_const_array p, rc_const_array mask, rc_area *out);
/** Connected parts of the contact, in time proportional to the points. Memory: 40 bytes for each row of neighbouring cells in
 *  contact, and 56 for each patch. */
RC_API rc_status rc_patches_find(const rc_system *system, rc_const_array p, rc_const_array mask, rc_patches *out);
/** Pressure histogram. Sums to 1 with `above`, see rc_histogram. */
RC_API rc_status rc_histogram_fill(const rc_system *system, rc_const_array p, rc_const_array mask, rc_histogram *out);
/** Percolation, as sums of RC_CROSSES_*: of the contact, and of the gap, the points without contact, where a fluid can flow. A
 *  connected part crosses along an axis if it touches both sides of the grid at the ends of this axis. They are never joined,
 *  whatever the boundary: they are the inlet and the outlet of a seal. The other two sides are joined if the boundary repeats along
 *  the other axis, so a channel may leave at one and come back at the other. Points are connected across edges; a masked point is
 *  neither contact nor gap. Memory: 32 bytes for each row of neighbouring cells in contact, or of those without.
 *  Both numbers are written. */
RC_API rc_status rc_crossing_find(const rc_system *system, rc_const_array p, rc_const_array mask, int32_t *contact, int32_t *gap);
/** Electrical or thermal conductance of the contact between two half-spaces: 2 / (E* (rho1 + rho2)) dW/dd (Barber, Proc. R. Soc.
 *  Lond. A 459 (2003) 53). For a circular spot that is Holm's 4 radius / (rho1 + rho2). system: HALFSPACE, its modulus counts.
 *  result: of a step with option stiffness = 1 or 2, and with rc_result.homogeneous = 1: the relation holds for homogeneous
 *  half-spaces, not for a layer, where heat and elastic deflection spread differently. Points at the hardness conduct but add no
 *  stiffness: with such points the value is too small, see rc_result.capped. rho1, rho2 >= 0, not both 0:
 *  resistivities of the bodies, or reciprocals of their thermal conductivities. Units: dW/dd / E* is a length, so ohm m give
 *  1/ohm, and m K/W give W/K. *conductance: infinite in full periodic contact, because nothing constricts the flow. *lower,
 *  *upper (NULL: not wanted): the exact conductance lies between them; NaN where the result proves no interval. Errors:
 *  ARGUMENT. */
RC_API rc_status rc_conductance(const rc_system *system, const rc_result *result, double rho1, double rho2, double *conductance,
                                double *lower, double *upper);
/** @} */

/** @defgroup punch Flat punch on given points  @{ */
/** dW/dd of a rigid flat punch that touches exactly the points where mask, uint8_t [nx*ny], is not 0 (none: all): hx hy times the
 *  sum of the pressures x with H x = 1 on these points, which may pull; a hardness does not count. Any operator, boundary, kernel.
 *  A contact whose points below the hardness are these has this rc_result.stiffness, and it grows with the set. *stiffness
 *  [force/length]: to option tol of its value or closer, see rc_result.stiffness; 0 without points. Periodic: infinite for all
 *  points, finite for fewer. *lower, *upper (NULL: not wanted): the exact one lies between them; NaN where no bound of H's
 *  eigenvalues is known. options may be NULL; those of products and operators, tol, threads and time_limit are used. Status:
 *  RC_STOP_STALLED: written, round-off may keep a larger error, which the interval counts. RC_STOP_TIME: nothing is written.
 *  Errors: as rc_contact_create. */
RC_API rc_status rc_punch_stiffness(const rc_system *system, rc_const_array mask, const rc_options *options, double *stiffness,
                                    double *lower, double *upper);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
