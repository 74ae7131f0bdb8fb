! The C interface of <roughcontact/mpi.h>, name for name, where it takes Fortran's communicators: comm%MPI_VAL.
! Units, rules and errors are described there.
! Written by scripts/bindings.py.
module roughcontact_mpi_interface
  use roughcontact_structs
  implicit none

  type, bind(c) :: rc_exchange
    integer(c_size_t) :: struct_size = merge(64, 40, c_intptr_t == 8)
    integer(c_int64_t) :: rank = 0, ranks = 1
    type(c_ptr) :: user = c_null_ptr  ! void *
    type(c_funptr) :: gather = c_null_funptr  ! type(c_ptr) function gather(user, mine, bytes, all) bind(c)
    type(c_funptr) :: transpose = c_null_funptr  ! type(c_ptr) function transpose(user, from, sent, into, received) bind(c)
    type(c_funptr) :: shift = c_null_funptr  ! type(c_ptr) function shift(user, to, from, sent, source, into, received) bind(c)
    type(c_ptr) :: refused = c_null_ptr  ! const char *
  end type

  type, bind(c) :: rc_ranks_counts
    integer(c_size_t) :: struct_size = merge(88, 84, c_intptr_t == 8)
    integer(c_int64_t) :: products = 0, transpositions = 0, transposed = 0, reductions = 0, reduced = 0, gathers = 0, &
      gathered = 0, shifts = 0, shifted = 0, iterations = 0
  end type

  interface
    integer(rc_status) function rc_ranks_rows(exchange, system, first, count) bind(c); import
      type(rc_exchange), intent(in) :: exchange
      type(rc_system), intent(in) :: system
      integer(c_int64_t), intent(inout) :: first, count
    end function
    integer(rc_status) function rc_ranks_contact_create(exchange, system, options, out) bind(c); import
      type(rc_exchange), intent(in) :: exchange
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(c_ptr), intent(inout) :: out
    end function
    integer(rc_status) function rc_ranks_contact_counts(contact, out) bind(c); import
      type(c_ptr), value :: contact
      type(rc_ranks_counts), intent(inout) :: out
    end function
    integer(rc_status) function rc_mpi_exchange_create_f(comm, out) bind(c); import
      integer(c_int32_t), value :: comm
      type(rc_exchange), intent(inout) :: out
    end function
    subroutine rc_mpi_exchange_destroy(exchange) bind(c); import
      type(rc_exchange), intent(inout) :: exchange
    end subroutine
  end interface
end module
