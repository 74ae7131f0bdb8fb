/* roughcontact over MPI: one contact shared by the ranks of a communicator, each with some rows of the grid.
 *
 * A library of its own, libroughcontact-mpi (pkg-config roughcontact-mpi, CMake roughcontact::mpi). MPI must be initialised, with
 * MPI_THREAD_FUNNELED or more where option threads is above 1. Pressures and every number of a result are the same, bit for bit,
 * for every number of ranks and threads.
 *
 *   rc_exchange exchange = RC_EXCHANGE_INIT;
 *   rc_mpi_exchange_create(MPI_COMM_WORLD, &exchange);
 *   int64_t first, count;
 *   rc_ranks_rows(&exchange, &system, &first, &count);
 *   // gap: rows first .. first + count - 1, count * nx values; likewise p
 *   rc_contact *contact;
 *   rc_ranks_contact_create(&exchange, &system, NULL, &contact);
 *   rc_contact_solve(contact, &step, &result);
 *   rc_contact_destroy(contact);
 *   rc_mpi_exchange_destroy(&exchange);
 *
 * rc_last_error() has the message of the last failure, on every rank the same. */
#ifndef ROUGHCONTACT_MPI_H
#define ROUGHCONTACT_MPI_H

#include <mpi.h>

#include "ranks.h"

#ifdef __cplusplus
extern "C" {
#endif

/** @defgroup mpi MPI: the exchange of ranks.h over a communicator  @{ */
/** Fills *out, an RC_EXCHANGE_INIT, with an exchange between the ranks of a communicator, which all call this function. The
 *  communicator is duplicated. Contacts made from the exchange use it until they are destroyed, on the thread that MPI allows to
 *  call it. If it fails, out->refused says why, and rc_ranks_rows and rc_ranks_contact_create fail with the same message.
 *  Errors: ARGUMENT (MPI is not initialised, a null communicator, an intercommunicator, no memory on a rank). */
RC_API rc_status rc_mpi_exchange_create(MPI_Comm comm, rc_exchange *out);
/** The same for a communicator's Fortran handle: MPI_Comm_c2f(comm) in C, comm%MPI_VAL in Fortran, comm.py2f() in mpi4py. */
RC_API rc_status rc_mpi_exchange_create_f(MPI_Fint comm, rc_exchange *out);
/** After the contacts made from it. Frees the duplicate of the communicator, so all ranks call it before MPI_Finalize. NULL, an
 *  exchange that was not created and one that is destroyed already: nothing happens. */
RC_API void rc_mpi_exchange_destroy(rc_exchange *exchange);
/** @} */

#ifdef __cplusplus
}
#endif

#endif
