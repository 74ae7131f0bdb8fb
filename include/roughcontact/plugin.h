/* roughcontact plugin interface: how a backend (a way to multiply by H), a solver or a kernel (the entries of H) is added from
 * outside.
 *
 * A plugin is a shared object rcb_<name>.so that exports one function, rc_plugin_query (RC_PLUGIN_ENTRY writes
 * its head). It links nothing of the library: all services come through rc_host. The same source can be built
 * into the library instead. Nothing here may throw, longjmp, print or exit.
 * If the host ends its thread (see Cancellation in roughcontact.h), a service of the core does not return: the stack is
 * unwound through the component. Its C++ functions are then not noexcept, and rethrow abi::__forced_unwind; those of plugin.hpp do.
 *
 * The core hands backends and solvers a *dimensionless* problem for half-space grids (modulus 1, cells of unit
 * area), so no component needs to think about units. Arrays are plain pointers, because components are called in inner loops.
 *
 * Growth: every struct begins with struct_size, which the side that fills it sets to sizeof. A later minor number adds
 * members at the ends of structs. The library refuses tables (rc_plugin, rc_backend, rc_solver, rc_kernel) that are smaller
 * than those of 1.0, takes members beyond their struct_size as zero, and ignores members that it does not know. A member
 * that is added later names its minor number; before a plugin reads one, it compares struct_size. All below is of 1.0.
 */
#ifndef ROUGHCONTACT_PLUGIN_H
#define ROUGHCONTACT_PLUGIN_H

#include "registry.h"

#define RC_PLUGIN_ABI_MAJOR 1u /* must be equal; part of the directory name as well                           */
#define RC_PLUGIN_ABI_MINOR 0u /* grows with members at the ends of structs                                   */

#ifdef __cplusplus
extern "C" {
#endif

/** Services of the core. Valid as long as the component lives. Every function is thread-safe. */
typedef struct rc_host rc_host;
struct rc_host {
  size_t struct_size;
  uint32_t abi_major, abi_minor;

  /* Messages */
  /** Sets the thread's message and returns code, so that `return host->fail(host, RC_ERR_..., "...")` works. */
  rc_status (*fail)(const rc_host *, rc_status code, const char *message);
  void (*log)(const rc_host *, int32_t level, const char *message);

  /* Options, by key */
  rc_status (*option_int)(const rc_host *, const rc_options *, const char *key, int64_t *out);
  rc_status (*option_real)(const rc_host *, const rc_options *, const char *key, double *out);
  rc_status (*option_text)(const rc_host *, const rc_options *, const char *key, const char **out);

  /* Values of H */
  /** H at the offsets (ix, iy), 0 <= ix < mx, 0 <= iy < my, into out[iy*mx + ix] [length per pressure]. Periodic
   *  systems: of the periodic Green's function without its mean (zero_mode = 0). HALFSPACE only. */
  rc_status (*coefficients)(const rc_host *, const rc_system *, const char *kernel, int64_t mx, int64_t my, double *out);
  /** Free systems: H at the offsets (first_x + ix, first_y + iy), as coefficients() has it. Several threads may call it at
   *  the same time; a message is seen in the thread that called. */
  rc_status (*window)(const rc_host *, const rc_system *, const char *kernel, int64_t first_x, int64_t first_y, int64_t mx,
                      int64_t my, double *out);
  /** Periodic systems: eigenvalues of H at wave numbers kx = 0..nx/2, ky = 0..ny/2 into out[ky*(nx/2+1) + kx];
   *  those at nx-kx and ny-ky are equal. out[0] (the mean) is 0. */
  rc_status (*symbol)(const rc_host *, const rc_system *, const char *kernel, double *out);

  /* Threads and contacts that share something */
  /** Process-wide named locks for libraries with global state ("fftw" guards FFTW's planner). Not recursive. */
  void (*lock)(const rc_host *, const char *resource);
  void (*unlock)(const rc_host *, const char *resource);
  /** An object that all contacts of a context with one system, kernel and length unit may share, under the component's own key. If
   *  no contact holds it, make(argument, object) makes it; threads that want the same one wait. destroy(object) follows the last
   *  release(), in any thread. make() must read the same values for all of them. */
  rc_status (*share)(const rc_host *, const char *key, rc_status (*make)(void *argument, void **object),
                     void (*destroy)(void *object), void *argument, void **object);
  void (*release)(const rc_host *, void *object); /* once for each share()                                     */
  /** As share(), but the contact or batch holds the object until it is destroyed: no release(). of_system: 1: only contacts with
   *  the same system share the object; 0: all contacts of the context do. */
  rc_status (*keep)(const rc_host *, int32_t of_system, const char *key, rc_status (*make)(void *argument, void **object),
                    void (*destroy)(void *object), void *argument, void **object);
};

/** The threads of one contact (option threads). Used by one thread at a time, not from inside a task. */
typedef struct rc_team rc_team;
struct rc_team {
  size_t struct_size;
  int64_t threads; /* >= 1, the calling one included                                                          */
  /** task(argument, item, thread) once for each 0 <= item < items, with 0 <= thread < threads; returns when all are done.
   *  Any thread may take any item, so what an item computes must not depend on its thread. task must not throw. */
  void (*share)(const rc_team *, int64_t items, void (*task)(void *argument, int64_t item, int64_t thread), void *argument);
};

/** The rows of a grid that each of several processes (ranks) has. All ranks call the same function at the same time, on the thread
 *  that uses the operator. A rank on which an exchange fails goes on as if it had not: agree() returns the failure to all. */
typedef struct rc_rows rc_rows;
struct rc_rows {
  size_t struct_size;
  int64_t rank, ranks;  /* 0 <= rank < ranks                                                                   */
  const int64_t *first; /* [ranks + 1] rank r has the rows first[r] .. first[r+1] - 1; first[ranks] = ny        */
  /** Rank r gets sent[r] bytes of `from`, and gives received[r] bytes of `into`; the parts lie in the order of ranks. */
  void (*transpose)(const rc_rows *, const void *from, const int64_t *sent, void *into, const int64_t *received);
  /** The parts of all ranks, in their order: bytes[r] of rank r [ranks]. */
  void (*gather)(const rc_rows *, const void *mine, const int64_t *bytes, void *all);
  /** Before a transpose() for which a rank may be missing: whether any rank has failed. `mine`: this rank's status, with its
   *  message set. The same status on all ranks, to be returned. */
  rc_status (*agree)(const rc_rows *, rc_status mine);
};

/** The problem for which an operator is built. Valid as long as the operator. */
typedef struct rc_operator_spec rc_operator_spec;
struct rc_operator_spec {
  size_t struct_size;
  const rc_system *system;   /* dimensionless for HALFSPACE; as the caller gave it for DENSE and CALLBACK      */
  const char *kernel;        /* resolved name; "" for DENSE and CALLBACK                                       */
  const rc_options *options; /* read through rc_host                                                           */
  const rc_team *team;       /* the contact's threads                                                          */
  /** An operator calls it now and then, on the calling thread, while it does what takes long. Nonzero: the caller has cancelled or
   *  the time is up; return it at once. NULL: nobody can stop the operator. */
  rc_status (*poll)(const rc_operator_spec *);
  /** NULL: this process has the whole grid. Else vectors are of this rank's rows, every point of them, and all ranks call
   *  create, bind and products together. Only backends with RC_CAP_ROWS get it. */
  const rc_rows *rows;
};

/** The points that may carry pressure (the trial set T). Valid until the next bind or destroy. */
typedef struct rc_domain {
  size_t struct_size;
  int64_t n;            /* >= 1                                                                                */
  const int64_t *index; /* [n] ascending point numbers iy*nx + ix; NULL: every point of the grid, n = nx*ny    */
  double zero_mode;     /* periodic: eigenvalue of H for the constant vector. 0: the mean plane is the datum   */
} rc_domain;

/* Capabilities of a backend (rc_backend.caps). Some bits stand for an optional function: registration fails if a bit is set and
 * its function is NULL, or the reverse. In C++ roughcontact::backend sets these bits. */
/* Systems; at least one of the first four, or SEMI_PERIODIC */
#define RC_CAP_FREE (UINT64_C(1) << 0)        /* half-space grids with free boundaries                         */
#define RC_CAP_PERIODIC (UINT64_C(1) << 1)    /* half-space grids with periodic boundaries                     */
#define RC_CAP_DENSE_INPUT (UINT64_C(1) << 2) /* the caller's dense matrix                                     */
#define RC_CAP_CALLBACK (UINT64_C(1) << 3)    /* the caller's product                                          */
#define RC_CAP_FAR_FIELD (UINT64_C(1) << 4)   /* only for kernels with RC_KERNEL_FAR_FIELD                     */
#define RC_CAP_ROWS (UINT64_C(1) << 5)        /* grids that ranks share: reads rc_operator_spec.rows           */
#define RC_CAP_SEMI_PERIODIC (UINT64_C(1) << 13) /* half-space grids that repeat along one axis: H(i, j) depends on |xi - xj|
                                                and |yi - yj| as with free boundaries, window() has its coefficients */
/* Products */
#define RC_CAP_THREAD_INVARIANT (UINT64_C(1) << 6) /* bitwise equal for any number of threads                  */
#define RC_CAP_APPROXIMATE (UINT64_C(1) << 7)      /* may be off by about 1e-11 of the largest entry           */
/* Functions */
#define RC_CAP_FLOAT (UINT64_C(1) << 8)    /* apply_float()                                                    */
#define RC_CAP_SCREEN (UINT64_C(1) << 9)   /* screen()                                                         */
#define RC_CAP_SUBSET (UINT64_C(1) << 10)  /* subset()                                                         */
#define RC_CAP_SHIFTED (UINT64_C(1) << 11) /* shifted()                                                        */
#define RC_CAP_NORM (UINT64_C(1) << 12)    /* norm()                                                           */

/** The surface against which a product over all points is compared. */
typedef struct rc_screen {
  size_t struct_size;
  double approach, unit; /* a point overlaps if unit (H x) < approach - undeformed_gap                         */
  rc_const_array undeformed_gap; /* [nx*ny] in the host's memory, of either type                               */
  const uint8_t *mask;   /* [nx*ny] 0: not looked at; NULL: all points are                                     */
  /* [ceil(nx/16) * ceil(ny/16)] a lower bound of the gap at the points looked at of each tile of 16 x 16 points, row by row
     (+infinity: there is none); spares the pass over the gap. NULL: none is known                             */
  const double *tile_lowest;
  /* Rows. rows > 0: gap and mask are those of rows first_row .. first_row + rows - 1 only, and no other point outside T is
     looked at; tile_lowest is then NULL                                                                       */
  int64_t first_row, rows;
  /* Out */
  double *y;             /* [n] H[T,T] x                                                                       */
  int64_t room;          /* in: entries of found and depth                                                     */
  int64_t *found;        /* [room] overlapping points outside T, as many as there is room for                  */
  double *depth;         /* [room] approach - undeformed_gap - unit (H x) of each                              */
  int64_t n_found;       /* all that overlap, also those for which there is no room                            */
} rc_screen;

/** The task of a component, as far as it is known before an operator is made. */
typedef struct rc_estimate rc_estimate;
typedef struct rc_facts {
  size_t struct_size;
  const rc_host *host;        /* reads options; its fail() says why a component cannot                         */
  const rc_options *options;
  const rc_system *system;    /* as in rc_operator_spec                                                        */
  int64_t n;                  /* points that may carry pressure                                                */
  int64_t box;                /* points of their bounding box                                                  */
  double tol;                 /* residual to reach                                                             */
  /* Solvers only */
  const rc_estimate *backend; /* the backend's estimate                                                        */
  uint64_t caps;              /* what the backend can do, RC_CAP_*                                             */
  int64_t at_once;            /* number of such contacts: solvers with solve_many() estimate the cost of each  */
  int32_t partial;            /* 1: the solver is stopped after some steps, for the pressures that it has by then */
  int32_t reserved;
} rc_facts;

/** An estimate of cost on one thread. The library sets all members to zero before it asks. */
struct rc_estimate {
  size_t struct_size;
  double seconds; /* backend: to make the operator; solver: for the step, the operator's making and work included */
  double bytes;   /* backend: of the operator; solver: of its own                                               */
  double product, field; /* backend: seconds of apply() and field()                                            */
  double factor;  /* backend with subset(): seconds to factor a third of the unknowns                          */
};

/** A backend: products with H. All vectors are over the domain's points unless said otherwise. One operator is
 *  used by one thread at a time; several operators may be used at the same time. */
typedef struct rc_backend {
  size_t struct_size;

  /* Required: who it is */
  const char *name;    /* [a-z][a-z0-9_-]{0,30}                                                                */
  const char *summary; /* one line                                                                             */
  const char *license; /* SPDX, of the backend with its dependencies                                           */
  uint64_t caps;       /* RC_CAP_*                                                                             */
  int64_t n_options;
  const rc_component *const *options; /* keys "<name>.<key>"                                                 */

  /* Required: operators and their products */
  /** Builds an operator. bind() is called before any product. */
  rc_status (*create)(const rc_host *, const rc_operator_spec *, void **self);
  void (*destroy)(void *self);
  /** Sets the trial set; called again whenever it changes. Keep what can be kept. On failure no product follows. */
  rc_status (*bind)(void *self, const rc_domain *);
  /** y = H[T,T] x. x and y do not overlap. */
  rc_status (*apply)(void *self, const double *x, double *y);
  /** y = H[all points, T] x, y of length nx*ny. x and y do not overlap. */
  rc_status (*field)(void *self, const double *x, double *y);
  /** Number of points the operator works on for the bound domain: n for a dense one, the box for a transform. */
  int64_t (*modelled)(void *self);

  /* Choice, optional */
  /** The estimate that "auto" compares: from counts, never from clocks. "auto" takes backends without one last. A status other
   *  than RC_OK (set the reason by facts->host->fail) refuses this step; a backend that the caller names is then taken anyway. */
  rc_status (*score)(const rc_facts *, rc_estimate *);

  /* Products, optional */
  /** RC_CAP_FLOAT: y = H[T,T] x in single precision, much faster than apply(). x and y do not overlap. */
  rc_status (*apply_float)(void *self, const float *x, float *y);
  /** RC_CAP_SCREEN: for x >= 0, H[T,T] x and the points outside T that overlap, without a product for points that
   *  are proven to stay apart. */
  rc_status (*screen)(void *self, const double *x, rc_screen *);

  /* Solving, optional */
  /** RC_CAP_SUBSET: solve H[a,a] x = b for the na ascending positions a in the domain. Successive
   *  calls with sets that differ little should be cheap. RC_ERR_NUMERIC if H[a,a] is not positive definite. */
  rc_status (*subset)(void *self, int64_t na, const int64_t *a, const double *b, double *x);
  /** RC_CAP_SHIFTED: solve (H[T,T] + rho I) x = b, rho > 0. Successive calls with one rho should be cheap.
   *  RC_ERR_NUMERIC if the matrix is not positive definite. */
  rc_status (*shifted)(void *self, double rho, const double *b, double *x);
  /** RC_CAP_NORM: the Frobenius norm of H[T,T]. */
  rc_status (*norm)(void *self, double *out);

  /* Between steps, optional */
  /** Forget everything that depends on earlier steps: products after the next bind() must equal a new operator's, bit for bit. What
   *  is the same for every operator of this system may be kept. NULL: nothing is kept. */
  rc_status (*forget)(void *self);
  /** A step is over: memory that only products need may be freed, or lent to the operators of other contacts. Later products keep
   *  their bits. NULL: nothing would be freed. */
  void (*rest)(void *self);

  /* Device, optional, both or none: products need a device with a memory of its own, which rc_array.memory names by the backend */
  /** Copies bytes from the memory of the device that the options name to the host's, and the reverse, once the device has done what
   *  it was given before. RC_ERR_ARGUMENT: the address is not in that memory. */
  rc_status (*fetch)(const rc_host *, const rc_options *, void *to_host, const void *from_device, int64_t bytes);
  rc_status (*store)(const rc_host *, const rc_options *, void *to_device, const void *from_host, int64_t bytes);
} rc_backend;

/** Where the unknowns of a half-space problem lie, in the caller's units. */
typedef struct rc_grid {
  size_t struct_size;
  int64_t nx, ny;
  double hx, hy;        /* cell size [length]                                                                   */
  /* [nx*ny] undeformed gap [length], in the host's memory; meaningless where the mask is 0. Only solvers with RC_READS_SINGLE_GAP
     get it in RC_SINGLE; others get a copy in doubles                                                          */
  rc_const_array undeformed_gap;
  const uint8_t *mask;  /* [nx*ny] 0: never in contact; NULL: every point may be                                */
  const int64_t *index; /* [n] point numbers of the unknowns, ascending; NULL: every point                      */
  double approach;      /* APPROACH: d [length]; LOAD: the lowest gap, from which d is counted              */
  double softness;      /* periodic: the largest eigenvalue of H but the mean's, over that of a half-space; free: 1 */
  int32_t boundary;     /* RC_BOUNDARY_*                                                                        */
  int32_t reserved;

  /* Device */
  rc_const_array gap_on_device; /* the gap once more, of the same type; data NULL: it is on no device           */
} rc_grid;

/** A problem on a coarser grid of the same surface. */
typedef struct rc_coarse {
  size_t struct_size;
  int64_t nx, ny;      /* points                                                                               */
  int64_t factor;      /* its cells are this many cells of the problem's grid wide and high                    */
  const double *undeformed_gap; /* [nx*ny] undeformed gap [length]                                             */
  const uint8_t *mask; /* [nx*ny] 0: no pressure here; NULL: every point                                       */
  int32_t control;     /* RC_CONTROL_*                                                                         */
  int32_t keep;        /* 1: the core keeps what it set up for the next step, and a copy of p for the caller; 2: no copy;
                          0: neither                                                                           */
  double load;         /* LOAD: prescribed [force]                                                             */
  double tol;          /* 0: that of the step                                                                  */
  const char *solver;  /* by name                                                                              */
  /* Out */
  double approach;     /* [length] in: APPROACH; out: LOAD                                                     */
  double *p;           /* [nx*ny] pressures [force/length^2]                                                   */
} rc_coarse;

/** Answers that a solver keeps between the steps of a history, in its own memory, as on a device. Valid while solve() runs. */
typedef struct rc_kept_steps rc_kept_steps;
struct rc_kept_steps {
  size_t struct_size;
  /* The objects that this solver kept of the last step and of the step before it. NULL: none; of `last` also: the start comes
     from elsewhere.
     Start: a point has the pressure a in the last step and b in the one before. If `last` is not NULL, p of rc_problem is
     min(max(0, (a + ahead*(a - b)) / pressure), cap); b plays no part if ahead is 0. The library has written this p, so the
     solver may drop what it kept.
     Memory: no later step starts from `before`, so the solver may use its memory for the new answer                  */
  void *last, *before;
  double ahead;
  double hardness; /* [force/length^2] pressure of a point with p = cap, others have p*rc_problem.pressure; INFINITY: none */
  int32_t may_go_without; /* if there is no memory for what only makes steps faster: 1: go on without it; 0: fail (other ranks
                             make the same step)                                                                        */
  int32_t reserved;
  /** Hands over an object that stands for the p that solve() then returns. It is passed to destroy once no later step can start
   *  from it: during a later step, or with the contact; rc_host is still valid. */
  void (*keep)(const rc_kept_steps *, void *object, void (*destroy)(void *object));
};

/** The problem handed to a solver, scaled so that penetrations are at most 1. With w = H p - u (approach
 *  control) or w = H p - u - d (load control, d found): p >= 0, w >= 0, p w = 0. */
typedef struct rc_problem rc_problem;
struct rc_problem {
  size_t struct_size;

  /* The problem */
  int64_t n;          /* unknowns                                                                              */
  int32_t control;    /* RC_CONTROL_*                                                                          */
  int32_t positive;   /* 1: no entry of H is negative                                                          */
  const double *u;    /* [n] APPROACH: penetration d - h; LOAD: -h. NULL: see RC_READS_GAP                   */
  double load;        /* LOAD: the sum of p that is wanted                                                     */
  double cap;         /* the largest pressure: 0 <= p <= cap; p = cap: w <= 0. INFINITY: none                  */
  double tol;         /* residual to reach, relative to a penetration of 1                                     */
  double lambda_min;  /* a lower bound of the eigenvalues of H; 0: none is known                               */
  double zero_mode;   /* periodic: eigenvalue of H for the constant vector, which coefficients() leaves out    */
  double length, pressure; /* units: u and d in lengths [length], p in pressures [force/length^2]; 0 without a grid */
  const rc_grid *grid;     /* NULL for the caller's matrix and product                                         */
  const rc_team *team;     /* the contact's threads                                                            */

  /* Progress */
  /** Once an iteration, with the worst residual as the solver sees it. Nonzero: return it at once. */
  rc_status (*poll)(const rc_problem *, int64_t iteration, double kkt);
  /** Adds a remark to rc_result.note, "solver: what was done instead, what is wrong with the answer". A later one that
   *  begins with the same words up to the colon replaces it. */
  void (*note)(const rc_problem *, const char *text);

  /* Products */
  /** y = H x. Counts and polls; a status other than 0 must be returned at once (it may be a stop). */
  rc_status (*apply)(const rc_problem *, const double *x, double *y);
  /** y = H x in single precision. NULL if the backend has none. */
  rc_status (*apply_float)(const rc_problem *, const float *x, float *y);
  /** H at the offsets (ix, iy), 0 <= ix < mx, 0 <= iy < my, into out[iy*mx + ix]; periodic: without its mean. NULL without
   *  a grid. */
  rc_status (*coefficients)(const rc_problem *, int64_t mx, int64_t my, double *out);
  /** A solver that multiplies by itself, by an H that it makes from coefficients(), reports here how many products it has made
   *  since the last report: rc_result counts them. */
  void (*multiplied)(const rc_problem *, int64_t products);

  /* Solving */
  /** H[a,a] x = b for ascending positions a: the backend's, or conjugate gradients from the x given (finite) to a
   *  thousandth of tol. NULL if fallbacks are off. */
  rc_status (*subset)(const rc_problem *, int64_t na, const int64_t *a, const double *b, double *x);
  /** (H + rho I) x = b: the backend's, or conjugate gradients to a relative residual of tol. x: start in, answer
   *  out. NULL if fallbacks are off and the backend has none. */
  rc_status (*shifted)(const rc_problem *, double rho, double tol, const double *b, double *x);
  /** The Frobenius norm of H. NULL if the backend has no norm(). */
  rc_status (*norm)(const rc_problem *, double *out);
  /** APPROACH: another solver ("auto": one that suits the backend) on this problem with pressure at the na ascending
   *  positions a only. p [n]: start in (its other values do not matter), answer out (0 elsewhere). product: NULL, or [n]
   *  out, H p. */
  rc_status (*inner)(const rc_problem *, const char *solver, int64_t na, const int64_t *a, double tol, double *p,
                     double *product);
  /** Solves on a coarser grid; NULL without a grid. RC_OK: certified. */
  rc_status (*coarse)(const rc_problem *, rc_coarse *);
  int32_t factors;     /* 1: subset() is the backend's factorisation; 0: iterations with products              */
  int32_t reserved;

  /* Device */
  const rc_kept_steps *kept; /* NULL: no later step starts from this answer as it is                           */

  /* Rows */
  /** For solvers that are built into the library (RC_TAKES_ROWS), which use more of the exchange between ranks than rc_rows has.
   *  NULL: this process has the whole grid. Else the unknowns are every point of this rank's rows, masked ones included, whose gap
   *  is then far above the others; the grid's nx and ny are of all rows, its arrays of these, and so are those of coarse(). */
  const rc_rows *rows;
};

/** A solver's report of one step of one of many contacts; in the caller's units. */
typedef struct rc_many_answer {
  int32_t solved; /* 1: every residual below is at most rc_many.tol, in all steps before it as well; 0: the rest is not read */
  int32_t reserved;
  int64_t contacts;   /* points with p > 0                                                                     */
  int64_t iterations, products;
  double sum;         /* of the pressures [force/length^2]                                                     */
  double lowest;      /* gap of a point that may carry pressure, plastic indentation included [length]         */
  double compression; /* approach less the lowest gap [length]                                                 */
  double primal, dual, complementarity; /* residuals as rc_result.kkt_*, from a product in double precision with the final
                                           pressures over all points                                           */
} rc_many_answer;

/** Histories of many contacts on one half-space grid, in the caller's units; arrays as in rc_batch. */
typedef struct rc_many rc_many;
struct rc_many {
  size_t struct_size;

  /* The contacts */
  int64_t n;            /* contacts; 0: a question whether the solver takes such contacts, with RC_OK as "yes" */
  int64_t steps;        /* >= 1, of each                                                                       */
  int32_t control;      /* RC_CONTROL_*                                                                        */
  int32_t warm_start;   /* 1: steps after the first start from the one before                                  */
  const rc_grid *grid;  /* without gap, mask, index and approach                                               */
  const double *targets;         /* [length] or [force]; step k of contact i at i*target_stride + k            */
  int64_t target_stride;
  const double *undeformed_gap;  /* [length]; point m of contact i at i*undeformed_gap_stride + m; any values  */
  int64_t undeformed_gap_stride; /* 0: one for all                                                             */
  const uint8_t *mask;           /* NULL: every point                                                          */
  int64_t mask_stride;
  const double *p0;     /* [n*nx*ny] to start from [force/length^2]; NULL: none                                */
  double hardness;      /* [force/length^2]; INFINITY if all is elastic                                        */
  double tol;           /* of the certificate                                                                  */
  int64_t max_iterations;  /* of a step                                                                        */

  /* H */
  const char *backend;  /* whose products are to certify: a solver takes contacts for those it can stand for   */
  double length_per_pressure; /* [length^3/force] H is this times coefficients()                               */
  double least_deflection; /* [length^3/force] of a cell under unit pressure, for the scale of residuals       */
  /** As rc_problem.coefficients. */
  rc_status (*coefficients)(const rc_many *, int64_t mx, int64_t my, double *out);

  /* Out */
  double *p;            /* [n*steps*nx*ny] of every step that is solved                                        */
  rc_many_answer *answers; /* [n*steps]                                                                        */
  int64_t done;         /* contacts 0 .. done-1 have answers, at least one; the others are asked for again     */
};

/* Needs and abilities of a solver (rc_solver.needs). RC_CAP_SUBSET and RC_CAP_SHIFTED are also needs: if the backend lacks the
 * function, the library solves by conjugate gradients instead. */
#define RC_NEEDS_GRID (UINT64_C(1) << 32) /* a half-space grid, not the caller's matrix or product              */
#define RC_WANTS_BOX (UINT64_C(1) << 33)  /* every point of a box as an unknown is handier than most of them    */
#define RC_READS_GAP (UINT64_C(1) << 34)  /* rc_problem.u may be NULL if there is a grid: the solver works with
                                             u = (grid->approach - grid->undeformed_gap) / length              */
#define RC_READS_SINGLE_GAP (UINT64_C(1) << 35) /* reads rc_grid.undeformed_gap of type RC_SINGLE as well        */
#define RC_TAKES_CAP (UINT64_C(1) << 36)  /* keeps p <= cap; without it the core refuses a step with a hardness */
#define RC_TAKES_ROWS (UINT64_C(1) << 37) /* built-in solvers only: reads rc_problem.rows                       */

/** A solver. It never knows which backend multiplies. */
typedef struct rc_solver {
  size_t struct_size;

  /* Required */
  const char *name;
  const char *summary;
  const char *license;
  uint64_t needs;    /* RC_CAP_SUBSET, RC_CAP_SHIFTED, RC_NEEDS_GRID, RC_WANTS_BOX, RC_READS_*, RC_TAKES_* or 0 */
  uint32_t controls; /* bit RC_CONTROL_*: the controls it handles itself. Load control is added to a
                        approach solver by the core's iteration on the approach                            */
  uint32_t reserved;
  int64_t n_options;
  const rc_component *const *options;
  /** p: start in, solution out; *d: approach (LOAD: start in, answer out). RC_OK only if the solver believes
   *  that tol is met; the core checks. p must be usable at every return >= 0. */
  rc_status (*solve)(const rc_host *, const rc_problem *, const rc_options *, double *p, double *d);

  /* Choice, optional */
  /** As that of a backend, for one that facts->backend and facts->caps describe. */
  rc_status (*score)(const rc_facts *, rc_estimate *);

  /* Many contacts at once, optional */
  /** Solves and certifies many at once, by products of its own; its answer for one contact does not depend on the others. The core
   *  checks the answers: all against their pressures, and by products of its own the residuals of one contact in 64, but of 8 at
   *  least (all if there are fewer), chosen at random afterwards, and of each that reports a residual above tol/2. If one is not as
   *  reported, the core drops the whole call and solves its contacts one at a time, as it does with those that are not solved, or
   *  with all after a status other than RC_OK. Several threads may call it at the same time. */
  rc_status (*solve_many)(const rc_host *, rc_many *, const rc_options *);
} rc_solver;

/* Boundaries for which a kernel is defined, and its promises. */
#define RC_KERNEL_FREE (UINT64_C(1) << 0)      /* free boundaries: has window()                                          */
#define RC_KERNEL_PERIODIC (UINT64_C(1) << 1)  /* periodic boundaries: has symbol()                                      */
#define RC_KERNEL_SQUARE (UINT64_C(1) << 2)    /* cells must be square                                                   */
#define RC_KERNEL_POSITIVE (UINT64_C(1) << 3)  /* no coefficient of window() is negative                                 */
#define RC_KERNEL_FAR_FIELD (UINT64_C(1) << 4) /* from 16 cells on it deflects as loads on the half-space near the cell's
                                                  centre would, to 1e-9                                                  */
#define RC_KERNEL_SEMI_PERIODIC (UINT64_C(1) << 5) /* grids that repeat along one axis: has window()                     */
#define RC_KERNEL_HOMOGENEOUS (UINT64_C(1) << 6) /* H is that of a homogeneous elastic half-space, but for what the cells leave out;
                                                without it contacts have no conductance                               */

typedef struct rc_kernel rc_kernel;

/** A request for a kernel's values. Valid during the call. */
typedef struct rc_kernel_spec {
  size_t struct_size;
  const rc_kernel *kernel;
  const rc_system *system;   /* dimensionless: modulus 1. nx and ny matter only where the grid repeats                   */
  const rc_options *options; /* read through rc_host                                                                     */
  double length;             /* how long 1 in `system` is for the caller [length]                                        */
  double modulus;            /* E* of the caller [force/length^2]                                                        */
} rc_kernel_spec;

/** A kernel: what unit pressure on a cell deflects, times the modulus. Functions are called from several threads at the same
 *  time; what they return depends on the spec only. The library checks the values: RC_ERR_NUMERIC if H cannot be positive
 *  definite or a promise is seen to be broken; the message has the offsets and values. */
struct rc_kernel {
  size_t struct_size;

  /* Required, and one of window and symbol at least */
  const char *name;
  const char *summary;
  const char *license;
  uint64_t caps; /* RC_KERNEL_*                                                                                          */
  int64_t n_options;
  const rc_component *const *options; /* keys "<name>.<key>"; all are fixed when a contact is made                     */
  /** RC_KERNEL_FREE or _SEMI_PERIODIC, else NULL: coefficients at the offsets (first_x + ix, first_y + iy) cells,
   *  0 <= ix < mx, 0 <= iy < my, into out[iy*mx + ix] [length]. A value depends on its offset, not on the window. Those at -x
   *  and -y are equal. On a grid that repeats along x, values at x and nx - x are equal as well (along y: y and ny - y). The
   *  library compares all that it uses, so it asks such a kernel for both; they may differ by 1e-11 of the value at (0, 0). */
  rc_status (*window)(const rc_host *, const rc_kernel_spec *, int64_t first_x, int64_t first_y, int64_t mx, int64_t my,
                      double *out);
  /** RC_KERNEL_PERIODIC, else NULL: eigenvalues of H at wave numbers kx = 0..nx/2, ky = 0..ny/2 into out[ky*(nx/2+1) + kx]
   *  [length]; those at nx-kx and ny-ky are equal. The mean's, out[0], is not looked at: it counts as 0. */
  rc_status (*symbol)(const rc_host *, const rc_kernel_spec *, double *out);

  /* Optional */
  /** Promises about the spectrum, for any set of cells; proven intervals of load and area rest on them. *lowest: no eigenvalue of
   *  H is smaller; PERIODIC: but the mean's. The lowest eigenvalue of a symbol is looked up, and compared with it. *galerkin_share:
   *  FREE: x'Hx is at least this times that of the kernel galerkin, for every x; else not looked at. Both are 0 before the call,
   *  which promises nothing, as NULL does. */
  rc_status (*bounds)(const rc_host *, const rc_kernel_spec *, double *lowest, double *galerkin_share);
  void *user; /* not looked at                                                                                           */
};

typedef struct rc_plugin {
  size_t struct_size;
  uint32_t abi_major, abi_minor; /* RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR                                   */
  const char *name;              /* as in the file name                                                        */
  const char *version;
  int64_t n_backends, n_solvers, n_kernels;
  const rc_backend *const *backends;
  const rc_solver *const *solvers;
  const rc_kernel *const *kernels;
} rc_plugin;

/** The one symbol a plugin file exports. *out points to static data. May refuse with host->fail. */
typedef rc_status (*rc_plugin_query_fn)(const rc_host *, const rc_plugin **out);

/** Adds a plugin that is linked into the host program: all of it or, on failure, nothing. What it points to must
 *  live as long as the process. Errors: ARGUMENT, PLUGIN. */
RC_API rc_status rc_context_register(rc_context *context, const rc_plugin *plugin);

#ifdef __cplusplus
#define RC_PLUGIN_LINKAGE extern "C"
#else
#define RC_PLUGIN_LINKAGE
#endif
#ifdef RC_PLUGIN_BUILTIN
#define RC_PLUGIN_ENTRY(name, host, out) \
  RC_PLUGIN_LINKAGE rc_status rc_builtin_##name(const rc_host *host, const rc_plugin **out)
#else
#define RC_PLUGIN_ENTRY(name, host, out)                                                          \
  RC_PLUGIN_LINKAGE RC_PLUGIN_API rc_status rc_plugin_query(const rc_host *, const rc_plugin **); \
  RC_PLUGIN_LINKAGE RC_PLUGIN_API rc_status rc_plugin_query(const rc_host *host, const rc_plugin **out)
#endif

#ifdef __cplusplus
}
#endif
#endif
