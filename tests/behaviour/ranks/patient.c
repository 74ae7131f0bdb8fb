/* All of a program's calls are patient ones. */
#include "patient.h"

int MPI_Allgatherv(const void* from, int n, MPI_Datatype type, void* to, const int* counts, const int* places,
                   MPI_Datatype to_type, MPI_Comm comm) {
  return patient_allgatherv(from, n, type, to, counts, places, to_type, comm);
}
int MPI_Sendrecv(const void* from, int n, MPI_Datatype type, int to, int tag, void* into, int m, MPI_Datatype into_type,
                 int source, int into_tag, MPI_Comm comm, MPI_Status* status) {
  (void)status;
  return patient_sendrecv(from, n, type, to, tag, into, m, into_type, source, into_tag, comm);
}
int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  (void)statuses;
  return patient_waitall(count, requests);
}
