! A finite element code's loop in small: two bodies, of which the springs behind each Gauss point are all that is kept, are pressed on
! a rough interface. A contact law is made once, stored, opened by number where the input is read, and evaluated at all Gauss points
! in one call of each Newton iteration.
program gauss_points
  use roughcontact
  implicit none
  integer, parameter :: n = 32, points = 8, steel = 1, most_iterations = 30
  real(c_double), parameter :: spring = 0.05_c_double  ! pressure of a body over its shortening, at every Gauss point
  character(*), parameter :: file = 'gauss_points.law'
  real(c_double) :: z(n, n), pressed(points), x(points), p(points), slope(points), energy(points), residual(points)
  type(rc_system) :: system
  type(c_ptr) :: law
  integer :: i, j, iteration, stat

  do j = 1, n
    do i = 1, n
      z(i, j) = cos(0.6_c_double * i) + cos(0.35_c_double * j) + 0.3_c_double * cos(0.9_c_double * i - 0.7_c_double * j)
    end do
  end do
  system = rc_system(op=RC_OPERATOR_HALFSPACE, boundary=RC_BOUNDARY_PERIODIC, nx=n, ny=n, hx=1, hy=1, modulus=1)
  call rcf_law_create(law, system, rcf_gap_from_heights(z), rc_law_spec(p_lower=1e-4_c_double, p_upper=0.1_c_double, &
    tolerance=1e-2_c_double))
  call rcf_law_save(law, file)
  call rcf_law_destroy(law)

  call rcf_law_open('steel', file, steel)
  pressed = [(0.5_c_double * (i - 2), i=1, points)]  ! how far the bodies are moved together; negative: still apart
  x = pressed
  do iteration = 1, most_iterations
    call rcf_law_at(steel, x, p, slope, energy, stat)
    if (stat == RC_ERR_ARGUMENT) error stop 'no such law, or an overclosure that is not a number'
    residual = p - spring * (pressed - x)
    if (maxval(abs(residual)) <= 1e-12_c_double) exit
    x = x - residual / (slope + spring)
  end do
  print '(a, i0, a)', 'after ', iteration - 1, ' iterations'
  print '(a)', 'moved together  overclosure     pressure        slope'
  do i = 1, points
    print '(f14.4, 3es13.4)', pressed(i), x(i), p(i), slope(i)
  end do
  open (newunit=i, file=file)
  close (i, status='delete')
  if (iteration > most_iterations .or. stat /= RC_OK) stop 1
end program
