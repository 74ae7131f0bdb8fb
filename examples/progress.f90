! Watches a solve through a callback, stops the second one early, and goes on from there.
module watching
  use roughcontact
  implicit none

  type :: watch
    integer(c_int64_t) :: calls = 0, stop_at = huge(0_c_int64_t)
  end type

contains

  ! user is the c_loc that was given with the callback.
  integer(c_int32_t) function look(progress, user) bind(c) result(stop_now)
    type(rc_progress), intent(in) :: progress
    type(c_ptr), value :: user
    type(watch), pointer :: mine
    call c_f_pointer(user, mine)
    mine%calls = mine%calls + 1
    stop_now = merge(1, 0, progress%iteration >= mine%stop_at)
  end function
end module

program progress
  use watching
  implicit none
  integer, parameter :: n = 96
  real(c_double) :: gap(n, n)
  type(rcf_contact) :: contact
  type(c_ptr) :: options
  type(rc_result) :: result
  type(watch), target :: mine
  integer :: i, j, stat
  character(200) :: message

  do j = 1, n
    do i = 1, n
      gap(i, j) = 2 - cos(0.9_c_double * i) * cos(0.5_c_double * j) - cos(0.21_c_double * i + 0.17_c_double * j)
    end do
  end do
  call rcf_options_create(options)
  call rcf_options_set(options, RC_OPT_SOLVER, 'polonsky-keer')
  call rcf_contact_create(contact, rc_system(boundary=RC_BOUNDARY_FREE, nx=n, ny=n, hx=1.0_c_double, hy=1.0_c_double, &
    modulus=1.0_c_double), options)
  call rcf_options_destroy(options)
  call rcf_contact_on_progress(contact, c_funloc(look), c_loc(mine))

  call rcf_contact_solve(contact, approach=1.0_c_double, undeformed_gap=gap, result=result)
  print '(a, i0, a, l1)', 'first: certified after ', result%iterations, ' iterations; the callback was called: ', mine%calls > 0

  mine%stop_at = 5
  call rcf_contact_solve(contact, approach=1.2_c_double, warm_start=.false., result=result, stat=stat, errmsg=message)
  if (stat /= RC_STOP_CANCELLED) error stop 'the callback did not stop the solve'
  print '(2a)', 'second: ', trim(message)

  mine%stop_at = huge(mine%stop_at)
  call rcf_contact_solve(contact, approach=1.2_c_double, result=result)
  print '(a, es8.1)', 'third: certified, largest residual ', max(result%kkt_primal, result%kkt_dual, result%kkt_complementarity)
  call rcf_contact_destroy(contact)
end program
