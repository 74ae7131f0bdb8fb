/* roughcontact: the contact law of a rough patch, as a table with bounds between its nodes.
 *
 * A law is the nominal pressure p of a rough patch as a function of its overclosure x, with slope, energy, contact area and
 * conductance. The patch is solved at many loads, the nodes; an evaluation solves no contact problem. A law
 * never changes: any number of threads evaluate it at the same time, without locks and without memory of their own.
 *
 * Overclosure. x = 0 is first touch of the undeformed bodies, x > 0 brings them nearer. The deflection of the half-space below the
 * patch as a whole is not in x, because the mesh of a finite element program has it already:
 *   periodic boundaries   x = approach: it is the change of the gap between the mean planes, and nothing is subtracted.
 *   others                x = change of the mean gap, or approach - load / (a given stiffness), see rc_law_spec.bulk.
 *
 * Bounds. If the contact sets of two neighbouring nodes are nested, p is convex between them: it lies above both tangents and
 * below the chord (RC_LAW_CONVEX). With a hardness the slope lies between those of two contact sets (RC_LAW_SLOPES). Otherwise p
 * is only known to rise from one node to the next (RC_LAW_MONOTONE). Bounds are widened by the intervals that are proven at the
 * nodes (rc_result.load_lower .. stiffness_upper). They hold for the discrete problem: this grid, this kernel.
 *
 * Assumption of RC_LAW_CONVEX and _SLOPES: contact sets, and sets of points at the hardness, grow with the approach. The library
 * checks it at the nodes. It also holds between them if the inverse of H has no positive entry off its diagonal and no negative
 * sum of a row. The library computes this for a matrix (RC_OPERATOR_DENSE), whose intervals are RC_LAW_MONOTONE without it; it
 * was found for the kernel love on single grids, and is not true of galerkin and spectral. For kernels nesting is assumed.
 *
 * Between the nodes p is a quadratic spline with one knot in each interval. It has the nodes' values, rises, and is inside the
 * bounds at every overclosure, to round-off. It is C1, with three exceptions, where its slope jumps:
 *   at a node near a kink of the exact curve, where a point touches or reaches the hardness: the kink is within 1e-9 of the node's
 *   overclosure, or as near as the pressures tell, p_upper - p_lower of the node and of its neighbours, added, over the jump;
 *   at both ends of an interval that no such spline fits, which gets the chord: with RC_LAW_CONVEX by as little as the slopes and
 *   pressures of the nodes are uncertain, with RC_LAW_SLOPES and _MONOTONE by any part of the slope;
 *   at and below p_lower.
 * Its energy is its exact integral.
 *
 * A law describes first loading: with a hardness, unloading is another law.
 */
#ifndef ROUGHCONTACT_LAW_H
#define ROUGHCONTACT_LAW_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rc_law rc_law; /* Immutable. Any number of threads.                                                    */

/** @defgroup law Making a law  @{ */
enum { RC_LAW_BULK_AUTO = 0, RC_LAW_BULK_NONE = 1, RC_LAW_BULK_GIVEN = 2, RC_LAW_BULK_MEAN = 3 };
enum { RC_LAW_CONVEX = 1, RC_LAW_SLOPES = 2, RC_LAW_MONOTONE = 3 };

/** The patch, and how exact its law has to be. Nothing is kept after the call. */
typedef struct rc_law_spec {
  size_t struct_size;
  rc_const_array undeformed_gap; /* double [n] h [length]; it counts from its lowest point, see rc_gap_from_heights   */
  rc_const_array mask;   /* uint8_t [n] as rc_step.mask; none: all points                                             */
  double area;           /* nominal area that p refers to [length^2], not less than that of the points; 0: nx hx ny hy */
  double p_lower, p_upper; /* the tolerances hold between these nominal pressures [force/length^2], 0 < lower < upper */
  double tolerance;      /* half the width of the bounds of p, over p: 1e-6 .. 0.1; 1e-3 unless set. p may be anywhere
                            between the bounds, so up to twice the tolerance from the exact pressure                  */
  double tolerance_conductance; /* the same for the conductance, 1e-4 .. 1: more nodes. 0: no limit (default)         */
  int32_t bulk;          /* RC_LAW_BULK_*. NONE: x = approach. GIVEN: x = approach - load / bulk_stiffness. MEAN, not for
                            periodic boundaries: x = change of the mean gap. AUTO: MEAN for other half-spaces, else NONE */
  int32_t reserved;      /* 0                                                                                         */
  double bulk_stiffness; /* GIVEN: > 0 [force/length]; else 0                                                         */
  int64_t max_nodes;     /* >= 3; 0: 10000. A law that needs more ends with RC_STOP_MAX_ITER                          */
  rc_progress_fn progress; /* called once an iteration of each node's solve, as by rc_contact_on_progress; nonzero ends the
                            call with RC_STOP_CANCELLED. NULL: none                                                   */
  void *user;            /* handed to progress                                                                        */
} rc_law_spec;
#define RC_LAW_SPEC_INIT RC_BEGIN_WITH(rc_law_spec, tolerance = 0.001)

/** Solves the nodes. options as rc_contact_create's, or NULL; tol is lowered where the tolerance of the law needs it, and
 *  stiffness, bounds and accuracy are set. RC_OK: every node is certified, and the bounds of p are within the tolerance from
 *  p_lower to p_upper. Positive statuses leave a law as well: RC_UNCERTIFIED: the tolerance is met by estimate only, since some
 *  intervals are RC_LAW_MONOTONE; RC_STOP_MAX_ITER: max_nodes; RC_STOP_STALLED: double precision does not give the tolerance.
 *  RC_STOP_CANCELLED leaves none: *out is then NULL, as after an error.
 *  Errors: as rc_contact_create and rc_contact_solve; INFEASIBLE if the patch cannot carry p_upper, or is
 *  closed at it. Any other stop or uncertified node: RC_ERR_NUMERIC. */
RC_API rc_status rc_law_create(const rc_system *system, const rc_options *options, const rc_law_spec *spec, rc_law **out);
RC_API void rc_law_destroy(rc_law *law);

/** Facts about a law. The library writes every member. */
typedef struct rc_law_info {
  size_t struct_size;
  int64_t nodes;         /* the origin included                                                                       */
  int64_t solves;        /* contact problems that were solved                                                         */
  double seconds;        /* time of rc_law_create; 0 for a law from a file                                            */
  int32_t bounds;        /* the weakest RC_LAW_* of its intervals between p_lower and p_upper                         */
  int32_t bulk;          /* RC_LAW_BULK_NONE, _GIVEN or _MEAN                                                         */
  double width;          /* largest half-width of the bounds of p, over p, between first and last node; intervals that are
                            RC_LAW_MONOTONE do not count                                                              */
  double width_conductance; /* the same of the conductance. A slope that jumps, where points touch, keeps it from 0   */
  double width_area;     /* the same of the contact area; all intervals count                                         */
  double energy_error;   /* largest difference between the integral and a node's own energy, over the latter; 0 with MEAN */
  double modulus;        /* E* of a homogeneous half-space; 0: no conductance follows from the slope, see rc_result.homogeneous */
  double hardness, area, bulk_stiffness; /* as given, an infinite hardness as 0; the area is never 0                   */
  double mean_gap;       /* mean of the undeformed gap, from its lowest point on, over points that are not masked     */
  double x_lower, x_upper, p_lower, p_upper; /* first node after the origin, and last node                            */
} rc_law_info;
#define RC_LAW_INFO_INIT RC_BEGIN(rc_law_info)
RC_API rc_status rc_law_describe(const rc_law *law, rc_law_info *out);

/** Every quantity of a law at one overclosure: rc_law_describe_node gives a node as it was solved, rc_law_evaluate any overclosure.
 *  The library writes every member. */
typedef struct rc_law_point {
  size_t struct_size;
  double x, p, p_lower, p_upper; /* overclosure [length] and nominal pressure; the exact p of the grid lies between the bounds,
                            under the assumption at the head of this file; p_upper is infinite beyond the last node   */
  double slope, slope_lower, slope_upper; /* dp/dx [force/length^3]; rc_law_evaluate: bounds as between_lower and _upper, and
                            infinite where no upper one is known                                                      */
  double energy;         /* integral of p over x, per nominal area [force/length]                                     */
  double area_fraction, area_lower, area_upper; /* contact area over nominal area; between nodes with RC_LAW_MONOTONE the bounds
                            are those of both nodes, and not proven                                                   */
  double conductance, conductance_lower, conductance_upper; /* 2 slope / E* [1/length], to be divided by rho1 + rho2; NaN if
                            rc_law_info.modulus is 0                                                                  */
  double between_lower, between_upper; /* bounds of dp/dx from the last node at or before x to the next, or beyond it */
  int32_t bounds;        /* RC_LAW_* there                                                                            */
  int32_t reserved;
} rc_law_point;
#define RC_LAW_POINT_INIT RC_BEGIN(rc_law_point)
/** Node i, 0 (the origin) .. rc_law_info.nodes - 1. Errors: ARGUMENT. */
RC_API rc_status rc_law_describe_node(const rc_law *law, int64_t i, rc_law_point *out);
/** @} */

/** @defgroup law_evaluation Evaluating a law
 *  rc_law_pressure, _overclosure, _gap_conductance and _pressures take some 10 to 30 ns, rc_law_evaluate 100. They compute in the
 *  calling thread's floating-point mode, and set rc_last_error() only if they fail. Beyond the last node p continues on the last
 *  tangent, with RC_OUTSIDE. Errors: ARGUMENT for NaN and infinity; of _pressures, numbers before it are written.
 *  @{ */
/** Pressure, slope and energy at an overclosure; all 0 for x <= 0. slope and energy may be NULL. */
RC_API rc_status rc_law_pressure(const rc_law *law, double x, double *p, double *slope, double *energy);
/** n overclosures at a time; arrays are double [n], each output may be none. RC_OUTSIDE if any is beyond the last node. */
RC_API rc_status rc_law_pressures(const rc_law *law, int64_t n, rc_const_array x, rc_array p, rc_array slope, rc_array energy);
/** The inverse: the least overclosure at which the law has a nominal pressure; infinite beyond a law that ends level. */
RC_API rc_status rc_law_overclosure(const rc_law *law, double p, double *x);
/** Electrical or thermal conductance per nominal area at a nominal pressure, 2 slope / (E* (rho1 + rho2)), as rc_conductance.
 *  Errors: ARGUMENT (also if rc_law_info.modulus is 0). */
RC_API rc_status rc_law_gap_conductance(const rc_law *law, double p, double rho1, double rho2, double *conductance);

/** Every quantity at an overclosure; for x <= 0, without contact, all members after x are 0. */
RC_API rc_status rc_law_evaluate(const rc_law *law, double x, rc_law_point *out);
/** @} */

/** @defgroup law_slip Slip
 *  The shear traction (tangential force per nominal area) of a patch that slips under friction, from its law (Ciavarella 1998,
 *  Jaeger 1998): at the overclosure x a slip s from rest gives mu (p(x) - p(x - s/(mu r))), r = (2 - nu)/(2 - 2 nu), up to mu p.
 *  Unloading and reloading follow Masing's rule; where x changes too, those of Mindlin and Deresiewicz (1953), as memory diagrams
 *  (Aleshin, Bou Matar and Van Den Abeele 2015) have them: what is pressed on while nothing slips keeps its shear.
 *
 *  Exact for nu = 0 and in two dimensions; else a model, see docs/how-to/slip.md. Both bodies are elastically similar: nu is
 *  (nu1/G1 + nu2/G2)/(1/G1 + 1/G2), and the pressure does not depend on the shear. Slip is the tangential displacement of one body
 *  against the other, without the bulk's, as x is. Refused for laws with a hardness, and without rc_law_info.modulus.
 *  @{ */
/** A patch after a step. RC_LAW_SLIP_STATE_INIT, mu and nu: before the first one. A host stores and copies it as it is. */
typedef struct rc_law_slip_state {
  size_t struct_size;
  double mu, nu;         /* in: coefficient of friction, 0 or more; Poisson's ratio, 0 .. 0.5. The same in every step */
  double p, slope;       /* nominal pressure, dp/dx                                                                   */
  double shear[2];       /* in the direction of the slip; at most mu p                                                */
  double shear_by_x[2];  /* dshear/dx [force/length^3]                                                                */
  double shear_by_slip[4]; /* dshear[i]/dslip[j] at 2 i + j, also of the step: the tangent for Newton's method        */
  double dissipated;     /* by friction, per nominal area, since the first step [force/length]                        */
  double joined;         /* by how much the shear may be off because earlier slips were joined, see rc_law_slip       */
  double memory[64];     /* of earlier slips                                                                          */
} rc_law_slip_state;
#define RC_LAW_SLIP_STATE_INIT RC_BEGIN(rc_law_slip_state)

/** A step from the state `before` to the overclosure x, with the slip slip[2]. after may be before; a host that iterates keeps
 *  before. Of a step that touches, the part of the slip after first touch counts; without contact (x <= 0) nothing is held.
 *
 *  Exact for the model: any history at constant x in one direction; steps where x grows and less slips than mu r times its growth,
 *  or where slip goes on. Approximate, of first order in the step: slip that turns back while x falls, and directions that change
 *  within a step. 12 layers of earlier slips are kept; more are joined, those that change the shear least.
 *  No solve; any thread. RC_OUTSIDE beyond the last node. Errors: ARGUMENT (NaN and infinity, mu < 0, nu, a state that no step
 *  has left, such as slip held without contact); INCOMPATIBLE (the law). after does not change then. */
RC_API rc_status rc_law_slip(const rc_law *law, const rc_law_slip_state *before, double x, const double *slip,
                             rc_law_slip_state *after);
/** Bounds of the two components of the shear in a state, if the model were exact: they follow from those of p, which rises.
 *  RC_UNCERTIFIED if slips were joined. */
RC_API rc_status rc_law_slip_bounds(const rc_law *law, const rc_law_slip_state *state, double *lower, double *upper);
/** @} */

/** @defgroup law_files Files
 *  Files are written as rc_file_write does. Only regular files of at most 4e9 bytes are read. Paths are UTF-8, or any bytes where
 *  the system allows them.
 *  @{ */
/** A text file with every bit of the law and a checksum. Errors: ARGUMENT (the file cannot be written). */
RC_API rc_status rc_law_save(const rc_law *law, const char *path);
/** Evaluates to the same bits as the law that was saved, and returns the status of its making, see rc_law_create; with a positive
 *  status there is a law as well. Errors: ARGUMENT (cannot be read, damaged, of a newer version). */
RC_API rc_status rc_law_load(const char *path, rc_law **out);

enum { RC_LAW_CSV = 1, RC_LAW_CALCULIX = 2, RC_LAW_ABAQUS = 3, RC_LAW_MOOSE = 4, RC_LAW_TABLE = 5 };
/** A table for a program without user routines. */
typedef struct rc_law_export_spec {
  size_t struct_size;
  int32_t format;        /* RC_LAW_CSV: every column. _CALCULIX, _ABAQUS: cards *SURFACE BEHAVIOR and, if rho1 + rho2 > 0,
                            *GAP CONDUCTANCE. _MOOSE: overclosure and pressure. _TABLE: the numbers that src/law/table.c
                            evaluates, in the law's own units                                                         */
  int32_t reserved;      /* 0                                                                                         */
  int64_t rows;          /* 5 .. 1000000, CalculiX: .. 200; 0: 200. _TABLE: ignored                                   */
  double rho1, rho2;     /* resistivities, or reciprocals of conductivities, in units of the deck; both 0: no conductance.
                            Refused if rc_law_info.modulus is 0                                                       */
  double length, force;  /* one unit of the law in units of the deck; 0: 1                                            */
  double beyond;         /* one more row at this many times the last overclosure, on the last tangent, because these programs
                            continue with slope 0, from which Newton's method does not return. 0: 100; 1: none. Not CSV */
  double error;          /* out: the largest distance between straight lines through the rows and the law, over p, from the
                            second row, which is the first node, on. Below it the table is the line from the origin to
                            that node: with RC_LAW_CONVEX it is above the law, near first touch by more than p itself  */
  double mu, nu;         /* friction, as in rc_law_slip_state; mu 0: none. _CSV: three columns, the stiffness at the start of
                            slip, the shear at which all slides, the slip at which that begins. _ABAQUS, _CALCULIX: *FRICTION,
                            with the elastic slip or its stiffness in the middle of the law, between p_lower and p_upper    */
} rc_law_export_spec;
#define RC_LAW_EXPORT_SPEC_INIT RC_BEGIN(rc_law_export_spec)
/** Numbers have at most 20 characters, which is what such programs read. Errors: ARGUMENT (also: in these units a number is
 *  beyond double precision; two rows would have the same overclosure; the file cannot be written). */
RC_API rc_status rc_law_export(const rc_law *law, const char *path, rc_law_export_spec *spec);
/** @} */

/** @defgroup law_names Laws by name
 *  For programs whose user routines get a name and no pointer. The names are one list for the whole process.
 *  @{ */
/** The law of that name; the first call for a name loads it from path. path NULL: the file name.law in the current folder. The
 *  law lives until the process ends: it must not be destroyed. Any thread. Statuses: as rc_law_load. */
RC_API rc_status rc_law_open(const char *name, const char *path, const rc_law **out);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
