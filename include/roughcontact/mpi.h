/* roughcontact over MPI: one contact shared by the ranks of a communicator, each with some rows of the grid.
 *
 * A library of its own, libroughcontact-mpi (pkg-config roughcontact-mpi, CMake roughcontact::mpi). MPI must be initialised, with
 * MPI_THREAD_FUNNELED or more where option threads is above 1. Pressures and every number of a result are the same, bit for bit,
 * for every number of ranks and threads.
 *
 *   int64_t first, count;
 *   rc_mpi_rows(MPI_COMM_WORLD, &system, &first, &count);
 *   // gap: rows first .. first + count - 1, count * nx values; likewise p
 *   rc_mpi_contact *contact;
 *   rc_mpi_contact_create(MPI_COMM_WORLD, &system, NULL, &contact);
 *   rc_mpi_contact_solve(contact, &step, &result);
 *   rc_mpi_contact_destroy(contact);
 *
 * rc_last_error() has the message of the last failure, on every rank the same. */
#ifndef ROUGHCONTACT_MPI_H
#define ROUGHCONTACT_MPI_H

#include <mpi.h>

#include "ranks.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup mpi MPI: a contact shared by the ranks of a communicator  @{ */
/** A contact of which this rank has some rows. Used by the thread that MPI allows to call it. */
typedef struct rc_mpi_contact rc_mpi_contact;

/** The rows of this rank: first .. first + count - 1, in the order of ranks. No communication. Rows are
 *  distributed in pieces of 2^k, k = min(5, log2(ny) / 2) rounded down, so a rank may have none. Errors: ARGUMENT (also null
 *  communicators and intercommunicators). */
RC_API rc_status rc_mpi_rows(MPI_Comm comm, const rc_system *system, int64_t *first, int64_t *count);

/** Every rank of the communicator calls the functions below, with its own rows in the arrays (n = nx * count values) and the same
 *  values in all else. Arrays of a rank without rows are not read. If one rank fails, all return its status, and the message
 *  begins with its number. The communicator is duplicated. Options and other failures: see
 *  rc_ranks_contact_create. */
RC_API rc_status rc_mpi_contact_create(MPI_Comm comm, const rc_system *system, const rc_options *options, rc_mpi_contact **out);
/** Frees the duplicate of the communicator, so all ranks call it before MPI_Finalize. NULL is ignored. */
RC_API void rc_mpi_contact_destroy(rc_mpi_contact *contact);
/** As rc_contact_solve. All members of the result but p and gap are those of the whole grid, and except for seconds the same on
 *  every rank. Errors: as rc_contact_solve, EXTERNAL. */
RC_API rc_status rc_mpi_contact_solve(rc_mpi_contact *contact, const rc_step *step, rc_result *result);
/** As rc_contact_solve_history. */
RC_API rc_status rc_mpi_contact_solve_history(rc_mpi_contact *contact, rc_history *path);
/** As rc_contact_certify. */
RC_API rc_status rc_mpi_contact_certify(rc_mpi_contact *contact, const rc_step *step, rc_result *result);
/** Numbers and bytes of this rank's exchanges since the contact was created. No communication. Errors: ARGUMENT. */
RC_API rc_status rc_mpi_contact_counts(rc_mpi_contact *contact, rc_ranks_counts *out);

/** The same for a communicator's Fortran handle: MPI_Comm_c2f(comm) in C, comm%MPI_VAL in Fortran, comm.py2f() in mpi4py. */
RC_API rc_status rc_mpi_rows_f(MPI_Fint comm, const rc_system *system, int64_t *first, int64_t *count);
RC_API rc_status rc_mpi_contact_create_f(MPI_Fint comm, const rc_system *system, const rc_options *options, rc_mpi_contact **out);
/** @} */

#ifdef __cplusplus
}
#endif

#endif
