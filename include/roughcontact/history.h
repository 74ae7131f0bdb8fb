/* roughcontact: loading histories, of one contact and of many in one call; restarts; the coarse solutions of multilevel solvers. */
#ifndef ROUGHCONTACT_HISTORY_H
#define ROUGHCONTACT_HISTORY_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup history History: steps of one contact in order  @{ */
/** Called after each completed step 0 .. n-1 of a history, on the solving thread, with pressures and gap that last until
 *  it returns. May call only rc_contact_cancel, and rc_contact_points, which answers for this step. Return nonzero to end the
 *  history. Must return: no exception, no longjmp. */
typedef int32_t (*rc_history_fn)(int64_t step, const rc_result *result, void *user);

/** Numbers of steps: of each that a caller wants, an array with one value a step, double unless said otherwise. */
typedef struct rc_columns {
  rc_array load;        /* out [force]                                                                               */
  rc_array approach;    /* out [length]                                                                              */
  rc_array contact_area; /* out [length^2]                                                                            */
  rc_array mean_gap;    /* out [length]; if wanted, g is computed at all points, as for a gap that is wanted       */
  rc_array energy;      /* out [force length]                                                                        */
  rc_array stiffness;   /* out, dW/dd [force/length]; if wanted it is computed, whatever option stiffness is       */
  rc_array load_lower, load_upper; /* out, proven interval as in rc_result [force]; if one that ends with _lower
                           or _upper is wanted, intervals are proven, whatever option bounds is                      */
  rc_array area_lower, area_upper; /* out [length^2]                                                                 */
  rc_array stiffness_lower, stiffness_upper; /* out [force/length]; if one is wanted, option stiffness counts as 2 */
  rc_array certificate; /* out, the largest kkt_* residual                                                           */
  rc_array iterations;  /* out, int64_t: of the solver                                                                     */
  rc_array products;    /* out, int64_t: products with H                                                                   */
  rc_array status;      /* out, rc_status                                                                       */
} rc_columns;

/** A loading history: increasing, decreasing or mixed. Arrays of length n. */
typedef struct rc_history {
  size_t struct_size;
  int32_t control;      /* RC_CONTROL_*                                                                              */
  int32_t warm_start;   /* 1: each step starts from the pressures of the one before, projected onto the points
                           that the new approach can reach (default); 0: each step starts cold                       */
  int64_t n;            /* steps                                                                                     */
  rc_const_array targets; /* double [n] of the control, as rc_step.target                                            */
  rc_const_array undeformed_gap; /* as rc_step.undeformed_gap, for all steps; in the host's memory                   */
  rc_const_array mask;  /* as rc_step.mask; in the host's memory                                                     */
  rc_history_fn fn;     /* sees each completed step's result with pressures and gap; NULL: none                      */
  void *user;           /* handed to fn                                                                              */
  int64_t completed;    /* out: steps whose outputs are written; certified, or within goal                           */
  int32_t want_gap;     /* 1: fn sees the deformed gap (default); 0: its result->gap is none, so that sparse contact
                           costs no product over the whole grid                                                      */
  int32_t virgin;       /* 0: with a hardness or creep, each step presses the surface as the steps before it left it (default);
                           1: each presses the surface as it is before the first step, and the history leaves nothing:
                           rc_contact_indentation and rc_contact_creep give afterwards what they gave before         */
  rc_columns columns;   /* out: numbers of each completed step                                                       */
  rc_const_array times; /* double [n] as rc_step.time, none before the one before it; none: without creep            */
} rc_history;
#define RC_HISTORY_INIT RC_BEGIN_WITH_TWO(rc_history, warm_start = 1, want_gap = 1)

/** Solves the steps of a loading history in order. A step that fails or is not certified ends the history with its
 *  status; the steps before it stay written, `completed` says how many. RC_STOP_CANCELLED if fn ended it (that step
 *  counts as completed). RC_WITHIN_GOAL: all steps are written, some with this status. Errors: as rc_contact_solve. */
RC_API rc_status rc_contact_solve_history(rc_contact *contact, rc_history *history);
/** @} */

/** @defgroup plastic Plastic indentation  @{ */
/** The plastic indentation that the contact's steps have left [n]: the sum over all steps with RC_OK of the overlap -g where
 *  p = rc_system.hardness [length]; zeros before the first such step and without a hardness. The next step adds it to
 *  rc_step.undeformed_gap, also to one that is given anew: give the surface as it was before the first step. A failed, stopped
 *  or refused step and rc_contact_certify leave it as it is; rc_contact_reset forgets it. indentation: double [n].
 *  Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_indentation(rc_contact *contact, rc_array indentation);
/** @} */

/** @defgroup creep Creep  @{ */
/** The creep that the contact's certified steps have left in its bodies (rc_system.creep_terms, K): double [(K+1) n], first H p of
 *  the last one at once, then for each term of the series the deflection that H p has reached with its time, without its ratio
 *  [length]. After RC_CREEP_MODULI the terms are those of the compliance that belongs to them, by ascending times. *time: of that
 *  step, or NaN if there was none; may be NULL. Steps leave it if they leave a plastic indentation, see rc_contact_indentation.
 *  Errors: ARGUMENT (also without creep), BUSY. */
RC_API rc_status rc_contact_creep(rc_contact *contact, rc_array creep, double *time);
/** @} */

/** @defgroup restart Restart  @{ */
/** The state of a loading history, for rc_contact_restore: values of rc_result from its last two steps with RC_OK or
 *  RC_WITHIN_GOAL. All of it is copied. */
typedef struct rc_state {
  size_t struct_size;
  rc_const_array undeformed_gap; /* double [n] of the last step [length]                                             */
  rc_const_array mask;  /* uint8_t [n] its mask; none: all points                                                    */
  rc_const_array p;     /* double [n] its pressures [force/length^2]; none: there was no such step                   */
  double approach;      /* rc_result.approach [length]                                                               */
  double load;          /* rc_result.load [force]                                                                    */
  rc_const_array p_before; /* double [n] the same of the step before it; none: no such step, or its surface was another */
  double approach_before, load_before;
  rc_const_array indentation; /* double [n] of rc_contact_indentation after its last step, >= 0 [length]; none: zeros */
  rc_const_array creep; /* double [(K+1) n] of rc_contact_creep after its last step; needed with creep if there is p */
  double time;          /* the time of rc_contact_creep; NaN: no step has left anything, creep is not read           */
} rc_state;
#define RC_STATE_INIT RC_BEGIN(rc_state)

/** Sets the contact, a new one or one that has solved steps, to the state of another one of the same system and options after a
 *  certified step: the next steps start from the same pressures and approaches. With option resumable = 1, in the contact that
 *  solved and in this one, they give the same bits, for every solver and backend; without it to round-off, since operators may
 *  remember more. A call that fails changes nothing. Errors: ARGUMENT, MEMORY, BUSY. */
RC_API rc_status rc_contact_restore(rc_contact *contact, const rc_state *state);
/** @} */

/** @defgroup batch Batch: many contacts in one call  @{ */
/** Called after each step with status >= 0, on the thread that solves it, with pressures and gap that last until it returns.
 *  The steps of one contact come in order; those of different contacts in any order and, with several threads, at the same
 *  time. Return nonzero to end the batch: fn is then not called for further steps. Must return: no exception, no longjmp. */
typedef int32_t (*rc_batch_fn)(int64_t contact, int64_t step, const rc_result *result, void *user);

/** Called after each step that is solved by itself and after each group of contacts that are solved at once, on the thread that did
 *  so; by several threads at the same time. ended: steps of the batch with outputs, so far; in any order where there are
 *  several threads. Return nonzero to end the batch. Must return: no exception, no longjmp. */
typedef int32_t (*rc_batch_progress_fn)(int64_t ended, void *user);

enum { RC_BATCH_SHARED = -1 }; /* as a stride: one array for all contacts                                            */

/** The loading histories of many contacts on one system: surfaces of a Monte Carlo study, Gauss points of a finite element
 *  code. */
typedef struct rc_batch {
  size_t struct_size;
  int32_t control;      /* RC_CONTROL_*                                                                              */
  int32_t warm_start;   /* as in rc_history, from a contact's second step on                                            */
  int64_t n;            /* contacts                                                                                  */
  int64_t steps;        /* of each history                                                                           */
  rc_const_array targets; /* double: of the control, as rc_step.target; step k of contact i at i*target_stride + k   */
  int64_t target_stride; /* in values, as all strides. 0: steps; RC_BATCH_SHARED; else >= steps                      */
  rc_const_array undeformed_gap; /* as rc_step.undeformed_gap, in the host's memory, as the other arrays; point m of contact i
                           at i*undeformed_gap_stride + m                                                            */
  int64_t undeformed_gap_stride; /* 0: nx*ny; RC_BATCH_SHARED; else >= nx*ny                                         */
  rc_const_array mask;  /* as rc_step.mask; point m of contact i at i*mask_stride + m; none: all points              */
  int64_t mask_stride;  /* as undeformed_gap_stride                                                                  */
  rc_const_array p0;    /* [n*nx*ny] as rc_step.p0, for the first step of each contact; may be p; none: no such start */
  rc_array p;           /* out [n*nx*ny] pressures of a contact's last step with status >= 0 [force/length^2];
                           untouched for a contact that has none                                                     */
  rc_batch_fn fn;       /* sees each step's result with pressures and gap; NULL: none                                */
  void *user;           /* handed to fn and progress                                                                 */
  int64_t written;      /* out: contacts whose outputs are written: n, or 0 if the call itself was refused           */
  int64_t certified;    /* out: contacts of which every step is certified                                            */
  int64_t first;        /* out: the contact whose status is returned; -1: none, or RC_WITHIN_GOAL                    */
  rc_batch_progress_fn progress; /* sees how far the batch is; NULL: none                                            */
  int32_t virgin;       /* as in rc_history; each contact begins without indentation and creep in any case           */
  int32_t reserved;     /* 0                                                                                         */
  rc_columns columns;   /* out: numbers of step k of contact i at index i*steps + k; NaN (counts: -1) for a step with status
                           < 0 and those that were not reached. The first step that is neither RC_OK nor RC_WITHIN_GOAL ends
                           its contact, and the steps after it have its status. RC_STOP_CANCELLED or RC_STOP_TIME also if
                           the batch ended before the step                                                           */
  rc_const_array times; /* double, laid out as targets: of each step, as rc_step.time; none: without creep           */
} rc_batch;
#define RC_BATCH_INIT RC_BEGIN_WITH_TWO(rc_batch, warm_start = 1, first = -1)

/** Solves the history of every contact, each as by an rc_contact of its own and rc_contact_solve_history: the same bits, whatever
 *  the number of threads. A solver that takes many contacts at once ("haar-cuda") gives other bits than contacts of their own,
 *  with the same certificate; they do not depend on the number of threads and contacts either. It is used if fn and the columns
 *  from mean_gap to stiffness_upper are not wanted, all arrays are doubles, virgin is 0, control is not RC_CONTROL_AREA and nothing
 *  creeps.
 *  Option threads: contacts that are solved at the same time, each by one thread; fewer if the system refuses threads.
 *  Option time_limit: seconds for the whole batch. options may be NULL. A CALLBACK system's apply is called from several threads
 *  at the same time. All threads have ended when the call returns.
 *  A contact that fails does not stop the others. RC_OK: every step of every contact is certified. Otherwise the status of the
 *  first contact that failed or, if none did, of the first that is not certified, and rc_last_error() says how many
 *  contacts ended with which status. RC_WITHIN_GOAL: some steps ended so, all others are certified. All outputs are then
 *  written (rc_batch.written is n). RC_STOP_CANCELLED if fn or progress ended the batch and no contact failed: what was
 *  complete stays.
 *  Errors: as rc_contact_create and rc_contact_solve; ARGUMENT and SHAPE for the batch itself, with written = 0. */
RC_API rc_status rc_batch_solve(const rc_system *system, const rc_options *options, rc_batch *batch);
/** @} */

/** @defgroup level Coarse solutions  @{ */
/** A solution on a coarser grid that a multilevel solver left behind. The caller sets p. */
typedef struct rc_level {
  size_t struct_size;
  rc_array p;           /* double [nx*ny] pressures [force/length^2]; none: not wanted. Ask for nx and ny first      */
  rc_status status;     /* of this solution on its grid                                                              */
  int32_t reserved;
  int64_t nx, ny;
  double hx, hy;        /* cell size [length]                                                                        */
  double approach;      /* on this grid [length]                                                                     */
  double load;          /* [force]                                                                                   */
  int64_t candidates;   /* points that were allowed pressure                                                         */
  int64_t contacts;     /* points with p > 0                                                                         */
} rc_level;
#define RC_LEVEL_INIT RC_BEGIN_WITH(rc_level, status = RC_ERR_ARGUMENT)

/** The i-th coarse solution of the last step, 0 (coarsest) .. rc_result.levels-1. Errors: ARGUMENT, BUSY. */
RC_API rc_status rc_contact_level(rc_contact *contact, int64_t i, rc_level *out);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
