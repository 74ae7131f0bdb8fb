! roughcontact_mpi: a contact on ranks, as one process solves it. Rank 0 prints what must not depend on the number of ranks.
program test_fortran
  use, intrinsic :: iso_c_binding
  use mpi_f08
  use roughcontact
  use roughcontact_mpi
  use checks, only: rough
  implicit none
  integer, parameter :: nx = 64, ny = 96
  type(rc_system) :: system
  type(rcf_mpi_contact) :: contact
  type(rc_result) :: found, judged, alone
  type(rc_ranks_counts) :: counts
  real(c_double), target :: whole(nx, ny), expected(nx, ny)
  real(c_double), allocatable, target :: gap(:, :), p(:, :), deformed(:, :)
  integer(c_int64_t) :: first, count
  real(c_double) :: worst
  integer :: rank, stat
  character(200) :: message

  call MPI_Init()
  call MPI_Comm_rank(MPI_COMM_WORLD, rank)
  system = rc_system(boundary=RC_BOUNDARY_FREE, nx=nx, ny=ny, hx=1e-6_c_double, hy=1e-6_c_double, modulus=1e9_c_double)
  whole = rcf_gap_from_heights(1e-7_c_double * rough(nx, ny))
  call rcf_mpi_rows(MPI_COMM_WORLD, system, first, count)
  gap = whole(:, first:first + count - 1)
  allocate (p(nx, count), deformed(nx, count))

  call rcf_mpi_contact_create(contact, MPI_COMM_WORLD, system)
  call rcf_contact_solve(contact, load=1e-4_c_double, undeformed_gap=gap, p=p, gap=deformed, result=found)
  call rcf_contact_certify(contact, p, load=1e-4_c_double, result=judged)
  call rcf_mpi_contact_counts(contact, counts)
  call rcf_contact_solve(contact, load=-1.0_c_double, stat=stat, errmsg=message)
  call require(stat == RC_ERR_INFEASIBLE, 'a load below 0 is refused: '//trim(message))
  call rcf_contact_solve(contact, stat=stat, errmsg=message)
  call require(stat == RC_ERR_ARGUMENT, 'without a target')
  call rcf_mpi_contact_destroy(contact)

  call rcf_solve(system, whole, load=1e-4_c_double, p=expected, result=alone)
  worst = 0
  if (count > 0) worst = maxval(abs(p - expected(:, first:first + count - 1)))
  call require(worst < 1e-5_c_double * maxval(expected), 'pressures are those of one process')
  call require(found%status == RC_OK .and. judged%status == RC_OK, 'certified')
  call require(abs(found%approach / alone%approach - 1) < 1e-6_c_double, 'approach')
  call require(counts%products >= 0, 'counts')
  if (rank == 0) print '(i0, 1x, z16.16, 1x, i0)', found%contacts, transfer(found%approach, 0_c_int64_t), judged%contacts
  call MPI_Finalize()

contains

  subroutine require(holds, what)
    logical, intent(in) :: holds
    character(*), intent(in) :: what
    if (holds) return
    print '(a, i0, 2a)', 'rank ', rank, ': not so: ', what
    call MPI_Abort(MPI_COMM_WORLD, 1)
  end subroutine
end program
