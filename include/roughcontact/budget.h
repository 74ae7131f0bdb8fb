/* roughcontact-request: how sure the numbers of a contact are, if the map, the moduli and the load are known only within limits.
 *
 * A certified answer is a checked solution of the discrete problem. It is no calibrated measurement: that the problem has the right
 * heights, pitch and moduli is another question, which a budget answers in the manner of the Guide to the Expression of Uncertainty
 * in Measurement (JCGM 100:2008). Each source changes the problem, the contact is solved again, and the change of each quantity is
 * its contribution. Sources are taken as independent.
 *
 * Sources are a text, "noise=20nm,pitch=1%,E=5%,grid". An uncertainty is a standard one, a share as 5% or absolute with a unit.
 *
 *   source                changes                                                contribution                      solves
 *   noise=20nm            heights, by independent normal numbers; with           standard deviation of samples; by derivatives
 *     [correlation=2um]   correlation c they are correlated as exp(-(r/c)^2)     if they agree; and a shift        samples
 *   pitch=1%, height=2%   pitch, heights without the nominal shape               half of y(+u) - y(-u)             2
 *   E=5% (modulus, E, nu, E2, nu2, hardness, approach, load, pressure, area)     the same                          2
 *   bandwidth=2um         waves below this length are filtered out (Gaussian)    |change| / sqrt(3)                1
 *   remove=plane          another levelling: none, mean, plane, quadric          |change| / sqrt(3)                1
 *   missing               missing points excluded in place of filled, or         |change| / sqrt(3)                1
 *                         the other way round
 *   shift=2um             the other body, by up to this along x and y, cyclic,   standard deviation of samples     samples
 *                         by whole cells
 *   window=2              2 x 2 parts of the map, each for itself                their standard deviation / 2      4
 *   maps=b.gsf;c.gsf      the surface, by others of the same kind and nominal    standard deviation of all,        1 a map
 *                         area (within 1 %); or maps alone, and rc_map "maps"    the surface among them
 *   grid                  means over 2 x 2 and 4 x 4 points                      extrapolated error                2
 *   solver                nothing; it is always in the budget                    half the proven interval / sqrt(3)  0
 *   samples=16, seed=1    how many samples, and which
 *
 * Functions are thread-safe, keep nothing and print nothing; rc_request_last_error() has the text of the calling thread's last
 * failure. Sized structs: see roughcontact.h. Memory: about 12 arrays of the grid beside those of the contact, and one
 * for each of the other maps.
 */
#ifndef ROUGHCONTACT_BUDGET_H
#define ROUGHCONTACT_BUDGET_H

#include "request.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup budget Budget of uncertainties  @{ */
/** Called on the calling thread at least once in each solve: solves that have ended, and all of them. Return nonzero to end the
 *  budget with RC_STOP_CANCELLED. Must return: no exception, no longjmp. */
typedef int32_t (*rc_budget_progress_fn)(int64_t ended, int64_t all, void *user);

/** One more quantity of each solve, such as a leak: *value, and between *lower and *upper the exact one of this grid (NaN, as they
 *  come: not known). result has p and gap; mask: [ny*nx], 0 at points that carry no pressure. On the calling thread. Return nonzero
 *  to end the budget with RC_ERR_EXTERNAL. Must return: no exception, no longjmp. */
typedef int32_t (*rc_budget_value_fn)(const rc_system *system, const rc_result *result, const uint8_t *mask, void *user,
                                      double *value, double *lower, double *upper);

typedef struct rc_budget_spec {
  size_t struct_size;
  const char *sources;            /* as above                                                                        */
  const rc_options *options;      /* of the solves; NULL: the defaults, with those that the words set                */
  rc_budget_progress_fn progress; /* NULL: none                                                                      */
  void *user;                     /* handed to progress and value                                                    */
  rc_budget_value_fn value;       /* NULL: none                                                                      */
  const char *value_name;         /* "leak"                                                                          */
  const char *value_unit;         /* "m^3/s"; NULL: none                                                             */
} rc_budget_spec;
#define RC_BUDGET_SPEC_INIT RC_BEGIN(rc_budget_spec)

typedef struct rc_budget rc_budget; /* owns what it gives. Read by any thread.                                       */

/** Solves the request for its last target, and again for each source. request: with call SOLVE or HISTORY, one surface, and words
 *  in place of a system; read during the call only. The same request and sources give the same budget.
 *  Status: RC_OK; a positive one of the solve that was stopped, with no budget. Errors: as rc_request_create and rc_contact_solve;
 *  ARGUMENT for sources; NUMERIC for a solve that is not certified. */
RC_API rc_status rc_budget_create(const rc_request_spec *request, const rc_budget_spec *spec, rc_budget **out);
RC_API void rc_budget_destroy(rc_budget *budget);

/** A quantity with its combined uncertainty. Texts live as long as the budget. */
typedef struct rc_budget_quantity {
  size_t struct_size;
  const char *name;      /* "load", "approach", "area" (a share), "mean_pressure", "stiffness", "mean_gap", "conductance":
                            2 stiffness/E*, which is the conductance times the sum of both resistivities [length]; then
                            rc_budget_spec.value_name, if there is a value                                           */
  const char *unit;      /* "N", "m", "", "Pa", "N/m"; "" without units                                              */
  const char *sentence;  /* value, expanded uncertainty and what dominates, for people                               */
  double value;          /* of the request as it is; NaN: not known, such as the stiffness of a caller's choice      */
  double standard;       /* combined standard uncertainty: the root of the sum of squares of all contributions and shifts; in
                            full: the unit of value                                                                  */
  double freedom;        /* effective degrees of freedom (Welch-Satterthwaite); infinite without samples             */
  double coverage;       /* factor for 95 %: 1.96, and more with few samples, as Student's t                         */
  int64_t dominant;      /* index of the source with the largest share; -1: none                                     */
} rc_budget_quantity;
#define RC_BUDGET_QUANTITY_INIT RC_BEGIN(rc_budget_quantity)

/** The contribution of one source to one quantity. */
typedef struct rc_budget_contribution {
  size_t struct_size;
  const char *source;    /* "noise"                                                                                  */
  const char *given;     /* "20nm"                                                                                   */
  double standard;       /* standard uncertainty from this source; NaN: not known                                    */
  double shift;          /* mean change by one more noise of this size, 0 for other sources: the map has such a noise in it, and
                            the quantity is wrong by about this. It is not corrected but counted                     */
  double first_order;    /* the same as standard, by derivatives; NaN where there are none                           */
  double sampled;        /* the same by samples; NaN where there are none                                            */
  double share;          /* (standard^2 + shift^2) / combined^2                                                      */
  int64_t solves;
} rc_budget_contribution;
#define RC_BUDGET_CONTRIBUTION_INIT RC_BEGIN(rc_budget_contribution)

RC_API int64_t rc_budget_quantity_count(const rc_budget *budget); /* NULL: 0                                         */
RC_API int64_t rc_budget_source_count(const rc_budget *budget);   /* NULL: 0                                         */
/** index: 0 .. count - 1. Errors: ARGUMENT. */
RC_API rc_status rc_budget_get_quantity(const rc_budget *budget, int64_t index, rc_budget_quantity *out);
/** quantity, source: 0 .. count - 1. Errors: ARGUMENT. */
RC_API rc_status rc_budget_get_contribution(const rc_budget *budget, int64_t quantity, int64_t source,
                                            rc_budget_contribution *out);
/** @} */

#ifdef __cplusplus
}
#endif
#endif
