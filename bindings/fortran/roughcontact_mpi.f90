! Contacts shared by the ranks of a communicator, each with some rows of the grid. Every rank calls the procedures, with its own
! rows p(nx, count) in the arrays and the same values in all else. A rank without rows gives arrays p(nx, 0). Exactly one of
! approach and load is given.
module roughcontact_mpi
  use mpi_f08, only: MPI_Comm, MPI_Comm_rank, MPI_Comm_size
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions, only: rc_contact_certify, rc_contact_destroy, rc_contact_solve
  use roughcontact_mpi_interface
  use roughcontact_options, only: rcf_or_null
  use roughcontact_steps
  implicit none
  private
  public :: rc_ranks_counts, rcf_mpi_contact, rcf_mpi_rows, rcf_mpi_contact_create, rcf_mpi_contact_destroy, &
    rcf_mpi_contact_solve, rcf_mpi_contact_certify, rcf_mpi_contact_counts

  ! Not to be copied: one variable, destroyed once, before MPI_Finalize.
  type :: rcf_mpi_contact
    type(c_ptr) :: handle = c_null_ptr  ! for the rc_contact_ functions
    type(rc_exchange) :: exchange  ! between the ranks, with their numbers
    integer(c_int64_t) :: nx = 0, first = 1, count = 0  ! rows first .. first + count - 1, from 1 on, of this rank
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
    if (status == RC_OK) status = rc_ranks_rows(contact%exchange, system, contact%first, contact%count)
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

  ! undeformed_gap and mask absent: as in the step before. p and gap: pressures and deformed gap of this rank's rows, written
  ! where the status is >= 0. What the result says besides is of the whole grid.
  subroutine rcf_mpi_contact_solve(contact, approach, load, undeformed_gap, mask, p0, warm_start, p, gap, result, stat, &
    errmsg, time)
    type(rcf_mpi_contact), intent(in) :: contact
    real(c_double), intent(in), optional :: approach, load
    real(c_double), intent(in), optional, target, contiguous :: undeformed_gap(:, :), p0(:, :)
    logical, intent(in), optional :: mask(:, :), warm_start
    real(c_double), intent(inout), optional, target, contiguous :: p(:, :), gap(:, :)
    type(rc_result), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional :: time
    type(rc_step) :: step
    type(rc_result) :: answer
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    integer(rc_status) :: status
    if (.not. rcf_prepared('rcf_mpi_contact_solve', contact%nx, contact%count, step, answer, bytes, approach, load, &
      undeformed_gap, mask, p0, warm_start, p, gap, stat, errmsg)) return
    if (present(time)) step%time = time
    status = rc_contact_solve(contact%handle, step, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Certifies the pressures p of all ranks; nothing is solved.
  subroutine rcf_mpi_contact_certify(contact, p, approach, load, undeformed_gap, mask, gap, result, stat, errmsg, time)
    type(rcf_mpi_contact), intent(in) :: contact
    real(c_double), intent(inout), target, contiguous :: p(:, :)
    real(c_double), intent(in), optional :: approach, load
    real(c_double), intent(in), optional, target, contiguous :: undeformed_gap(:, :)
    logical, intent(in), optional :: mask(:, :)
    real(c_double), intent(inout), optional, target, contiguous :: gap(:, :)
    type(rc_result), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional :: time
    type(rc_step) :: step
    type(rc_result) :: answer
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    integer(rc_status) :: status
    if (.not. rcf_prepared('rcf_mpi_contact_certify', contact%nx, contact%count, step, answer, bytes, approach, load, &
      undeformed_gap, mask, p=p, gap=gap, stat=stat, errmsg=errmsg)) return
    if (present(time)) step%time = time
    status = rc_contact_certify(contact%handle, step, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
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
