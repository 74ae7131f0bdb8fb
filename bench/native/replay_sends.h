/* MPI_Isend, MPI_Irecv and MPI_Waitall of mpi/exchange.c in replay.c; see replay_sends.c. */
#ifndef REPLAY_SENDS_H
#define REPLAY_SENDS_H

#include <mpi.h>

void replay_sends_begin(MPI_Comm comm);
void replay_sends_end(void);

#endif
