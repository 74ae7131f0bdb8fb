! Contacts shared by the ranks of a communicator, each with some rows of the grid: rcf_contact_solve, rcf_contact_certify and
! rcf_contact_cancel take them. Every rank calls the procedures, with its own rows p(nx, ny) in the arrays and the same values in
! all else. A rank without rows gives arrays p(nx, 0). Results are of the whole grid.
module roughcontact_mpi
  use mpi_f08, only: MPI_Comm, MPI_Comm_rank, MPI_Comm_size
  use roughcontact_contacts, only: rcf_contact
  use roughcontact_errors
  use roughcontact_functions, only: rc_contact_destroy
  use roughcontact_mpi_interface
  use roughcontact_options, only: rcf_or_null
  implicit none
  private
  public :: rc_ranks_counts, rcf_mpi_contact, rcf_mpi_rows, rcf_mpi_contact_create, rcf_mpi_contact_destroy, &
    rcf_mpi_contact_counts

  ! Not to be copied: one variable, destroyed once, before MPI_Finalize.
  type, extends(rcf_contact) :: rcf_mpi_contact  ! ny: how many rows this rank has
    type(rc_exchange) :: exchange  ! between the ranks, with their numbers
    integer(c_int64_t) :: first = 1  ! of this rank's rows, from 1 on
  end type

contains

  ! The rows of this rank: first .. first + count - 1, from 1 on.
  subroutine rcf_mpi_rows(comm, system, first, count, stat, errmsg)
    type(MPI_Comm), intent(in) :: comm
    type(rc_system), intent(in) :: system
    integer(c_int64_t), intent(out) :: first, count
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_exchange) :: exchange
    integer :: rank, ranks
    first = 0
    count = 0
    call MPI_Comm_rank(comm, rank)
    call MPI_Comm_size(comm, ranks)
    exchange%rank = rank
    exchange%ranks = ranks
    call rcf_check(rc_ranks_rows(exchange, system, first, count), stat, errmsg)
    first = first + 1
  end subroutine

  subroutine rcf_mpi_contact_create(contact, comm, system, options, stat, errmsg)
    type(rcf_mpi_contact), intent(out) :: contact
    type(MPI_Comm), intent(in) :: comm
    type(rc_system), intent(in) :: system
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(rc_status) :: status
    status = rc_mpi_exchange_create_f(int(comm%MPI_VAL, c_int32_t), contact%exchange)
    if (status == RC_OK) status = rc_ranks_rows(contact%exchange, system, contact%first, contact%ny)
    if (status == RC_OK) status = rc_ranks_contact_create(contact%exchange, system, rcf_or_null(options), contact%handle)
    call rcf_check(status, stat, errmsg)
    if (status /= RC_OK) then
      call rcf_mpi_contact_destroy(contact)
      return
    end if
    contact%nx = system%nx
    contact%first = contact%first + 1
  end subroutine

  subroutine rcf_mpi_contact_destroy(contact)
    type(rcf_mpi_contact), intent(inout) :: contact
    call rc_contact_destroy(contact%handle)
    call rc_mpi_exchange_destroy(contact%exchange)
    contact = rcf_mpi_contact()
  end subroutine

  ! Numbers and bytes of this rank's exchanges for the contact.
  subroutine rcf_mpi_contact_counts(contact, counts, stat, errmsg)
    type(rcf_mpi_contact), intent(in) :: contact
    type(rc_ranks_counts), intent(out) :: counts
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_ranks_contact_counts(contact%handle, counts), stat, errmsg)
  end subroutine
end module
