! The C interface of <roughcontact/mpi.h>, name for name, where it takes Fortran's communicators: comm%MPI_VAL.
! Units, rules and errors are described there.
! Written by scripts/bindings.py.
module roughcontact_mpi_interface
  use roughcontact_structs
  implicit none

  type, bind(c) :: rc_ranks_counts
    integer(c_size_t) :: struct_size = merge(88, 84, c_intptr_t == 8)
    integer(c_int64_t) :: products = 0, transpositions = 0, transposed = 0, reductions = 0, reduced = 0, gathers = 0, &
      gathered = 0, shifts = 0, shifted = 0, iterations = 0
  end type

  interface
    subroutine rc_mpi_contact_destroy(contact) bind(c); import
      type(c_ptr), value :: contact
    end subroutine
    integer(rc_status) function rc_mpi_contact_solve(contact, step, result) bind(c); import
      type(c_ptr), value :: contact
      type(rc_step), intent(in) :: step
      type(rc_result), intent(inout) :: result
    end function
    integer(rc_status) function rc_mpi_contact_solve_history(contact, path) bind(c); import
      type(c_ptr), value :: contact
      type(rc_history), intent(inout) :: path
    end function
    integer(rc_status) function rc_mpi_contact_counts(contact, out) bind(c); import
      type(c_ptr), value :: contact
      type(rc_ranks_counts), intent(inout) :: out
    end function
    integer(rc_status) function rc_mpi_rows_f(comm, system, first, count) bind(c); import
      integer(c_int32_t), value :: comm
      type(rc_system), intent(in) :: system
      integer(c_int64_t), intent(inout) :: first, count
    end function
    integer(rc_status) function rc_mpi_contact_create_f(comm, system, options, out) bind(c); import
      integer(c_int32_t), value :: comm
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(c_ptr), intent(inout) :: out
    end function
  end interface
  procedure(rc_mpi_contact_solve), bind(c) :: rc_mpi_contact_certify
end module
