/* Calls of MPI that let others run while they wait: those of MPICH spin, and tests have more ranks than cores. */
#ifndef PATIENT_H
#define PATIENT_H

#include <mpi.h>
#include <sched.h>

static int patient_waitall(int count, MPI_Request* requests) {
  int code = MPI_SUCCESS, done = 0;
  while (!done && code == MPI_SUCCESS) {
    code = PMPI_Testall(count, requests, &done, MPI_STATUSES_IGNORE);
    if (!done) sched_yield();
  }
  return code;
}

static int patient_allgatherv(const void* from, int n, MPI_Datatype type, void* to, const int* counts, const int* places,
                              MPI_Datatype to_type, MPI_Comm comm) {
  MPI_Request request;
  const int code = PMPI_Iallgatherv(from, n, type, to, counts, places, to_type, comm, &request);
  return code == MPI_SUCCESS ? patient_waitall(1, &request) : code;
}

static int patient_sendrecv(const void* from, int n, MPI_Datatype type, int to, int tag, void* into, int m,
                            MPI_Datatype into_type, int source, int into_tag, MPI_Comm comm) {
  MPI_Request requests[2] = {MPI_REQUEST_NULL, MPI_REQUEST_NULL};
  const int one = PMPI_Irecv(into, m, into_type, source, into_tag, comm, &requests[0]),
            other = PMPI_Isend(from, n, type, to, tag, comm, &requests[1]), waited = patient_waitall(2, requests);
  return one != MPI_SUCCESS ? one : other != MPI_SUCCESS ? other : waited;
}

#endif
