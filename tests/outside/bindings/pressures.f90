! As pressures.c.
program pressures
  use roughcontact
  implicit none
  character(1000) :: words(7)
  real(c_double), allocatable :: z(:, :), p(:, :)
  real(c_double) :: pitch, modulus, approach
  integer :: nx, ny, i, unit

  do i = 1, 7
    call get_command_argument(i, words(i))
  end do
  read (words(2), *) nx
  read (words(3), *) ny
  read (words(4), *) pitch
  read (words(5), *) modulus
  read (words(6), *) approach
  allocate (z(nx, ny), p(nx, ny))
  open (newunit=unit, file=trim(words(1)), access='stream', status='old')
  read (unit) z
  close (unit)
  call rcf_solve(rc_system(boundary=RC_BOUNDARY_FREE, hx=pitch, hy=pitch, modulus=modulus), rcf_gap_from_heights(z), &
    approach=approach, p=p)
  open (newunit=unit, file=trim(words(7)), access='stream', status='replace')
  write (unit) p
  close (unit)
end program
