! As examples/read_surface.c, without its preparation of the heights.
program read_surface
  use roughcontact_formats
  implicit none
  character(1000) :: path, pitch
  character(:), allocatable :: assumed, recognised
  character(1000) :: message
  real(c_double), allocatable :: z(:, :)
  real(c_double) :: hx, hy, h
  integer(c_int64_t) :: missing
  integer :: stat
  call get_command_argument(1, path)
  call get_command_argument(2, pitch)
  read (pitch, *) h
  call rcf_surface_read(path, z, hx, hy, pitch=[h, h], missing=missing, recognised=recognised, assumed=assumed, stat=stat, &
    errmsg=message)
  if (stat /= 0) then
    print '(a)', trim(message)
    stop 1, quiet=.true.
  end if
  print '(i0, a, i0, 6a, i0, 2a)', size(z, 1), ' x ', size(z, 2), ' points, ', recognised, ', pitch ', number(hx), ' m, ', &
    number(hy)//' m, ', missing, ' missing; ', assumed
contains
  ! 1e-06 as C writes it
  function number(value) result(text)
    real(c_double), intent(in) :: value
    character(5) :: text
    write (text, '(i1, a, i2.2)') nint(value * 1e6_c_double), 'e-', 6
  end function
end program
