! Presses a rough surface and lets it go again in one call, then solves a small matrix with a direct routine.
program loading_history
  use, intrinsic :: iso_fortran_env, only: error_unit
  use roughcontact
  implicit none
  integer(rc_status) :: status

  status = press_and_release()
  if (status == RC_OK) status = three_springs()
  if (status /= RC_OK) then
    write (error_unit, '(3a)') rc_from_c(rc_status_name(status)), ': ', rc_error_message()
    stop 1, quiet=.true.
  end if

contains

  integer(rc_status) function press_and_release() result(status)
    integer, parameter :: n = 64, steps = 9
    real(c_double), target :: gap(n, n), targets(steps), load(steps), area(steps)
    type(c_ptr) :: contact
    type(rc_history) :: history
    integer :: ix, iy, k

    do iy = 1, n
      do ix = 1, n
        gap(ix, iy) = 0.5e-6_c_double * (2 - cos(0.6_c_double * ix) - cos(0.35_c_double * iy))
      end do
    end do
    targets = [(0.1e-6_c_double * min(k, 10 - k), k=1, steps)]
    history = rc_history(control=RC_CONTROL_APPROACH, n=steps, targets=rc_const_array(c_loc(targets)), &
      undeformed_gap=rc_const_array(c_loc(gap)), columns=rc_columns(load=rc_array(c_loc(load)), contact_area=rc_array(c_loc(area))))
    contact = c_null_ptr
    status = rc_contact_create(rc_system(boundary=RC_BOUNDARY_FREE, nx=n, ny=n, hx=1e-6_c_double, hy=1e-6_c_double, &
    modulus=70e9_c_double), c_null_ptr, contact)
    if (status == RC_OK) status = rc_contact_solve_history(contact, history)
    call rc_contact_destroy(contact)
    do k = 1, int(history%completed)
      print '(a, f4.2, a, f8.4, a, es10.3, a)', 'approach ', 1e6 * targets(k), ' um, load ', load(k), ' N, area ', area(k), ' m^2'
    end do
  end function

  integer(rc_status) function three_springs() result(status)
    real(c_double), parameter :: H(3, 3) = reshape([2d0, 1d0, 0.5d0, 1d0, 2d0, 1d0, 0.5d0, 1d0, 2d0], [3, 3])
    real(c_double) :: p(3), w(3)

    p = 0
    status = rc_nnls(3_c_int64_t, H, 3_c_int64_t, [1d0, 0.2d0, 1d0], p, w, 1e-12_c_double, 100_c_int64_t)
    if (status == RC_OK) print '(a, 3f7.3, a, f6.3)', 'forces', p, ', gap of the second', w(2)
  end function
end program
