! Surfaces from files: <roughcontact/formats.h> name for name (rc_surface_...), and procedures in the manner of Fortran
! (rcf_surface_...) that give height maps z(nx, ny) and report as those of module roughcontact do.
module roughcontact_formats
  use roughcontact_constants
  use roughcontact_errors
  use roughcontact_strings
  use roughcontact_formats_interface
  implicit none
  private :: check

contains

  ! Heights [m], NaN where a point is missing, and the pitch [m], 0 where neither the file nor `pitch` says it. pitch(2), in `unit`,
  ! replaces that of the file. missing: points; periodic: whether the file says that the surface repeats; recognised: the format;
  ! assumed: what the file leaves open and how it was taken.
  ! z, recognised and assumed are not allocated after a failure.
  subroutine rcf_surface_read(path, z, hx, hy, pitch, unit, format, missing, periodic, recognised, assumed, stat, errmsg)
    character(*), intent(in) :: path
    real(c_double), allocatable, intent(out) :: z(:, :)
    real(c_double), intent(out) :: hx, hy
    real(c_double), intent(in), optional :: pitch(2)
    character(*), intent(in), optional :: unit, format
    integer(c_int64_t), intent(out), optional :: missing
    logical, intent(out), optional :: periodic
    character(:), allocatable, intent(out), optional :: recognised, assumed
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(kind=c_char), allocatable, target :: unit_c(:), format_c(:)
    real(c_double), pointer :: heights(:, :)
    type(rc_surface_read_spec) :: spec
    type(rc_surface_file) :: file
    integer(rc_status) :: status
    if (present(pitch)) spec%hx = pitch(1)
    if (present(pitch)) spec%hy = pitch(2)
    if (present(unit)) then
      unit_c = transfer(rc_to_c(unit), [c_null_char])
      spec%unit = c_loc(unit_c)
    end if
    if (present(format)) then
      format_c = transfer(rc_to_c(format), [c_null_char])
      spec%format = c_loc(format_c)
    end if
    status = rc_surface_read(rc_to_c(path), spec, file)
    hx = file%hx
    hy = file%hy
    if (present(missing)) missing = file%missing
    if (present(periodic)) periodic = file%periodic > 0
    if (status == RC_OK) then
      call c_f_pointer(file%heights, heights, [file%nx, file%ny])
      z = heights
      if (present(recognised)) recognised = rc_from_c(file%format)
      if (present(assumed)) assumed = rc_from_c(file%assumed)
      call rc_surface_file_free(file)
    end if
    call check(status, stat, errmsg)
  end subroutine

  ! Interpolates the heights that are NaN.
  subroutine rcf_surface_fill(z, hx, hy, stat, errmsg)
    real(c_double), intent(inout), contiguous :: z(:, :)
    real(c_double), intent(in) :: hx, hy
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call check(rc_surface_fill(size(z, 1, c_int64_t), size(z, 2, c_int64_t), hx, hy, z), stat, errmsg)
  end subroutine

  ! Subtracts a fit: RC_SURFACE_FORM_MEAN, _PLANE or _QUADRIC.
  subroutine rcf_surface_remove_form(z, form, stat, errmsg)
    real(c_double), intent(inout), contiguous :: z(:, :)
    integer(c_int32_t), intent(in) :: form
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call check(rc_surface_remove_form(size(z, 1, c_int64_t), size(z, 2, c_int64_t), form, z), stat, errmsg)
  end subroutine

  subroutine check(status, stat, errmsg)
    integer(rc_status), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(status, stat, errmsg, rc_from_c(rc_surface_read_last_error()))
  end subroutine
end module
