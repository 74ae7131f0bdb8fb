/* rc_mpi_*: the functions of <roughcontact/ranks.h> on a duplicate of the caller's communicator. */
#include <roughcontact/mpi.h>
#include <stdlib.h>

#include "exchange.h"

struct rc_mpi_contact {
  struct rc_mpi_link link;
  rc_ranks_contact* contact;
};

/* Has the core set the message, and returns its status. */
static rc_status refused(const char* why) {
  rc_exchange none = RC_EXCHANGE_INIT;
  rc_ranks_contact* contact = NULL;
  none.refused = why;
  return rc_ranks_contact_create(&none, NULL, NULL, &contact);
}

rc_status rc_mpi_rows(MPI_Comm comm, const rc_system* system, int64_t* first, int64_t* count) {
  int rank = 0, ranks = 1;
  const char* const why = rc_mpi_refuse(comm);
  if (why) return refused(why);
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  return rc_ranks_rows(rank, ranks, system, first, count);
}

static void release(rc_mpi_contact* contact) {
  int over = 0;
  rc_ranks_contact_destroy(contact->contact);
  MPI_Finalized(&over);
  if (!over && contact->link.comm != MPI_COMM_NULL) MPI_Comm_free(&contact->link.comm);
  free(contact->link.counts);
  free(contact->link.places);
  free(contact);
}

rc_status rc_mpi_contact_create(MPI_Comm comm, const rc_system* system, const rc_options* options, rc_mpi_contact** out) {
  const char* const why = rc_mpi_refuse(comm);
  rc_mpi_contact* made = NULL;
  rc_exchange exchange;
  rc_status status;
  int ranks = 1, enough = 0, enough_everywhere = 0;
  if (out) *out = NULL;
  if (why) return refused(why);
  MPI_Comm_size(comm, &ranks);
  made = calloc(1, sizeof *made);
  if (made) {
    made->link.comm = MPI_COMM_NULL;
    made->link.ranks = ranks;
    MPI_Comm_rank(comm, &made->link.rank);
    made->link.counts = calloc((size_t)ranks, 2 * sizeof(int));
    made->link.places = calloc((size_t)ranks, 2 * sizeof(int64_t));
    enough = made->link.counts && made->link.places;
  }
  if (MPI_Allreduce(&enough, &enough_everywhere, 1, MPI_INT, MPI_MIN, comm) != MPI_SUCCESS || !enough_everywhere) {
    if (made) release(made);
    return refused("a rank has no memory left for a contact");
  }
  if (MPI_Comm_dup(comm, &made->link.comm) != MPI_SUCCESS) {
    made->link.comm = MPI_COMM_NULL;
    release(made);
    return refused("MPI_Comm_dup failed");
  }
  MPI_Comm_set_errhandler(made->link.comm, MPI_ERRORS_RETURN);
  exchange = rc_mpi_exchange(&made->link);
  status = rc_ranks_contact_create(&exchange, system, options, out ? &made->contact : NULL);
  if (status != RC_OK) {
    release(made);
    return status;
  }
  *out = made;
  return RC_OK;
}

void rc_mpi_contact_destroy(rc_mpi_contact* contact) {
  if (contact) release(contact);
}

rc_status rc_mpi_contact_solve(rc_mpi_contact* contact, const rc_step* step, rc_result* result) {
  return rc_ranks_contact_solve(contact ? contact->contact : NULL, step, result);
}

rc_status rc_mpi_contact_solve_history(rc_mpi_contact* contact, rc_history* path) {
  return rc_ranks_contact_solve_history(contact ? contact->contact : NULL, path);
}

rc_status rc_mpi_contact_certify(rc_mpi_contact* contact, const rc_step* step, rc_result* result) {
  return rc_ranks_contact_certify(contact ? contact->contact : NULL, step, result);
}

rc_status rc_mpi_contact_counts(rc_mpi_contact* contact, rc_ranks_counts* out) {
  return rc_ranks_contact_counts(contact ? contact->contact : NULL, out);
}
