/* roughcontact: certified normal contact of rough surfaces on an elastic half-space.
 *
 * The problem (Bemporad & Paggi 2015, Problem 1): find pressures p on a grid of cells such that
 *     p >= 0,   g = H p + h - d >= 0,   p_i g_i = 0 for every point i,
 * where h is the undeformed gap, d the approach of the bodies, H the influence matrix (displacement at point i for unit pressure
 * on cell j) and g the deformed gap. Either d is prescribed (approach control) or the normal force W = hx hy sum(p) is (load
 * control, d is then found).
 *
 * With a hardness c (rc_system.hardness) no pressure exceeds c: 0 <= p <= c, and where p = c the bodies may overlap, g <= 0. The
 * overlap -g is plastic: a certified step of a contact adds it to h for the steps that follow (see rc_contact_indentation), so
 * that unloading is elastic. A step's answer depends on the steps before it only through this gap.
 *
 * This header is what a first program needs: a system, a step, a result. Others, each with all that it needs:
 *     history.h    loading histories, batches of contacts, restarts, coarse solutions
 *     derivatives.h  gradients and tangents of a step
 *     analysis.h   area, patches, pressures and conductance of a contact
 *     law.h        contact laws: tables with bounds between their nodes
 *     product.h    u = H p for pressures of any sign
 *     direct.h     the paper's algorithms on a matrix, one call each
 *     registry.h   contexts, lists of components and options
 *     plugin.h     backends and solvers of your own
 * and those of libraries of their own: surface.h (generated surfaces, spectra), formats.h (files of surfaces), flow.h (leaks),
 * request.h (users' words), budget.h (uncertainties), mpi.h and ranks.h (contacts shared by ranks).
 *
 * Conventions
 *   pressure        force / length^2                   approach, gap    length
 *   contact modulus E* = 1/((1-nu1^2)/E1 + (1-nu2^2)/E2), force / length^2
 *   arrays          n = nx*ny values, point (ix, iy) at index iy*nx + ix (x fastest)
 *   any consistent set of units: answers do not depend on which
 *
 * Every function that can fail returns an rc_status: 0 (RC_OK) is a *certified* solution, positive values are usable but not
 * certified answers (unless the function says otherwise), negative values are failed calls. The text of the last failure in the
 * calling thread is rc_last_error(). The library never prints, exits, aborts, throws across this interface or installs a signal
 * handler. The caller owns every array; the library keeps none beyond what is stated.
 *
 * Floating point: every function computes in the default mode (no traps, rounding to nearest, subnormal numbers) and then restores
 * the calling thread's mode and exception flags. The caller's own functions (apply, progress, log) run in the default mode.
 *
 * Signals: threads that the library starts block them, so that they arrive on the host's threads. A handler may call
 * rc_contact_cancel, or set the flag of rc_stop_when.
 *
 * Cancellation: pthread_cancel ends a thread inside a call where the solver iterates, or in a progress or history function of the
 * caller's; the contact may be used again, or destroyed. The caller's functions may end their thread with pthread_exit. Both unwind
 * the thread's stack, which needs the GNU C library; elsewhere a cancelled thread ends after the call. Callers in C++ let
 * abi::__forced_unwind pass.
 *
 * fork(): after a call only contacts with option threads above 1 keep threads, and OpenBLAS if it serves the backend cholmod
 * (docs/development/errors.md). A child may make contacts of its own; it must not use its parent's. It must not use the library at
 * all if another thread of the parent was inside it at the fork. Programs linked with -static have no plugins.
 *
 * Structs: begin each with its RC_..._INIT macro, which sets struct_size. What has no sensible default is 0 there, and refused
 * until it is set. A smaller struct from an older header is accepted, a larger one from a newer header if the part unknown to the
 * library is all zero; else RC_ERR_ARGUMENT. This also holds for structs that are written.
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
#if defined(__GNUC__) && !defined(_WIN32)
#define RC_API __attribute__((visibility("default")))
#else
#define RC_API
#endif
#endif
#ifdef _WIN32
#define RC_PLUGIN_API __declspec(dllexport) /* of the one function that a plugin exports */
#else
#define RC_PLUGIN_API RC_API
#endif

/* The values of the RC_..._INIT macros: struct_size, up to two others, zeros. */
#ifdef __cplusplus
#define RC_BEGIN_WITH_TWO(Struct, first, second) \
  [] {                                           \
    Struct rc_begun{};                           \
    rc_begun.struct_size = sizeof(Struct);       \
    rc_begun.first;                              \
    rc_begun.second;                             \
    return rc_begun;                             \
  }()
#define RC_BEGIN_WITH(Struct, value) RC_BEGIN_WITH_TWO(Struct, struct_size = sizeof(Struct), value)
#define RC_BEGIN(Struct) RC_BEGIN_WITH(Struct, struct_size = sizeof(Struct))
#else
#define RC_BEGIN(Struct) \
  { .struct_size = sizeof(Struct) }
#define RC_BEGIN_WITH(Struct, value) \
  { .struct_size = sizeof(Struct), .value }
#define RC_BEGIN_WITH_TWO(Struct, first, second) \
  { .struct_size = sizeof(Struct), .first, .second }
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup status Status
 *  Three ranges: 0 certified; 100 and above usable, with what the answer lacks (the result is written); negative failed.
 *  @{ */
typedef int32_t rc_status;
enum {
  RC_OK = 0,                /* certified: every kkt_* residual is <= rc_result.tolerance                             */
  RC_WITHIN_GOAL = 100,     /* option accuracy is met, by the library's estimate, without a solve of the whole grid:
                               a coarser grid's certified answer, corrected on it; see rc_result.model_nx            */
  RC_STOP_MAX_ITER = 101,   /* max_iter reached before the tolerance                                                 */
  RC_STOP_TIME = 102,       /* time_limit reached                                                                    */
  RC_STOP_CANCELLED = 103,  /* a progress callback, rc_contact_cancel or the flag of rc_stop_when asked to stop      */
  RC_STOP_STALLED = 104,    /* no further progress is possible in double precision                                   */
  RC_UNCERTIFIED = 105,     /* the solver claimed success, the library's own check disagrees                         */
  RC_OUTSIDE = 106,         /* beyond the table: the argument is outside the range of proven values, which are continued
                               from its nearer end                                                                   */
  RC_ERR_ARGUMENT = -1,     /* a null pointer, NaN, a value out of range, a bad struct_size                          */
  RC_ERR_SHAPE = -2,        /* array shape: nx, ny, dense_ld, or nx*ny too large                                     */
  RC_ERR_OPTION = -3,       /* unknown option key, wrong type, value out of range                                    */
  RC_ERR_NO_BACKEND = -4,   /* no backend of that name, or none that can do this                                     */
  RC_ERR_NO_SOLVER = -5,    /* no solver of that name                                                                */
  RC_ERR_INCOMPATIBLE = -6, /* solver, backend, kernel, boundary and control do not go together                      */
  RC_ERR_PLUGIN = -7,       /* a plugin was found but is refused (permissions, version, contents)                    */
  RC_ERR_MEMORY = -8,       /* out of memory, or a request that cannot fit                                           */
  RC_ERR_INFEASIBLE = -9,   /* no solution exists: negative load, periodic approach beyond the mean plane, load above
                               hardness times area                                                                   */
  RC_ERR_NUMERIC = -10,     /* the operator is not positive definite or returned NaN                                 */
  RC_ERR_EXTERNAL = -11,    /* the caller's apply callback reported failure                                          */
  RC_ERR_BUSY = -12,        /* this contact is being used by another thread                                          */
  RC_ERR_INTERNAL = -99     /* a defect in the library or a plugin                                                   */
};
/* In which of the three ranges a status is. */
#define RC_CERTIFIED(status) ((status) == 0)
#define RC_USABLE(status) ((status) >= 100)
#define RC_FAILED(status) ((status) < 0)
/** "RC_ERR_SHAPE" and the like; "RC_STATUS_UNKNOWN" for other numbers; never NULL. */
RC_API const char *rc_status_name(rc_status status);
/** The meaning of a status, one sentence; never NULL. */
RC_API const char *rc_status_text(rc_status status);
/** The calling thread's last failure or stop, as "where: what, value, limit, what to do"; "" if the last call
 *  returned RC_OK. Valid until the thread's next call of a function that returns rc_status. */
RC_API const char *rc_last_error(void);
/** The calling thread's calls of this library return RC_STOP_CANCELLED soon after *flag becomes nonzero, which any thread or a
 *  signal handler may bring about: steps, histories, batches, laws, derivatives, stiffnesses and direct routines. The library
 *  only reads *flag, which must live until another call of this function or the thread's end. NULL: no flag (default). */
RC_API void rc_stop_when(const int32_t *flag);
/** Writes data [size] to a file as all functions that write files do: under a temporary name in its folder, brought to the disk and
 *  renamed. The file is whole or unchanged and keeps its permissions; through a link its target is replaced. A device, a pipe
 *  with a reader and an open stream (/dev/stdout) get the bytes; folders, block devices, sockets and pipes without a reader are
 *  refused. Paths are UTF-8, or any bytes where the system allows them. Errors: ARGUMENT (the file cannot be written), MEMORY. */
RC_API rc_status rc_file_write(const char *path, const void *data, size_t size);
/** Version of the library in use; any pointer may be NULL. */
RC_API void rc_version(int32_t *major, int32_t *minor, int32_t *patch, int32_t *abi);
/** @} */

typedef struct rc_context rc_context; /* registry of solvers, backends and kernels, see registry.h. Any thread.      */
typedef struct rc_options rc_options; /* checked key/value set. One thread at a time.                                */
typedef struct rc_contact rc_contact; /* operator, plans, factors and last pressures. One thread at a time.          */

/** @defgroup array Arrays of the caller
 *  Every array of a struct, and every array over points that a function takes, has one of these two types; all zero: no array.
 *  rc_step and rc_result take floats (RC_SINGLE) and memory of a device; undeformed_gap of rc_history and undeformed_gap, p0 and p
 *  of rc_batch take floats. All others are of RC_NATIVE in the host's memory: what is not taken is refused by name, ARGUMENT.
 *  Plain pointers remain where single numbers are written, for matrices (rc_system.dense, direct.h), for callbacks' arguments, in
 *  rc_kernel_coefficients, plugin.h, surface.h and formats.h.
 *  @{ */
enum { RC_NATIVE = 0, RC_SINGLE = 1 };
/** Values that the library writes. */
typedef struct rc_array {
  void *data;          /* NULL: no array                                                                             */
  int32_t type;        /* RC_NATIVE: the type that the member's description names, double unless said otherwise;
                          RC_SINGLE: float instead of double                                                         */
  int32_t reserved;    /* 0                                                                                          */
  const char *memory;  /* where data lies. NULL: in the host's memory. "cuda" or another backend with a device: in that
                          device's memory; values are copied after all earlier work on the device is done             */
} rc_array;
/** Values that the library reads. */
typedef struct rc_const_array {
  const void *data;
  int32_t type;
  int32_t reserved;
  const char *memory;
} rc_const_array;
/** The array at a pointer, of the type that is asked for there and in the host's memory: step.undeformed_gap = RC_IN(gap);
 *  result.p = RC_OUT(p). RC_IN(NULL), RC_OUT(NULL): no array. */
#ifdef __cplusplus
#define RC_IN(pointer) (rc_const_array{(pointer), RC_NATIVE, 0, nullptr})
#define RC_OUT(pointer) (rc_array{(pointer), RC_NATIVE, 0, nullptr})
#else
#define RC_IN(pointer) ((rc_const_array){(pointer), RC_NATIVE, 0, NULL})
#define RC_OUT(pointer) ((rc_array){(pointer), RC_NATIVE, 0, NULL})
#endif
/** @} */

/** @defgroup problem Problem: system and step  @{ */
enum { RC_OPERATOR_HALFSPACE = 1, RC_OPERATOR_DENSE = 2, RC_OPERATOR_CALLBACK = 3 };
enum { RC_BOUNDARY_FREE = 1, RC_BOUNDARY_PERIODIC = 2, RC_BOUNDARY_PERIODIC_X = 3, RC_BOUNDARY_PERIODIC_Y = 4 };
enum { RC_CONTROL_APPROACH = 1, RC_CONTROL_LOAD = 2, RC_CONTROL_AREA = 4, RC_CONTROL_PRESSURE = 8 };
enum { RC_CREEP_COMPLIANCES = 0, RC_CREEP_MODULI = 1 };

/** The bodies and the grid, fixed over a loading history. Copied; `dense` and `user` must outlive the contact.
 *
 *  With creep a step ends at rc_step.time, and pressures change linearly in time from the certified step before it; the first is at
 *  rest until its time, when it is pressed at once. So are two steps at the same time. Deflections are then the step's compliance
 *  times H p, and a deflection that the steps before have left and that counts as part of the undeformed gap. Answers, residuals,
 *  bounds and dW/dd are those of this step, for these points in time. Contact laws, derivatives and option accuracy are without
 *  creep; other functions that take a system ignore it. */
typedef struct rc_system {
  size_t struct_size;  /* sizeof(rc_system)                                                                          */
  int32_t op;          /* RC_OPERATOR_*; the half-space unless set                                                   */
  int32_t boundary;    /* RC_BOUNDARY_*; HALFSPACE only: there is no default. PERIODIC: the grid is a sample of a larger
                          surface, as a map of roughness is. FREE: the body ends at the grid's edges, as a ball does.
                          PERIODIC_X, _Y: it repeats along this axis and ends across it, as the rim of a roller does: see
                          rc_result.approach                                                                         */
  int64_t nx, ny;      /* points along x and y, >= 1; DENSE and CALLBACK: n = nx*ny unknowns                         */
  double hx, hy;       /* cell size along x and y [length], > 0; DENSE and CALLBACK: hx*hy is the cell area          */
  double modulus;      /* contact modulus E* [force/length^2], > 0; HALFSPACE only                                   */
  const double *dense; /* DENSE: symmetric positive definite n x n, row stride dense_ld
                          [length per (force/length^2)]; referenced, not copied; a pointer, as LAPACK's matrices are  */
  int64_t dense_ld;    /* DENSE: >= n                                                                                */
  int32_t (*apply)(const double *x, double *y, int64_t n, void *user); /* CALLBACK: y = H x, symmetric positive
                          definite; return nonzero to fail; must return: no exception, no longjmp; called on the solving thread */
  void *user;          /* handed to apply                                                                            */
  double hardness;     /* the largest pressure c [force/length^2], for every op; 0 or infinite: none                 */

  /* Creep of both bodies: H grows with the time under load, by one factor for every entry (one Poisson's ratio) */
  int32_t creep_by;    /* COMPLIANCES (default): H(t) = H (1 + sum ratio_k (1 - exp(-t/time_k))), ratios J_k/J_0 >= 0;
                          MODULI: the modulus relaxes as 1 - sum ratio_k (1 - exp(-t/time_k)), ratios E_k/E_0 >= 0 of sum
                          < 1. H and modulus are those at once, t = 0                                                */
  int32_t creep_terms; /* of this Prony series, 0 .. 1000; 0: elastic (default)                                      */
  rc_const_array creep_ratio; /* double [creep_terms]                                                                */
  rc_const_array creep_time; /* double [creep_terms] > 0 [time]                                                      */
} rc_system;
#define RC_SYSTEM_INIT RC_BEGIN_WITH(rc_system, op = RC_OPERATOR_HALFSPACE)

/** One step: target, start and arrays. After the call the library keeps only a copy of the undeformed gap and mask, or with
 *  borrow the two pointers. */
typedef struct rc_step {
  size_t struct_size;  /* sizeof(rc_step)                                                                            */

  /* Target and start */
  int32_t control;     /* RC_CONTROL_*                                                                               */
  int32_t warm_start;  /* 1: start from this contact's last pressures (default); 0: start cold (factors that a
                          backend keeps still serve: equal to round-off, after rc_contact_reset bitwise)             */
  double target;       /* APPROACH: approach d [length]; LOAD: normal force W [force], >= 0; PRESSURE: mean pressure
                          W/(n hx hy) [force/length^2], >= 0; AREA: contact area [length^2], 0 .. n hx hy: loads are tried
                          until rc_result.contact_area is within 1e-3 of it or half a cell. If no load gives it, the answer
                          has the nearest area, and rc_result.note says so. Limits and counts of work are those of all loads
                          together; only the load found is remembered, and leaves an indentation. Not for rc_contact_certify */

  /* Arrays of the caller */
  rc_const_array undeformed_gap; /* [n] h [length], see rc_gap_from_heights; none: as in the previous step           */
  rc_const_array mask; /* [n] uint8_t; 0: this point carries no pressure and its undeformed gap is ignored (it may be NaN);
                          none with undeformed_gap given: all points; none without: as in the previous step          */
  rc_const_array p0;   /* [n] explicit start [force/length^2], negative values are taken as 0; none: no such start   */
  int32_t borrow;      /* 1: undeformed_gap and mask are not copied; they stay as they are until a step that brings
                          other arrays has returned, or the contact is reset or destroyed. A gap may then be a file that is
                          mapped into memory; one on a device is read there by that device's solvers. 0: copied (default) */
  int32_t reserved;    /* 0                                                                                          */
  double time;         /* [time of rc_system.creep_time] at the step's end, not before that of the contact's last certified
                          step; without creep it has no effect                                                       */
} rc_step;
#define RC_STEP_INIT RC_BEGIN_WITH(rc_step, warm_start = 1)

/** The undeformed gap of n heights, of which the highest touches first: highest - height [length]. The highest is that of the
 *  points where the mask is not 0 (none: all) and the height is not NaN; NaN stays NaN, which only a masked point may have in
 *  rc_step. heights, undeformed_gap: double [n], which may be one array; mask: uint8_t [n]. Errors: ARGUMENT. */
RC_API rc_status rc_gap_from_heights(int64_t n, rc_const_array heights, rc_const_array mask, rc_array undeformed_gap);
/** @} */

/** @defgroup result Result  @{ */
/** Answer of one step. The caller sets p and gap; the library writes what they point to and the rest whenever the returned status
 *  is >= 0, and leaves both arrays untouched when it is < 0.
 *
 *  With option accuracy the answer may come from a coarser grid, each of whose cells averages a block of 2^k by 2^k points:
 *    member                     RC_WITHIN_GOAL                                    a step that stopped on a coarser grid
 *    p                          coarser answer, a few steps on the whole grid     pressure of the point's block
 *    gap                        of p                                              gap of the block; infinite: all masked
 *    load, contacts, area       of p                                              of p
 *    approach                   LOAD: estimated, see below                        coarser grid's
 *    stiffness, solver, backend, tolerance   coarser grid's                       coarser grid's
 *    kkt_* and all others       of p; kkt_* exceed the tolerance                  coarser grid's
 *  Estimated approach: at it the mean of the gap, weighted by p, vanishes; p is scaled to the prescribed load. If the grid's end or
 *  the mask cuts a block, its pressure is such that the load stays. */
typedef struct rc_result {
  size_t struct_size;  /* sizeof(rc_result)                                                                          */

  /* Arrays of the caller */
  rc_array p;          /* [n] pressures [force/length^2]; none: not wanted. With RC_SINGLE the values are rounded, and all
                          numbers below are of those before                                                          */
  rc_array gap;        /* [n] deformed gap g = H p + h - d [length]; none: not wanted                                */

  /* The answer */
  rc_status status;    /* as returned; failed until an answer is written                                             */
  int32_t homogeneous; /* 1: H is that of a homogeneous half-space, so that a conductance follows from the stiffness;
                          0: it is not known to be: a caller's matrix or product, a kernel without RC_KERNEL_HOMOGENEOUS,
                          creep                                                                                      */
  double load;         /* hx hy sum(p) [force]                                                                       */
  double approach;     /* d [length]. Periodic boundaries: the change of the mean gap, mean(h) - mean(g) = d, if no point is
                          masked or at the hardness; nothing need be subtracted from it. Free boundaries: it includes the
                          deflection of the body below the contact. PERIODIC_X, _Y: deflections are 0 at the distance
                          R = nx hx + ny hy from a line load, as only differences are determined there; another R' adds
                          2 F/(pi E* L) ln(R'/R), F the load and L the period                                        */
  double mean_pressure; /* load / (n hx hy) [force/length^2]                                                         */
  double max_pressure; /* the largest p [force/length^2]; 0 without contact                                          */
  double contact_area; /* contacts hx hy [length^2]                                                                  */
  double area_fraction; /* contacts / points                                                                         */
  double mean_gap;     /* mean of g over the points that are not masked [length]; the overlap of points at the hardness
                          counts as 0. NaN where the certificate needs g at some points only, as it does in sparse
                          contact, unless gap is wanted                                                              */
  double energy;       /* (1/2 p'Hp - (d - h)'p) hx hy [force length], the functional that is minimised              */
  int64_t contacts;    /* points with p > 0                                                                          */

  /* Residuals, all from a product of the library's own */
  double kkt_primal;   /* max(0, -min p) / max|p|; hardness c: at least max(0, max p - c) / c                        */
  double kkt_dual;     /* largest overlap over s: max(0, -min g) / s over all points, s = max(d - h). docs/certificate.md has
                          the formula with a hardness and the exceptions of s with periodic boundaries               */
  double kkt_complementarity; /* max over all points of min(p / max p, |g| / s); hardness: at g < 0 also (c - p) / c   */
  double kkt_control;  /* |load - W| / W, 0 in approach control                                                  */
  double tolerance;    /* limit of the kkt_* residuals: tol, or accuracy/100 (area: /1000) if larger                 */

  /* Proof: intervals of the exact answer */
  double duality_gap;  /* energy - least energy is at most this [force length], see docs/certificate.md;
                          this and the bounds below: NaN (counts: -1) where no proof is known, option bounds is
                          0 or accuracy is set. Full periodic contact: NaN, and intervals that exclude nothing       */
  double gap_error;    /* the exact deformed gap of every point differs from gap by at most this [length]            */
  double load_lower, load_upper; /* the exact load at this approach lies between [force]                             */
  double area_lower, area_upper; /* and the exact contact area [length^2]                                            */
  int64_t proven_contacts; /* points proven to be in contact                                                         */
  int64_t proven_open; /* points proven to be out of contact                                                         */
  int64_t undecided;   /* the other points                                                                           */

  /* Stiffness */
  double stiffness;    /* dW/dd of the contact set [force/length], to tol of its value or closer (round-off may keep some
                          1e-8 if nearly all of 10^5 periodic points touch); infinite in full periodic contact; NaN where
                          option stiffness is 0, and where conjugate gradients with a product lower no residual      */
  double stiffness_lower, stiffness_upper; /* the exact dW/dd at this approach lies between these [force/length]; NaN
                          unless option stiffness is 2, and where no proof is known. Both 0 if each loaded point is proven
                          to be at the hardness: the load does not grow there                                        */
  double punch_stiffness; /* dW/dd of a rigid flat punch as large as the grid, to 0.2 % [force/length]: what free edges
                          bring into stiffness, as 1/stiffness = 1/punch_stiffness + 1/(that of a periodic surface),
                          roughly. NaN with periodic boundaries, without a half-space, and where option stiffness is 0 */

  /* With a hardness */
  int64_t capped;      /* points with p = hardness; this and the next: 0 without a hardness                          */
  double plastic_volume; /* hx hy times the overlap of these points in this step [length^3]                          */
  int64_t proven_capped; /* points proven to carry the hardness; also counted in proven_contacts                     */

  /* Grid of the answer and its estimated errors */
  int64_t model_nx, model_ny; /* points of the grid that was solved: nx and ny, or a coarser one's                   */
  double error_estimate; /* with option accuracy: estimated relative error of the load or area that accuracy.of names, against
                          the answer on the whole grid; 0 on it; NaN without, and if a step stopped on a coarser grid */
  double area_estimate; /* the same for contact_area; a goal of the load does not bound it                           */
  double left_out;     /* rms of the undeformed gap less its block's mean, over the points in contact [length]; 0 on the
                          whole grid                                                                                 */

  /* Work */
  int64_t points;      /* n, as given                                                                                */
  int64_t candidates;  /* points that can carry pressure at this approach (h < d; all points where H has
                          negative entries: periodic boundaries, some caller's matrices, callbacks)                  */
  int64_t modelled;    /* unknowns or transform points of the operator used: the bounding box of the
                          candidates for matrix-free backends, the candidates themselves for dense ones              */
  int64_t iterations;  /* of the solver, all rounds together                                                         */
  int64_t products;    /* products with H, the certificate's and the stiffness' included                            */
  int64_t levels;      /* coarse solutions kept, see rc_contact_level                                                */
  double seconds;      /* solving and certifying                                                                     */
  double setup_seconds; /* influence coefficients, plans and factors built in this call                              */

  /* Names */
  char solver[32];     /* what "auto" resolved to                                                                    */
  char backend[32];
  char kernel[32];
  char note[512];      /* remarks: a probable mistake in units or heights, an unbounded interval, operations that the core
                          replaced, remarks of the solver; whole remarks, and how many more there are; "" if none    */
} rc_result;
#define RC_RESULT_INIT RC_BEGIN_WITH(rc_result, status = RC_ERR_ARGUMENT)
/** @} */

/** @defgroup options Options: keys with a declared schema, checked when set
 *  `roughcontact options` and docs/options.md list them. Keys of the core are below, for a compile-time check of the spelling;
 *  those of components are dotted ("fft.precision").
 *  @{ */
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
#define RC_OPT_RESUMABLE "resumable"
#define RC_OPT_ACCURACY "accuracy"
#define RC_OPT_ACCURACY_OF "accuracy.of"

/** context NULL: the default context. */
RC_API rc_status rc_options_create(rc_context *context, rc_options **out);
/** A copy with the same values, in the same context. */
RC_API rc_status rc_options_copy(const rc_options *options, rc_options **out);
RC_API void rc_options_destroy(rc_options *options);
/** Sets an option whose value is a number; an integer's has no fraction. A dotted key loads its component. Errors: OPTION with the
 *  nearest key, the type or the range in the message. */
RC_API rc_status rc_options_set_number(rc_options *options, const char *key, double value);
/** Sets an option of any type: numbers are read from the text, with a point as decimal mark in every locale. Errors: the same. */
RC_API rc_status rc_options_set_text(rc_options *options, const char *key, const char *text);
/** The value of an option that is a number, or the default. Errors: OPTION (also of a text). */
RC_API rc_status rc_options_get_number(const rc_options *options, const char *key, double *out);
/** The same for a text. *out lives until the key is next set or the options are destroyed. */
RC_API rc_status rc_options_get_text(const rc_options *options, const char *key, const char **out);
/** @} */

/** @defgroup contact Contact: one system, many steps  @{ */
/** Handed to the progress callback. */
typedef struct rc_progress {
  size_t struct_size;
  int64_t iteration;   /* of the solver                                                                              */
  int64_t products;    /* products with H so far                                                                    */
  double kkt;          /* the solver's own estimate of its worst residual; NaN before the first                      */
  double seconds;      /* since the step began                                                                       */
} rc_progress;
typedef int32_t (*rc_progress_fn)(const rc_progress *, void *user); /* return nonzero to stop                        */

/** One shot: create, solve, destroy. options may be NULL. */
RC_API rc_status rc_solve(const rc_system *system, const rc_step *step, const rc_options *options, rc_result *result);
/** Checks the system, the options and the names of components; a name in a component's option (cmr.inner) is checked by the step
 *  that uses it. A caller's matrix is read, and a caller's product is called once. Operators are built by the steps that need
 *  them. options may be NULL (defaults, default context); they are copied. Errors: ARGUMENT, SHAPE, OPTION,
 *  INCOMPATIBLE, NO_BACKEND, NO_SOLVER, PLUGIN, MEMORY, NUMERIC, EXTERNAL. */
RC_API rc_status rc_contact_create(const rc_system *system, const rc_options *options, rc_contact **out);
RC_API void rc_contact_destroy(rc_contact *contact);
/** Solves one step and certifies the answer. A failed or stopped step keeps the last certified pressures as
 *  the next warm start. Errors: ARGUMENT, INFEASIBLE, INCOMPATIBLE, NO_BACKEND, MEMORY, NUMERIC, EXTERNAL, BUSY. */
RC_API rc_status rc_contact_solve(rc_contact *contact, const rc_step *step, rc_result *result);
/** Certifies the pressures that the caller puts in result->p ([n]) for this step, without a solve. In load control the approach
 *  is the one that fits them best. RC_OK or RC_UNCERTIFIED. */
RC_API rc_status rc_contact_certify(rc_contact *contact, const rc_step *step, rc_result *result);
/** The contact set of the last step that was certified or within its goal, without arrays over all points: *n = how many
 *  points carry pressure (0: none, or no such step); the first `room` of them, point numbers iy*nx + ix in ascending order
 *  and pressures [force/length^2], into index (int64_t [room]) and p (double [room]), each of which may be none. An rc_history_fn
 *  may call it for the step that it receives. Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_points(rc_contact *contact, int64_t room, rc_array index, rc_array p, int64_t *n);
/** Changes options; a key marked fixed must keep its value (else OPTION). Errors: OPTION, BUSY. */
RC_API rc_status rc_contact_set_options(rc_contact *contact, const rc_options *options);
/** Calls fn on the solving thread at least every `every` iterations (>= 1). fn NULL: none. fn may call only
 *  rc_contact_cancel, and must return: no exception and no longjmp may leave it. Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_on_progress(rc_contact *contact, rc_progress_fn fn, void *user, int64_t every);
/** Stops the running solve soon, or the next one if none runs. Any thread, or a signal handler. NULL ignored. */
RC_API void rc_contact_cancel(rc_contact *contact);
/** The reasons for the choice of "auto" in the last step on the given grid: a line for each solver and backend with its estimate
 *  of seconds and bytes, or the reason why it cannot. *out: "" if no step has needed a solver; lives until the
 *  contact is next used or destroyed. Errors: ARGUMENT, MEMORY, BUSY. */
RC_API rc_status rc_contact_explain(rc_contact *contact, const char **out);
/** Forgets surface, plastic indentation, creep, last pressures and factors; keeps plans and tables of transforms. Errors: BUSY. */
RC_API rc_status rc_contact_reset(rc_contact *contact);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
