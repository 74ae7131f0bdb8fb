/* roughcontact: one contact shared by many processes, each with some rows of the grid. This header has no means of exchange: the
 * caller supplies three functions. <roughcontact/mpi.h> has those of MPI, and is what most programs include.
 *
 * A shared contact is solved by the functions of every contact: rc_contact_solve, rc_contact_solve_history, rc_contact_certify.
 *
 * Pressures and every number of a result are the same, bit for bit, for every number of processes and threads. */
#ifndef ROUGHCONTACT_RANKS_H
#define ROUGHCONTACT_RANKS_H

#include "history.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup ranks Ranks: processes that share a grid  @{ */
/** Communication between the ranks. All ranks call the same function at the same time, on the thread that called
 *  rc_ranks_*; a function returns when this rank's part is done. NULL: done; else a text that says what failed, which lives until
 *  the next call. No exception may leave them. Counts are in bytes and may be 0. */
typedef struct rc_exchange {
  size_t struct_size;
  int64_t rank, ranks; /* 0 <= rank < ranks                                                                          */
  void *user;          /* handed to the functions                                                                    */
  /** Gathers bytes[r] bytes of each rank r, in the order of ranks, on every rank. `mine` may be this rank's place in `all`. */
  const char *(*gather)(void *user, const void *mine, const int64_t *bytes, void *all);
  /** Rank r gets sent[r] bytes of `from`, and gives received[r] bytes of `into`; the parts lie in the order of ranks. */
  const char *(*transpose)(void *user, const void *from, const int64_t *sent, void *into, const int64_t *received);
  /** `sent` bytes to rank `to` and `received` bytes from rank `source`; -1: none. */
  const char *(*shift)(void *user, int64_t to, const void *from, int64_t sent, int64_t source, void *into, int64_t received);
  const char *refused; /* not NULL: why there is no exchange; rc_ranks_contact_create then fails with this message   */
} rc_exchange;
#define RC_EXCHANGE_INIT RC_BEGIN_WITH(rc_exchange, ranks = 1)

/** Numbers and bytes of this rank's exchanges since the contact was created. */
typedef struct rc_ranks_counts {
  size_t struct_size;
  int64_t products;       /* with H, distributed ones                                                               */
  int64_t transpositions; /* two in each product                                                                    */
  int64_t transposed;     /* bytes sent to other ranks in them                                                      */
  int64_t reductions;     /* sums over all ranks                                                                    */
  int64_t reduced;        /* bytes that this rank gave to them                                                      */
  int64_t gathers;        /* other gathers: of coarse levels and grids, sparse contact, what ranks agree on          */
  int64_t gathered;       /* bytes that this rank gave to them                                                      */
  int64_t shifts;         /* exchanges with a neighbour                                                             */
  int64_t shifted;        /* bytes sent in them                                                                     */
  int64_t iterations;     /* steps of the distributed iteration                                                     */
} rc_ranks_counts;
#define RC_RANKS_COUNTS_INIT RC_BEGIN(rc_ranks_counts)

/** The rows of the system's grid that this rank has: first .. first + count - 1 of ny, in the order of ranks. Rows are distributed
 *  in pieces of 2^k, k = min(5, log2(ny) / 2) rounded down, so a rank may have none. No communication; the functions of exchange
 *  may be NULL. Errors: ARGUMENT, SHAPE. */
RC_API rc_status rc_ranks_rows(const rc_exchange *exchange, const rc_system *system, int64_t *first, int64_t *count);

/** A contact of which this rank has some rows. All ranks call this function, and then rc_contact_solve, rc_contact_solve_history
 *  and rc_contact_certify, at the same time, with their own rows in the arrays (iy counts from a rank's first row, n = nx * count)
 *  and the same values in all else. Arrays of a rank without rows are not read. Except for p and gap, a result is that of the whole
 *  grid, and except for seconds the same on every rank. If one rank fails, all return its status, and the message begins with its
 *  number; rc_contact_cancel, the flag of rc_stop_when and the time limit of one rank end the calls of all. One rank may call
 *  rc_contact_destroy without the others. Other functions refuse a shared contact: INCOMPATIBLE.
 *
 *  system: a half-space. If its smaller side is below 32 points, every rank solves the whole problem. Every rank also solves sparse
 *  contact, on gathered tiles, in periodic systems with products of all ranks. Different systems, options or versions are refused:
 *  ARGUMENT. options: as for rc_contact_create; threads: of each rank. `solver` must be auto or haar-cg, `backend` auto or one that
 *  works on rows (fft), `accuracy` 0, `certify_backend` and `warmup` not set: else INCOMPATIBLE. All of exchange but what user
 *  points to is copied. Errors: as rc_contact_create, EXTERNAL (the exchange failed), as have the three functions above. */
RC_API rc_status rc_ranks_contact_create(const rc_exchange *exchange, const rc_system *system, const rc_options *options,
                                         rc_contact **out);
/** No communication. Errors: ARGUMENT, INCOMPATIBLE (no ranks share the contact), BUSY. */
RC_API rc_status rc_ranks_contact_counts(rc_contact *contact, rc_ranks_counts *out);
/** @} */

#ifdef __cplusplus
}
#endif

#endif
