/* The exchange of <roughcontact/ranks.h> by MPI: collectives without threads, one-sided access or anything above MPI-3. */
#ifndef RC_MPI_EXCHANGE_H
#define RC_MPI_EXCHANGE_H

#include <mpi.h>
#include <roughcontact/ranks.h>

struct rc_mpi_link {
  MPI_Comm comm;
  int rank, ranks;
  int* counts;     /* [2 * ranks] of a collective call: counts and places */
  int64_t* places; /* [2 * ranks] of a transposition */
  char text[MPI_MAX_ERROR_STRING + 64];
};

/* NULL, or why this communicator cannot be used. */
const char* rc_mpi_refuse(MPI_Comm comm);
/* The functions over this link. */
rc_exchange rc_mpi_exchange(struct rc_mpi_link* link);

#endif
