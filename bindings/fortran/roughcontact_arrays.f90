! Arrays of Fortran as the library takes them: addresses, masks, shapes.
module roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions
  implicit none
  private
  public :: rcf_gap_from_heights, rcf_in, rcf_out, rcf_masked, rcf_shaped, rcf_extents_fit

contains

  ! The undeformed gap of a height map: its highest point touches first, of those where the mask is true.
  function rcf_gap_from_heights(heights, mask) result(undeformed_gap)
    real(c_double), intent(in), target, contiguous :: heights(:, :)
    logical, intent(in), optional :: mask(:, :)
    real(c_double), allocatable, target :: undeformed_gap(:, :)
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    type(rc_const_array) :: there
    integer(rc_status) :: status
    allocate (undeformed_gap(size(heights, 1), size(heights, 2)))
    call mask_bytes(mask, bytes, there)
    status = rc_gap_from_heights(size(heights, kind=c_int64_t), rcf_in(heights), there, rcf_out(undeformed_gap))
  end function

  ! An optional array as the library reads it; none where it is absent or empty.
  function rcf_in(x) result(array)
    real(c_double), intent(in), optional, target, contiguous :: x(:, :)
    type(rc_const_array) :: array
    if (.not. present(x)) return
    if (size(x) > 0) array%data = c_loc(x)
  end function

  ! The same as the library writes it.
  function rcf_out(x) result(array)
    real(c_double), intent(in), optional, target, contiguous :: x(:, :)
    type(rc_array) :: array
    if (.not. present(x)) return
    if (size(x) > 0) array%data = c_loc(x)
  end function

  ! A mask as C has it; none where it is absent.
  subroutine mask_bytes(mask, bytes, there)
    logical, intent(in), optional :: mask(:, :)
    integer(c_int8_t), allocatable, intent(out), target :: bytes(:, :)
    type(rc_const_array), intent(out) :: there
    if (.not. present(mask)) return
    bytes = merge(1_c_int8_t, 0_c_int8_t, mask)
    there%data = c_loc(bytes)
  end subroutine

  ! The same of a mask that must have nx by ny values; if it has not, the failure is reported, and the result is false.
  logical function rcf_masked(where, mask, nx, ny, bytes, there, stat, errmsg) result(fits)
    character(*), intent(in) :: where
    logical, intent(in), optional :: mask(:, :)
    integer(c_int64_t), intent(in) :: nx, ny
    integer(c_int8_t), allocatable, intent(out), target :: bytes(:, :)
    type(rc_const_array), intent(out) :: there
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    fits = .true.
    if (present(mask)) fits = rcf_extents_fit(where, 'mask', shape(mask), nx, ny, stat, errmsg)
    if (fits) call mask_bytes(mask, bytes, there)
  end function

  ! Whether an array that is present has nx by ny values; if not, the failure is reported.
  logical function rcf_shaped(where, name, x, nx, ny, stat, errmsg) result(fits)
    character(*), intent(in) :: where, name
    real(c_double), intent(in), optional :: x(:, :)
    integer(c_int64_t), intent(in) :: nx, ny
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    fits = .true.
    if (present(x)) fits = rcf_extents_fit(where, name, shape(x), nx, ny, stat, errmsg)
  end function

  logical function rcf_extents_fit(where, name, found, nx, ny, stat, errmsg) result(fits)
    character(*), intent(in) :: where, name
    integer, intent(in) :: found(2)
    integer(c_int64_t), intent(in) :: nx, ny
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(160) :: buffer
    fits = found(1) == nx .and. found(2) == ny
    if (fits) return
    write (buffer, '(2a, 2(i0, a), 2(i0, a))') name, ' has ', found(1), ' by ', found(2), ' values, give ', nx, ' by ', ny, ''
    call rcf_refuse(RC_ERR_SHAPE, where//': '//trim(buffer), stat, errmsg)
  end function
end module
