! Surfaces from files in the manner of Fortran.
program test_files
  use roughcontact_formats
  use checks
  implicit none
  character(*), parameter :: path = 'test_files_map.txt'
  character(300) :: message
  character(:), allocatable :: assumed, recognised
  real(c_double), allocatable :: z(:, :)
  real(c_double) :: hx, hy
  integer(c_int64_t) :: missing
  logical :: periodic
  integer :: stat, unit

  open (newunit=unit, file=path, status='replace')
  write (unit, '(a)') '1 2 3', '2 nan 4'
  close (unit)
  call rcf_surface_read(path, z, hx, hy, pitch=[2d0, 3d0], unit='um', missing=missing, periodic=periodic, recognised=recognised, &
    assumed=assumed)
  call check('first index along x', all(shape(z) == [3, 2]) .and. abs(z(3, 1) - 3e-6_c_double) < 1e-18)
  call check('pitch', abs(hx - 2e-6_c_double) < 1e-18 .and. abs(hy - 3e-6_c_double) < 1e-18)
  call check('missing', missing == 1 .and. z(2, 2) /= z(2, 2) .and. .not. periodic .and. recognised == 'text')
  call check('assumed: '//assumed, assumed == 'lengths without a unit are in um, as asked for')
  call rcf_surface_fill(z, 1d0, 1d0)
  call check('filled', abs(z(2, 2) - 8e-6_c_double / 3) < 1e-18)
  call rcf_surface_remove_form(z, RC_SURFACE_FORM_PLANE)
  call check('no tilt left', maxval(abs(z)) < 1e-6)
  call rcf_surface_remove_form(z, 7, stat, message)
  call check('form: '//trim(message), stat == RC_ERR_ARGUMENT .and. index(message, 'form = 7') > 0)
  call rcf_surface_read(path, z, hx, hy, format='sdf', stat=stat, errmsg=message)
  call check('another format: '//trim(message), stat == RC_ERR_ARGUMENT .and. .not. allocated(z) .and. index(message, path) > 0)
  call rcf_surface_read('absent.txt', z, hx, hy, stat=stat, errmsg=message)
  call check('no file: '//trim(message), stat == RC_ERR_ARGUMENT .and. index(message, 'No such file') > 0)
  open (newunit=unit, file=path)
  close (unit, status='delete')
  call finish()
end program
