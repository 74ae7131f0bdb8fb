/* rc_mpi_exchange_*: the exchange of <roughcontact/ranks.h> over a duplicate of the caller's communicator. */
#include <roughcontact/mpi.h>
#include <stdlib.h>

#include "exchange.h"

/* Into a struct of the caller's, which may be larger. */
static void put(rc_exchange* to, rc_exchange from) {
  from.struct_size = to->struct_size;
  *to = from;
}

static void release(struct rc_mpi_link* link) {
  int over = 0;
  MPI_Finalized(&over);
  if (!over && link->comm != MPI_COMM_NULL) MPI_Comm_free(&link->comm);
  free(link->counts);
  free(link->places);
  free(link);
}

static struct rc_mpi_link* link_of(MPI_Comm comm) {
  struct rc_mpi_link* const link = calloc(1, sizeof *link);
  if (!link) return NULL;
  link->comm = MPI_COMM_NULL;
  MPI_Comm_size(comm, &link->ranks);
  MPI_Comm_rank(comm, &link->rank);
  link->counts = calloc((size_t)link->ranks, 2 * sizeof(int));
  link->places = calloc((size_t)link->ranks, 2 * sizeof(int64_t));
  if (link->counts && link->places) return link;
  release(link);
  return NULL;
}

/* The exchange over a communicator that is valid; refused if it fails on any rank. here: this rank can take part. */
static rc_exchange exchange_over(MPI_Comm comm, int here) {
  rc_exchange none = RC_EXCHANGE_INIT;
  struct rc_mpi_link* const link = here ? link_of(comm) : NULL;
  int enough = here ? (link ? 2 : 1) : 0, least = 0;
  if (MPI_Allreduce(&enough, &least, 1, MPI_INT, MPI_MIN, comm) != MPI_SUCCESS)
    none.refused = "MPI_Allreduce failed";
  else if (least == 0)
    none.refused = "a rank gives no rc_exchange with RC_EXCHANGE_INIT";
  else if (least == 1)
    none.refused = "a rank has no memory left for an exchange";
  else if (MPI_Comm_dup(comm, &link->comm) == MPI_SUCCESS) {
    MPI_Comm_set_errhandler(link->comm, MPI_ERRORS_RETURN);
    return rc_mpi_exchange(link);
  } else {
    link->comm = MPI_COMM_NULL;
    none.refused = "MPI_Comm_dup failed";
  }
  if (link) release(link);
  return none;
}

rc_status rc_mpi_exchange_create(MPI_Comm comm, rc_exchange* out) {
  const int here = out && out->struct_size >= sizeof *out;
  const char* const why = rc_mpi_refuse(comm);
  rc_exchange made = RC_EXCHANGE_INIT;
  if (why)
    made.refused = why;
  else
    made = exchange_over(comm, here);
  if (here) put(out, made);
  if (!made.refused) return RC_OK;
  rc_contact* none = NULL;
  return rc_ranks_contact_create(&made, NULL, NULL, &none); /* sets the message */
}

rc_status rc_mpi_exchange_create_f(MPI_Fint comm, rc_exchange* out) { return rc_mpi_exchange_create(MPI_Comm_f2c(comm), out); }

void rc_mpi_exchange_destroy(rc_exchange* exchange) {
  const rc_exchange none = RC_EXCHANGE_INIT;
  if (!exchange) return;
  if (exchange->user) release(exchange->user);
  put(exchange, none);
}
