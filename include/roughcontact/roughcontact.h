/* roughcontact: certified normal contact of rough surfaces on an elastic half-space.
 *
 * The problem (Bemporad & Paggi 2015, Problem 1): find pressures p on a grid of cells such that
 *     p >= 0,   g = H p + h - d >= 0,   p_i g_i = 0 for every point i,
 * where h is the undeformed gap, d the approach (far-field displacement), H the influence matrix
 * (displacement at point i for unit pressure on cell j) and g the deformed gap. Either d is prescribed
 * (displacement control) or the normal force W = hx hy sum(p) is (load control, d is then found).
 *
 * Conventions
 *   pressure        force / length^2                   approach, gap    length
 *   contact modulus E* = 1/((1-nu1^2)/E1 + (1-nu2^2)/E2), force / length^2
 *   arrays          n = nx*ny values, point (ix, iy) at index iy*nx + ix (x fastest)
 *   any consistent set of units: answers do not depend on which
 *
 * Every function that can fail returns an rc_status: 0 (RC_OK) is a *certified* solution, positive values are
 * usable but not certified answers, negative values are failed calls. The text of the last failure in the
 * calling thread is rc_last_error(). The library never prints, exits, aborts, throws across this interface or
 * installs a signal handler. The caller owns every array; the library keeps none beyond what is stated.
 *
 * fork(): after a call only contacts with option threads above 1 keep threads, and OpenBLAS where it serves the backend cholmod
 * (docs/errors.md). A child may make contacts of its own; it must not use its parent's. It must not use the library at all if
 * another thread of the parent was inside it at the fork. Programs linked with -static have no plugins.
 *
 * Sized structs: set struct_size to sizeof(the struct) (the RC_..._INIT macros and rc_..._init functions do).
 * A smaller struct from an older header is accepted, a larger one from a newer header if the part unknown to
 * the library is all zero; else RC_ERR_ARGUMENT. This holds for structs that are written, too.
 */
#ifndef ROUGHCONTACT_H
#define ROUGHCONTACT_H

#include <stddef.h>
#include <stdint.h>

#define RC_VERSION_MAJOR 0
#define RC_VERSION_MINOR 1
#define RC_VERSION_PATCH 0
#define RC_ABI 0 /* the number in the SONAME; changes only with an incompatible change */

#ifndef RC_API
#if defined(_WIN32)
#define RC_API
#elif defined(__GNUC__)
#define RC_API __attribute__((visibility("default")))
#else
#define RC_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup status Status
 *  0 certified, > 0 usable but not certified (the result is written), < 0 the call failed.
 *  @{ */
typedef int32_t rc_status;
enum {
  RC_OK = 0,               /* certified: every kkt_* residual is <= rc_result.tolerance                     */
  RC_WITHIN_GOAL = 100,      /* option accuracy is met, by the library's estimate, without a solve of the whole grid:
                              a coarser grid's certified answer, corrected on it; see rc_result.model_nx     */
  RC_STOP_MAX_ITER = 101,    /* max_iter reached before the tolerance                                          */
  RC_STOP_TIME = 102,        /* time_limit reached                                                             */
  RC_STOP_CANCELLED = 103,   /* the progress callback or rc_contact_cancel asked to stop                       */
  RC_STOP_STALLED = 104,     /* no further progress is possible in double precision                            */
  RC_UNCERTIFIED = 105, /* the solver claimed success, the library's own check disagrees                  */
  RC_ERR_ARGUMENT = -1,    /* a null pointer, NaN, a value out of range, a bad struct_size                   */
  RC_ERR_SHAPE = -2,       /* array shape: nx, ny, dense_ld, or nx*ny too large                              */
  RC_ERR_OPTION = -3,      /* unknown option key, wrong type, value out of range                             */
  RC_ERR_NO_BACKEND = -4,  /* no backend of that name, or none that can do this                              */
  RC_ERR_NO_SOLVER = -5,   /* no solver of that name                                                         */
  RC_ERR_INCOMPATIBLE = -6, /* solver, backend, kernel, boundary and control do not go together              */
  RC_ERR_PLUGIN = -7,      /* a plugin was found but is refused (permissions, version, contents)             */
  RC_ERR_MEMORY = -8,      /* out of memory, or a request that cannot fit                                    */
  RC_ERR_INFEASIBLE = -9,  /* no solution exists: negative load, periodic approach beyond the mean plane     */
  RC_ERR_NUMERIC = -10,    /* the operator is not positive definite or returned NaN                          */
  RC_ERR_EXTERNAL = -11,   /* the caller's apply callback reported failure                                   */
  RC_ERR_BUSY = -12,       /* this contact is being used by another thread                                   */
  RC_ERR_INTERNAL = -99    /* a defect in the library or a plugin                                            */
};
/** @} */

enum { RC_OPERATOR_HALFSPACE = 1, RC_OPERATOR_DENSE = 2, RC_OPERATOR_CALLBACK = 3 };
enum { RC_BOUNDARY_FREE = 1, RC_BOUNDARY_PERIODIC = 2 };
enum { RC_CONTROL_DISPLACEMENT = 1, RC_CONTROL_LOAD = 2 };

typedef struct rc_context rc_context; /* registry of solvers, backends and kernels. Any thread.               */
typedef struct rc_options rc_options; /* checked key/value set. One thread at a time.                         */
typedef struct rc_contact rc_contact; /* operator, plans, factors and last pressures. One thread at a time.   */

/** What stays fixed over a loading sequence. Copied; `dense` and `user` must outlive the contact. */
typedef struct rc_system {
  size_t struct_size;  /* sizeof(rc_system)                                                                 */
  int32_t op;          /* RC_OPERATOR_*                                                                     */
  int32_t boundary;    /* RC_BOUNDARY_*; HALFSPACE only                                                     */
  int64_t nx, ny;      /* points along x and y, >= 1; DENSE and CALLBACK: n = nx*ny unknowns                */
  double hx, hy;       /* cell size along x and y [length], > 0; DENSE and CALLBACK: hx*hy is the cell area */
  double modulus;      /* contact modulus E* [force/length^2], > 0; HALFSPACE only                          */
  const double *dense; /* DENSE: symmetric positive definite n x n, row stride dense_ld
                          [length per (force/length^2)]; referenced, not copied                             */
  int64_t dense_ld;    /* DENSE: >= n                                                                       */
  int32_t (*apply)(const double *x, double *y, int64_t n, void *user); /* CALLBACK: y = H x, symmetric positive
                          definite; return nonzero to fail; must return: no exception, no longjmp; called on the solving thread */
  void *user;          /* handed to apply                                                                   */
} rc_system;
#define RC_SYSTEM_INIT \
  { sizeof(rc_system), RC_OPERATOR_HALFSPACE, RC_BOUNDARY_FREE, 1, 1, 1.0, 1.0, 1.0, NULL, 0, NULL, NULL }

/** What changes from step to step. Nothing in it is kept after the call except a copy of undeformed_gap and mask, or with borrow
 *  the two pointers. */
typedef struct rc_step {
  size_t struct_size;  /* sizeof(rc_step)                                                                   */
  int32_t control;     /* RC_CONTROL_*                                                                      */
  int32_t warm_start;  /* 1: start from this contact's last pressures (default); 0: start cold (factors that a
                          backend keeps still serve: equal to round-off, after rc_contact_reset bitwise)    */
  double target;       /* DISPLACEMENT: approach d [length]; LOAD: normal force W [force], >= 0             */
  const double *undeformed_gap; /* [n] undeformed gap h [length]; NULL: as in the previous step                      */
  const double *p0;    /* [n] explicit start [force/length^2], negative values are taken as 0; NULL: none   */
  const uint8_t *mask; /* [n] 0: this point carries no pressure and its gap is ignored (it may be NaN);
                          NULL with undeformed_gap given: all points; NULL without undeformed_gap: as in the previous step        */
  int32_t borrow;      /* 1: undeformed_gap and mask are not copied; they stay as they are until a step that brings other
                          arrays has returned, or the contact is reset or destroyed. 0: copied (default)    */
  int32_t reserved;    /* 0                                                                                 */
} rc_step;
#define RC_STEP_INIT \
  { sizeof(rc_step), RC_CONTROL_DISPLACEMENT, 1, 0.0, NULL, NULL, NULL, 0, 0 }

/** Answer of one step. The caller sets struct_size, p and gap; the library writes the rest whenever the
 *  returned status is >= 0, and leaves p and gap untouched when it is < 0. */
typedef struct rc_result {
  size_t struct_size;  /* sizeof(rc_result)                                                                 */
  double *p;           /* [n] pressures [force/length^2]; NULL: not wanted                                  */
  double *gap;         /* [n] deformed gap g = H p + h - d [length]; NULL: not wanted                       */
  rc_status status;    /* as returned                                                                       */
  int32_t reserved;    /* 0                                                                                 */
  int64_t iterations;  /* of the solver, all rounds together                                                */
  int64_t applications; /* products with H, the certificate's and the stiffness' included                   */
  int64_t points;      /* n, as given                                                                       */
  int64_t candidates;  /* points that can carry pressure at this approach (gap < d; all points where H has
                          negative entries: periodic boundaries, some caller's matrices, callbacks)         */
  int64_t modelled;    /* unknowns or transform points of the operator used: the bounding box of the
                          candidates for matrix-free backends, the candidates themselves for dense ones     */
  int64_t contacts;    /* points with p > 0                                                                 */
  double load;         /* hx hy sum(p) [force]                                                              */
  double approach; /* approach d [length]                                                               */
  double mean_pressure; /* load / (n hx hy) [force/length^2]                                                */
  double contact_area; /* contacts hx hy [length^2]                                                         */
  double energy;       /* (1/2 p'Hp - (d - h)'p) hx hy [force length], the functional that is minimised      */
  double stiffness;    /* dW/dd of the contact set [force/length], to about tol / 100 of its value; infinite in full
                          periodic contact; NaN unless option stiffness is 1                                */
  double kkt_primal;   /* max(0, -min p) / max|p|                                                           */
  double kkt_dual;     /* max(0, -min g) / s over all points, s = max(d - h). Periodic: under load control s is at
                          least a quarter of the mean pressure times sqrt(hx hy) / E*; under displacement control
                          without excluded points at most (mean(h) - d) / (2 tolerance)                     */
  double kkt_complementarity; /* max over all points of min(p / max p, |g| / s)                             */
  double kkt_control;  /* |load - W| / W, 0 in displacement control                                         */
  double seconds;      /* solving and certifying                                                            */
  double setup_seconds; /* influence coefficients, plans and factors built in this call                     */
  char solver[32];     /* what "auto" resolved to                                                           */
  char backend[32];
  char kernel[32];
  char note[160];      /* what may be a blunder in units or heights, an unbounded interval, operations the core
                          had to substitute and remarks of the solver, whole remarks only; "" if none       */
  double duality_gap;  /* energy - least energy is at most this [force length], see docs/certificate.md;
                          this and the bounds below: NaN (counts: -1) where no proof is known, option bounds is
                          0 or accuracy is set. Full periodic contact: NaN, and intervals that exclude nothing */
  double load_lower, load_upper; /* the exact load at this approach lies between [force]                    */
  double area_lower, area_upper; /* and the exact contact area [length^2]                                   */
  int64_t proven_contacts; /* points proven to be in contact                                                */
  int64_t proven_open;     /* points proven to be out of contact                                            */
  int64_t undecided;       /* the other points                                                              */
  int64_t levels;      /* coarse solutions kept, see rc_contact_level                                       */
  double tolerance;    /* the kkt_* residuals were held to: tol, or accuracy/100 (area: /1000) if larger    */
  int64_t model_nx, model_ny; /* points of the grid that was solved: nx and ny, or with RC_WITHIN_GOAL those of a
                          coarser one whose cells are the means over blocks of 2^k by 2^k points. Then p is its answer
                          after a few steps of a solve of the whole grid, p >= 0. Under load control p is scaled to the load
                          asked for, and approach is an estimate: the approach at which the mean of the gap, weighted
                          by p, vanishes. All else is computed from p on the whole grid. So are the kkt_* residuals, which
                          then exceed the tolerance. Stiffness, solver, backend and tolerance are the coarser grid's.
                          A stop among coarser grids gives the last that was solved: all points of a block have its
                          pressure (so that the load is kept where a block is cut by the grid's end or the mask) and its
                          gap (infinite: all masked); contacts, area, load are those of p, the rest the coarser grid's */
  double error_estimate; /* with accuracy: estimated relative error of what it is of, against the answer on the
                          whole grid; 0 on it; NaN without accuracy, and where a coarser grid was stopped at    */
  double left_out;     /* rms of gap less its block's mean, over the points in contact [length]; 0 on the whole grid */
  double area_estimate; /* as error_estimate, of contact_area; a goal of the load does not bound it */
} rc_result;

/** A solution on a coarser grid that a multilevel solver left behind. The caller sets struct_size and p. */
typedef struct rc_level {
  size_t struct_size;
  double *p;            /* [nx*ny] pressures [force/length^2]; NULL: not wanted. Ask for nx and ny first       */
  rc_status status;     /* of this solution on its grid                                                        */
  int32_t reserved;
  int64_t nx, ny;
  double hx, hy;        /* cell size [length]                                                                  */
  double approach;  /* approach on this grid [length]                                                      */
  double load;          /* [force]                                                                             */
  int64_t candidates;   /* points that were allowed pressure                                                   */
  int64_t contacts;     /* points with p > 0                                                                   */
} rc_level;

/** Where a loading history stands, for rc_contact_restore: what rc_result gave for its last two steps with RC_OK or
 *  RC_WITHIN_GOAL. All of it is copied. */
typedef struct rc_state {
  size_t struct_size;
  const double *undeformed_gap; /* [n] undeformed gap of the last step [length]                                        */
  const uint8_t *mask;  /* [n] its mask; NULL: all points                                                      */
  const double *p;      /* [n] its pressures [force/length^2]; NULL: there was no such step                    */
  double approach;  /* its approach, rc_result.approach [length]                                       */
  double load;          /* rc_result.load [force]                                                              */
  const double *p_before; /* [n] likewise of the step before it; NULL: none, or its gap or mask was another    */
  double approach_before, load_before;
} rc_state;
#define RC_STATE_INIT \
  { sizeof(rc_state), NULL, NULL, NULL, 0.0, 0.0, NULL, 0.0, 0.0 }

/** Called after each completed step 0 .. n-1 of a path, on the solving thread, with pressures and gap that last until
 *  it returns. May call only rc_contact_cancel. Return nonzero to end the path. Must return: no exception, no longjmp. */
typedef int32_t (*rc_path_fn)(int64_t step, const rc_result *result, void *user);

/** A loading history: increasing, decreasing or mixed. Arrays of length n; output arrays may be NULL. */
typedef struct rc_path {
  size_t struct_size;
  int32_t control;      /* RC_CONTROL_*                                                                        */
  int32_t warm_start;   /* 1: each step starts from the pressures of the one before, projected onto the points
                           that the new approach can reach (default); 0: each step starts cold                 */
  int64_t n;            /* steps                                                                               */
  const double *targets; /* approaches [length] or loads [force]                                               */
  const double *undeformed_gap; /* as rc_step.undeformed_gap, for all steps                                                       */
  const uint8_t *mask;  /* as rc_step.mask                                                                     */
  double *load;         /* out [force]                                                                         */
  double *approach; /* out, approach [length]                                                              */
  double *contact_area; /* out [length^2]                                                                      */
  double *stiffness;    /* out, dW/dd [force/length]; if not NULL it is computed, whatever option stiffness is */
  double *certificate;  /* out, the largest kkt_* residual                                                     */
  int64_t *applications; /* out, products with H                                                               */
  rc_path_fn fn;        /* sees each completed step's result with pressures and gap; NULL: none                */
  void *user;           /* handed to fn                                                                        */
  int64_t completed;    /* out: steps whose outputs are written; certified, or within goal                      */
} rc_path;
#define RC_PATH_INIT \
  { sizeof(rc_path), RC_CONTROL_DISPLACEMENT, 1, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0 }

/** Called after each step with status >= 0, on the thread that solves it, with pressures and gap that last until it returns.
 *  The steps of one contact come in order; those of different contacts in any order and, with several threads, at the same
 *  time. Return nonzero to end the batch: fn is then not called for further steps. Must return: no exception, no longjmp. */
typedef int32_t (*rc_batch_fn)(int64_t contact, int64_t step, const rc_result *result, void *user);

enum { RC_BATCH_SHARED = -1 }; /* as a stride: one array for all contacts                                     */

/** The loading histories of many contacts on one system: surfaces of a Monte Carlo study, Gauss points of a finite element
 *  code. Values of step k of contact i are at index i*steps + k; output arrays may be NULL. */
typedef struct rc_batch {
  size_t struct_size;
  int32_t control;      /* RC_CONTROL_*                                                                        */
  int32_t warm_start;   /* as in rc_path, from a contact's second step on                                      */
  int64_t n;            /* contacts                                                                            */
  int64_t steps;        /* of each history                                                                     */
  const double *targets; /* approaches [length] or loads [force]; step k of contact i at i*target_stride + k   */
  int64_t target_stride; /* 0: steps; RC_BATCH_SHARED; else >= steps                                           */
  const double *undeformed_gap; /* as rc_step.undeformed_gap; point m of contact i at i*undeformed_gap_stride + m                            */
  int64_t undeformed_gap_stride;   /* 0: nx*ny; RC_BATCH_SHARED; else >= nx*ny                                            */
  const uint8_t *mask;  /* as rc_step.mask; point m of contact i at i*mask_stride + m; NULL: all points        */
  int64_t mask_stride;  /* as undeformed_gap_stride                                                                       */
  const double *p0;     /* [n*nx*ny] as rc_step.p0, for the first step of each contact; may be p; NULL: none   */
  double *p;            /* out [n*nx*ny] pressures of a contact's last step with status >= 0 [force/length^2];
                           untouched for a contact that has none                                               */
  double *load;         /* out [force]; this and the numbers below: NaN (counts: -1) for a step with status < 0
                           and those that were not reached                                                     */
  double *approach; /* out, approach [length]                                                              */
  double *contact_area; /* out [length^2]                                                                      */
  double *stiffness;    /* out, dW/dd [force/length]; if not NULL it is computed, whatever option stiffness is */
  double *certificate;  /* out, the largest kkt_* residual                                                     */
  rc_status *status;    /* out; the first step that is neither RC_OK nor RC_WITHIN_GOAL ends its contact, and the
                           steps after it have its status. RC_STOP_CANCELLED or RC_STOP_TIME also where the
                           batch ended before the step                                                         */
  int64_t *iterations;  /* out, of the solver                                                                  */
  int64_t *applications; /* out, products with H                                                               */
  rc_batch_fn fn;       /* sees each step's result with pressures and gap; NULL: none                          */
  void *user;           /* handed to fn                                                                        */
  int64_t written;      /* out: contacts whose outputs are written: n, or 0 if the call itself was refused     */
  int64_t certified;    /* out: contacts of which every step is certified                                      */
  int64_t first;        /* out: the contact whose status is returned; -1: none, or RC_WITHIN_GOAL              */
} rc_batch;
#define RC_BATCH_INIT                                                                                                    \
  { sizeof(rc_batch), RC_CONTROL_DISPLACEMENT, 1, 0, 0, NULL, 0, NULL, 0, NULL, 0, NULL, NULL, NULL, NULL, NULL, NULL, \
    NULL, NULL, NULL, NULL, NULL, NULL, 0, 0, -1 }

/** What a direct routine tells besides p and w. */
typedef struct rc_direct {
  size_t struct_size;
  rc_status status;     /* as returned                                                                         */
  int32_t reserved;     /* 0                                                                                   */
  int64_t iterations;   /* of the solver                                                                       */
  int64_t applications; /* products with H, the certificate's included                                         */
  int64_t contacts;     /* values p > 0                                                                        */
  double load;          /* sum of p; rc_cmr: normal force [force]                                              */
  double energy;        /* 1/2 p'Hp - u'p; rc_cmr: [force length]                                              */
  double kkt;           /* the largest kkt_* residual, see rc_result                                           */
  double duality_gap, load_lower, load_upper; /* as in rc_result                                               */
  char note[160];       /* as in rc_result                                                                     */
} rc_direct;

/** How large a contact is, by rc_area_measure. All of it is written. */
typedef struct rc_area {
  size_t struct_size;
  int64_t contacts;     /* points with p > 0                                                                   */
  double area;          /* contacts hx hy [length^2]                                                           */
  double perimeter;     /* edges between a cell in contact and one that is not [length]; outside of a free grid
                           and where the mask is 0 nothing is in contact                                       */
  double corrected_area; /* area less what the cells at its border add, see rc_area_measure [length^2]          */
} rc_area;

/** Connected parts of a contact, by rc_patches_find. The caller sets struct_size, neighbours, room and the arrays, which may be
 *  NULL. Patches are numbered from 0 by their lowest point number, whatever their size. */
typedef struct rc_patches {
  size_t struct_size;
  int32_t neighbours;   /* 4: points are connected across edges; 8: across corners as well                     */
  int32_t reserved;     /* 0                                                                                   */
  int64_t room;         /* length of the arrays from `cells` to `peak`: the first `room` patches are written   */
  int64_t *label;       /* out [nx*ny] number of the patch; -1: no contact                                     */
  int64_t *cells;       /* out, points of the patch                                                            */
  double *area;         /* out, cells hx hy [length^2]                                                         */
  double *perimeter;    /* out [length], as rc_area.perimeter                                                  */
  double *load;         /* out, hx hy sum(p) [force]                                                           */
  double *mean_pressure; /* out, load / area [force/length^2]                                                   */
  double *max_pressure; /* out [force/length^2]                                                                */
  int64_t *peak;        /* out, the point with max_pressure, of equal ones the first                           */
  int64_t count;        /* out: patches, also those beyond room                                                */
} rc_patches;
#define RC_PATCHES_INIT \
  { sizeof(rc_patches), 4, 0, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0 }

/** Distribution of pressure over the points in contact, by rc_histogram_fill. The caller sets struct_size, bins, upper and the
 *  arrays, which may be NULL. Bin k holds the pressures k width < p <= (k + 1) width, to round-off. */
typedef struct rc_histogram {
  size_t struct_size;
  int64_t bins;         /* 1 .. 2^40                                                                           */
  double upper;         /* end of the last bin [force/length^2]; 0: the largest pressure                       */
  int64_t *counts;      /* out [bins] points; their sum and `above` are `contacts`                             */
  double *density;      /* out [bins] share of the contact per pressure: counts / (contacts width)
                           [length^2/force]; width sum(density) + above / contacts = 1. Times contacts / (nx*ny):
                           share of all points. 0 without contact                                              */
  double width;         /* out, of a bin [force/length^2]: edges are at k width, k = 0 .. bins                 */
  int64_t contacts;     /* out: points with p > 0                                                              */
  int64_t above;        /* out: points with p > upper                                                          */
  double mean_pressure; /* out, of the points in contact [force/length^2]; 0 without contact                   */
  double max_pressure;  /* out [force/length^2]                                                                */
} rc_histogram;
#define RC_HISTOGRAM_INIT \
  { sizeof(rc_histogram), 0, 0.0, NULL, NULL, 0.0, 0, 0, 0.0, 0.0 }

/** Handed to the progress callback. */
typedef struct rc_progress {
  size_t struct_size;
  int64_t iteration;    /* of the solver                                                                    */
  int64_t applications; /* products with H so far                                                           */
  double kkt;           /* the solver's own estimate of its worst residual; NaN before the first            */
  double seconds;       /* since the step began                                                             */
} rc_progress;
typedef int32_t (*rc_progress_fn)(const rc_progress *, void *user); /* return nonzero to stop               */

enum { RC_LOG_INFO = 1, RC_LOG_WARNING = 2 };
typedef void (*rc_log_fn)(int32_t level, const char *message, void *user);

enum {
  RC_CONTEXT_NO_PLUGINS = 1,    /* never load code from disk                                                */
  RC_CONTEXT_NO_ENVIRONMENT = 2 /* ignore RC_PLUGIN_PATH                                                    */
};
typedef struct rc_context_config {
  size_t struct_size;
  uint32_t flags;          /* RC_CONTEXT_*                                                                  */
  uint32_t reserved;       /* 0                                                                             */
  const char *plugin_path; /* ':'-separated absolute directories, searched before RC_PLUGIN_PATH and the
                              installed one; relative ones are refused; NULL: none; copied                  */
  rc_log_fn log;           /* NULL: silent; the threads of a batch call it, too, and at the same time       */
  void *log_user;
} rc_context_config;
#define RC_CONTEXT_CONFIG_INIT \
  { sizeof(rc_context_config), 0, 0, NULL, NULL, NULL }

/** Described by rc_backend_describe, rc_solver_describe, rc_kernel_describe. Strings live as long as the context. */
typedef struct rc_component {
  size_t struct_size;
  const char *name;
  const char *summary;
  const char *license; /* of the component with what it links (SPDX); "" for kernels                        */
  const char *origin;  /* "built-in" or the file it was loaded from                                         */
} rc_component;

enum { RC_TYPE_INT = 1, RC_TYPE_REAL = 2, RC_TYPE_TEXT = 3 };
/** Schema of one option. Strings live as long as the context. */
typedef struct rc_option_spec {
  size_t struct_size;
  const char *key;
  const char *default_value; /* as text                                                                     */
  const char *choices;       /* TEXT: "a|b|c", NULL: any text                                               */
  const char *help;          /* one line                                                                    */
  int32_t type;              /* RC_TYPE_*                                                                   */
  int32_t fixed;             /* 1: cannot change after rc_contact_create                                    */
  double minimum, maximum;   /* INT and REAL, inclusive                                                     */
} rc_option_spec;

/* Keys of the core, for a compile-time check of the spelling. Keys of components are dotted ("fft.planning"). */
#define RC_OPT_SOLVER "solver"
#define RC_OPT_BACKEND "backend"
#define RC_OPT_KERNEL "kernel"
#define RC_OPT_TOL "tol"
#define RC_OPT_MAX_ITER "max_iter"
#define RC_OPT_TIME_LIMIT "time_limit"
#define RC_OPT_THREADS "threads"
#define RC_OPT_STIFFNESS "stiffness"
#define RC_OPT_ALLOW_FALLBACK "allow_fallback"
#define RC_OPT_CERTIFY_BACKEND "certify_backend"
#define RC_OPT_WARMUP "warmup"
#define RC_OPT_WARMUP_ITERATIONS "warmup.iterations"
#define RC_OPT_BOUNDS "bounds"
#define RC_OPT_DETERMINISTIC "deterministic"
#define RC_OPT_RESUMABLE "resumable"
#define RC_OPT_ACCURACY "accuracy"
#define RC_OPT_ACCURACY_OF "accuracy.of"

/** @defgroup general General  @{ */
/** Version of the library in use; any pointer may be NULL. */
RC_API void rc_version(int32_t *major, int32_t *minor, int32_t *patch, int32_t *abi);
/** "RC_ERR_SHAPE" and the like; "RC_STATUS_UNKNOWN" for other numbers; never NULL. */
RC_API const char *rc_status_name(rc_status status);
/** What a status means, one sentence; never NULL. */
RC_API const char *rc_status_text(rc_status status);
/** The calling thread's last failure or stop, as "where: what, value, limit, what to do"; "" if the last call
 *  returned RC_OK. Valid until the thread's next call of a function that returns rc_status. */
RC_API const char *rc_last_error(void);
/** Default values, as the RC_..._INIT macros. NULL is ignored. C and C++ leave struct_size out, as rc_step_init(&step):
 *  macros of the same names pass the size that the caller was compiled with, and no more is written. */
RC_API void rc_system_init(rc_system *system, size_t struct_size);
RC_API void rc_step_init(rc_step *step, size_t struct_size);
RC_API void rc_result_init(rc_result *result, size_t struct_size);
RC_API void rc_context_config_init(rc_context_config *config, size_t struct_size);
RC_API void rc_path_init(rc_path *path, size_t struct_size);
RC_API void rc_batch_init(rc_batch *batch, size_t struct_size);
RC_API void rc_state_init(rc_state *state, size_t struct_size);
RC_API void rc_level_init(rc_level *level, size_t struct_size);
RC_API void rc_direct_init(rc_direct *result, size_t struct_size);
RC_API void rc_area_init(rc_area *area, size_t struct_size);
RC_API void rc_patches_init(rc_patches *patches, size_t struct_size);
RC_API void rc_histogram_init(rc_histogram *histogram, size_t struct_size);
#define rc_system_init(system) rc_system_init((system), sizeof(rc_system))
#define rc_step_init(step) rc_step_init((step), sizeof(rc_step))
#define rc_result_init(result) rc_result_init((result), sizeof(rc_result))
#define rc_context_config_init(config) rc_context_config_init((config), sizeof(rc_context_config))
#define rc_path_init(path) rc_path_init((path), sizeof(rc_path))
#define rc_batch_init(batch) rc_batch_init((batch), sizeof(rc_batch))
#define rc_state_init(state) rc_state_init((state), sizeof(rc_state))
#define rc_level_init(level) rc_level_init((level), sizeof(rc_level))
#define rc_direct_init(result) rc_direct_init((result), sizeof(rc_direct))
#define rc_area_init(area) rc_area_init((area), sizeof(rc_area))
#define rc_patches_init(patches) rc_patches_init((patches), sizeof(rc_patches))
#define rc_histogram_init(histogram) rc_histogram_init((histogram), sizeof(rc_histogram))
/** @} */

/** @defgroup context Context: the registry  @{ */
/** A registry of its own. config may be NULL. Errors: ARGUMENT, MEMORY. The result is destroyed by the caller. */
RC_API rc_status rc_context_create(const rc_context_config *config, rc_context **out);
/** NULL is allowed. Contacts and options made from it keep what they need, and may call its log until they are
 *  destroyed. */
RC_API void rc_context_destroy(rc_context *context);
/** Components by number 0 .. count-1, sorted by name. A NULL context is the default one. The first call loads
 *  every plugin of the search path; files that are refused are reported to the context's log. */
RC_API int64_t rc_backend_count(rc_context *context);
RC_API rc_status rc_backend_describe(rc_context *context, int64_t i, rc_component *out);
RC_API int64_t rc_solver_count(rc_context *context);
RC_API rc_status rc_solver_describe(rc_context *context, int64_t i, rc_component *out);
RC_API int64_t rc_kernel_count(rc_context *context);
RC_API rc_status rc_kernel_describe(rc_context *context, int64_t i, rc_component *out);
/** RC_OK if this solver can run on this backend for this system and control; otherwise the status that
 *  rc_contact_solve would give, with the reason in rc_last_error(). options may be NULL. */
RC_API rc_status rc_pair_supported(rc_context *context, const char *solver, const char *backend, const rc_system *system,
                                   int32_t control, const rc_options *options);
/** Influence coefficients of a kernel: out[iy*nx + ix] = E* times the deflection [length] at offset
 *  (ix*hx, iy*hy) from a cell under unit pressure. Free boundaries; relative error <= 1e-12.
 *  Errors: ARGUMENT, SHAPE, OPTION (unknown kernel), INCOMPATIBLE (hx != hy where the kernel needs square cells). */
RC_API rc_status rc_kernel_coefficients(const char *kernel, double hx, double hy, int64_t nx, int64_t ny, double *out);
/** @} */

/** @defgroup options Options: keys with a declared schema, checked when set  @{ */
/** context NULL: the default context. */
RC_API rc_status rc_options_create(rc_context *context, rc_options **out);
RC_API void rc_options_destroy(rc_options *options);
/** Errors: OPTION with the nearest key, the type or the range in the message. A dotted key loads its component. */
RC_API rc_status rc_options_set_int(rc_options *options, const char *key, int64_t value);
RC_API rc_status rc_options_set_real(rc_options *options, const char *key, double value);
RC_API rc_status rc_options_set_text(rc_options *options, const char *key, const char *value);
/** Converts the text by the key's type; a point is the decimal mark in every locale. */
RC_API rc_status rc_options_parse(rc_options *options, const char *key, const char *text);
RC_API rc_status rc_options_get_int(const rc_options *options, const char *key, int64_t *out);
RC_API rc_status rc_options_get_real(const rc_options *options, const char *key, double *out);
/** *out lives until the key is next set or the options are destroyed. */
RC_API rc_status rc_options_get_text(const rc_options *options, const char *key, const char **out);
/** The schema, 0 .. count-1: the core's keys, then those of every component. */
RC_API int64_t rc_options_count(rc_context *context);
RC_API rc_status rc_options_describe(rc_context *context, int64_t i, rc_option_spec *out);
/** @} */

/** @defgroup contact Contact: one system, many steps  @{ */
/** Checks the system, the options and the names in the core's; those in options of components (cmr.inner) are
 *  looked up by the step that uses them. A caller's matrix is read and a caller's product is tried
 *  once. Operators are built by the steps that need them. options may be NULL (defaults, default context); they are
 *  copied. Errors: ARGUMENT, SHAPE, OPTION, INCOMPATIBLE, NO_BACKEND, NO_SOLVER, PLUGIN, MEMORY, NUMERIC, EXTERNAL. */
RC_API rc_status rc_contact_create(const rc_system *system, const rc_options *options, rc_contact **out);
/** Changes what may change (not keys marked fixed whose value differs: OPTION). Errors: OPTION, BUSY. */
RC_API rc_status rc_contact_set_options(rc_contact *contact, const rc_options *options);
/** Calls fn on the solving thread at least every `every` iterations (>= 1). fn NULL: none. fn may call only
 *  rc_contact_cancel, and must return: no exception and no longjmp may leave it. Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_on_progress(rc_contact *contact, rc_progress_fn fn, void *user, int64_t every);
/** Solves one step and certifies the answer. A failed or stopped step keeps the last certified pressures as
 *  the next warm start. Errors: ARGUMENT, INFEASIBLE, INCOMPATIBLE, NO_BACKEND, MEMORY, NUMERIC, EXTERNAL, BUSY. */
RC_API rc_status rc_contact_solve(rc_contact *contact, const rc_step *step, rc_result *result);
/** Certifies the pressures the caller puts in result->p (required, [n]) for this step: nothing is solved. In
 *  load control the approach is the one that fits them best. RC_OK or RC_UNCERTIFIED. */
RC_API rc_status rc_contact_certify(rc_contact *contact, const rc_step *step, rc_result *result);
/** Solves the steps of a loading history in order. A step that fails or is not certified ends the path with its
 *  status; the steps before it stay written, `completed` says how many. RC_STOP_CANCELLED if fn ended it (that step
 *  counts as completed). RC_WITHIN_GOAL: all steps are written, some with this status. Errors: as rc_contact_solve. */
RC_API rc_status rc_contact_solve_path(rc_contact *contact, rc_path *path);
/** The i-th coarse solution of the last step, 0 (coarsest) .. rc_result.levels-1. Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_level(rc_contact *contact, int64_t i, rc_level *out);
/** The contact set of the last step that was certified or within its goal, without arrays over all points: *n = how many
 *  points carry pressure (0: none, or no such step); the first `room` of them, point numbers iy*nx + ix in ascending order
 *  and pressures [force/length^2], into index and p [room], either of which may be NULL. Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_points(rc_contact *contact, int64_t room, int64_t *index, double *p, int64_t *n);
/** Why "auto" chose what it did in the last step on the given grid: a line for each solver and backend with the seconds and
 *  bytes that they say they need, or the reason why they cannot. *out: "" where no step has needed a solver; lives until the
 *  contact is next used or destroyed. Errors: ARGUMENT, MEMORY, BUSY. */
RC_API rc_status rc_contact_explain(rc_contact *contact, const char **out);
/** Forgets undeformed_gap, mask, last pressures and factors; keeps plans and tables of transforms. Errors: BUSY. */
RC_API rc_status rc_contact_reset(rc_contact *contact);
/** Puts the contact, a new one or one that has solved steps, where another one of the same system and options was after a
 *  certified step: the next steps start from the same pressures and approaches. With option resumable = 1, in the contact that
 *  solved and in this one, they give the same bits, for every solver and backend; without it to round-off, since operators may
 *  remember more. A call that fails changes nothing. Errors: ARGUMENT, MEMORY, BUSY. */
RC_API rc_status rc_contact_restore(rc_contact *contact, const rc_state *state);
/** Stops the running solve soon, or the next one if none runs. Any thread, or a signal handler. NULL ignored. */
RC_API void rc_contact_cancel(rc_contact *contact);
RC_API void rc_contact_destroy(rc_contact *contact);
/** One shot: create, solve, destroy. options may be NULL. */
RC_API rc_status rc_solve(const rc_system *system, const rc_step *step, const rc_options *options, rc_result *result);
/** @} */

/** @defgroup batch Batch: many contacts in one call  @{ */
/** Solves the history of every contact, each as by an rc_contact of its own and rc_contact_solve_path: the same bits, whatever
 *  the number of threads. Option threads: contacts that are solved at the same time, each by one thread; where the system
 *  refuses threads, fewer. Option time_limit: seconds for the whole batch. options may be NULL. A CALLBACK system's apply is
 *  called from several threads at the same time. All threads have ended when the call returns.
 *  A contact that fails does not stop the others. RC_OK: every step of every contact is certified. Otherwise the status of the
 *  first contact that failed (< 0) or, if none did, of the first that is not certified (> 0), and rc_last_error() says how many
 *  contacts ended with which status. RC_WITHIN_GOAL: some steps ended so, all others are certified. All outputs are then
 *  written (rc_batch.written is n). RC_STOP_CANCELLED if fn ended the batch and no contact failed: what was finished stays.
 *  Errors: as rc_contact_create and rc_contact_solve; ARGUMENT and SHAPE for the batch itself, with written = 0. */
RC_API rc_status rc_batch_solve(const rc_system *system, const rc_options *options, rc_batch *batch);
/** @} */

/** @defgroup direct Direct routines: one call, plain arguments, no handles
 *  Minimise 1/2 p'Hp - u'p over p >= 0 for the caller's symmetric positive definite n x n matrix H (row stride ld >= n):
 *  the method of that name, certified like every answer. p [n]: start in, solution out (zeros are a good start);
 *  w [n]: out, Hp - u, or NULL. With influence coefficients per force p are forces. tol: largest residual relative to
 *  max(u), 1e-16 .. 0.1. result may be NULL. p and w are written whenever the status is >= 0.
 *  Errors: ARGUMENT, SHAPE, OPTION (tol or max_iter out of range), MEMORY, NUMERIC.
 *  @{ */
/** Greedy active set (Algorithm 1): for matrices on which it fails, RC_STOP_... with its uncertified answer. */
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
 *  heights: the largest touches first; delta: compression below it; levels: grids of the cascade, the given one
 *  included; h: radius of influence in coarse cells, >= 1; inner: solver on every level, NULL: chosen by the core;
 *  p [nx*ny]: pressures out [force/length^2]. Errors: as above, and NO_SOLVER, INCOMPATIBLE. */
RC_API rc_status rc_cmr(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double *heights, double delta,
                        int64_t levels, double h, const char *inner, double *p, rc_direct *result);
/** @} */

/** @defgroup analysis Analysis: what a contact looks like
 *  Functions of pressures alone, the caller's or a result's, without handles; any thread. Of the system nx, ny, hx, hy and the
 *  boundary count: RC_BOUNDARY_PERIODIC joins opposite sides of the grid. For DENSE and CALLBACK the points are taken as a free
 *  grid of nx by ny. p [nx*ny]: >= 0; a point is in contact where p > 0. mask [nx*ny]: 0: not in contact, its p is ignored
 *  (it may be NaN); NULL: all points. Nothing is written by a call that fails. The same bits in every run.
 *  Errors: ARGUMENT (null, NaN or negative p, the struct's own limits), SHAPE (nx, ny), MEMORY.
 *  @{ */
/** Area, perimeter, and the area corrected for the grid: cells that touch in part carry pressure as well, so that the area of a
 *  solved contact is too large by about (pi - 1 + ln 2)/24 = 0.118 cells for every edge of its border (Yastrebov, Anciaux &
 *  Molinari, Tribology International 114 (2017) 161; an edge counts with the pitch across it, which makes hx hy of each). Edges
 *  at the border of a free grid and of the mask are left out: there the body ends, not the contact.
 *  The corrected area is between 0.527 and 1 times the area. It says something where patches are several cells wide, nothing of
 *  single cells (0.527 cells each) or a checkerboard, and cells that were chosen by their centres need no correction. */
RC_API rc_status rc_area_measure(const rc_system *system, const double *p, const uint8_t *mask, rc_area *out);
/** Connected parts of the contact, in time proportional to the points. Memory: 40 bytes for each row of neighbouring cells in
 *  contact, and 56 for each patch. */
RC_API rc_status rc_patches_find(const rc_system *system, const double *p, const uint8_t *mask, rc_patches *out);
/** Pressure histogram. Sums to 1 with `above`, see rc_histogram. */
RC_API rc_status rc_histogram_fill(const rc_system *system, const double *p, const uint8_t *mask, rc_histogram *out);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
