! Presses a rigid sphere of radius 10 mm into steel by 1 micrometre. press_sphere [BACKEND]: any name that
! `roughcontact backends` lists; "auto" if none is given.
program press_sphere
  use, intrinsic :: iso_fortran_env, only: error_unit
  use roughcontact
  implicit none
  integer, parameter :: n = 64
  real(c_double), parameter :: h = 4e-6_c_double, radius = 10e-3_c_double
  real(c_double), target :: gap(n, n)
  type(rc_system) :: system
  type(rc_step) :: step
  type(rc_result) :: result
  type(c_ptr) :: options
  integer(rc_status) :: status
  character(32) :: backend
  integer :: ix, iy

  do iy = 1, n
    do ix = 1, n
      gap(ix, iy) = h**2 * ((ix - (n + 1) / 2.0_c_double)**2 + (iy - (n + 1) / 2.0_c_double)**2) / (2 * radius)
    end do
  end do
  system = rc_system(boundary=RC_BOUNDARY_FREE, nx=n, ny=n, hx=h, hy=h, modulus=230e9_c_double)
  step = rc_step(control=RC_CONTROL_APPROACH, target=1e-6_c_double, undeformed_gap=rc_const_array(c_loc(gap)))
  backend = 'auto'
  if (command_argument_count() > 0) call get_command_argument(1, backend)

  options = c_null_ptr
  status = rc_options_create(c_null_ptr, options)
  if (status == RC_OK) status = rc_options_set_text(options, rc_to_c(RC_OPT_BACKEND), rc_to_c(backend))
  if (status == RC_OK) status = rc_solve(system, step, options, result)
  call rc_options_destroy(options)
  if (status /= RC_OK) then
    write (error_unit, '(3a)') rc_from_c(rc_status_name(status)), ': ', rc_error_message()
    stop 1, quiet=.true.
  end if
  print '(3a, f0.6, a, es12.6, 3a, 3(1x, es7.1))', rc_from_c(result%solver), ' on '//rc_from_c(result%backend), ': load ', &
    result%load, ' N, area ', result%contact_area, ' m^2, ', rc_from_c(rc_status_name(status)), ', residuals', &
    result%kkt_primal, result%kkt_dual, result%kkt_complementarity
end program
