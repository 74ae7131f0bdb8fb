/* Communicators by the numbers that Fortran, and through it other languages, know them by. */
#include <roughcontact/mpi.h>

rc_status rc_mpi_rows_f(MPI_Fint comm, const rc_system* system, int64_t* first, int64_t* count) {
  return rc_mpi_rows(MPI_Comm_f2c(comm), system, first, count);
}

rc_status rc_mpi_contact_create_f(MPI_Fint comm, const rc_system* system, const rc_options* options, rc_mpi_contact** out) {
  return rc_mpi_contact_create(MPI_Comm_f2c(comm), system, options, out);
}
