! Presses a rough surface in steps and writes what a later run needs after each; a second contact then goes on from the file, and its
! load has the same bits (option resumable).
program restart
  use roughcontact
  implicit none
  integer, parameter :: n = 64, steps = 4
  character(*), parameter :: file = 'restart.bin'
  real(c_double) :: z(n, n), gap(n, n), p(n, n), p_before(n, n), approach, load, approach_before, load_before, whole, solved(n, n)
  type(rcf_contact) :: contact
  type(c_ptr) :: options
  type(rc_result) :: result
  integer :: i, j, unit

  do j = 1, n
    do i = 1, n
      z(i, j) = cos(0.6_c_double * i) + cos(0.35_c_double * j) + 0.3_c_double * cos(0.9_c_double * i - 0.7_c_double * j)
    end do
  end do
  gap = rcf_gap_from_heights(z)
  open (newunit=unit, file=file, access='stream', form='unformatted', status='replace')

  call rcf_options_create(options)
  call rcf_options_set(options, 'resumable', 1)
  call rcf_contact_create(contact, system(), options)
  p = 0
  approach = 0
  load = 0
  do i = 1, steps
    if (i == steps) write (unit, pos=1) gap, p, approach, load, p_before, approach_before, load_before
    p_before = p
    approach_before = approach
    load_before = load
    call step(i)
    p = solved
    approach = result%approach
    load = result%load
  end do
  whole = result%load
  call rcf_contact_destroy(contact)

  ! Another run: reads the file, and makes the last step.
  read (unit, pos=1) gap, p, approach, load, p_before, approach_before, load_before
  call rcf_contact_create(contact, system(), options)
  call rcf_contact_restore(contact, gap, p, approach, load, p_before, approach_before, load_before)
  call step(steps)
  print '(a, f9.4, a, l2)', 'load after the last step', result%load, ', the same bits after the restart:', result%load == whole
  call rcf_contact_destroy(contact)
  call rcf_options_destroy(options)
  close (unit, status='delete')
  if (result%load /= whole) stop 1

contains

  type(rc_system) function system()
    system = rc_system(boundary=RC_BOUNDARY_FREE, nx=n, ny=n, hx=1, hy=1, modulus=1)
  end function

  subroutine step(k)
    integer, intent(in) :: k
    if (k == 1) then
      call rcf_contact_solve(contact, approach=0.2_c_double * k, undeformed_gap=gap, p=solved, result=result)
    else
      call rcf_contact_solve(contact, approach=0.2_c_double * k, p=solved, result=result)
    end if
  end subroutine
end program
