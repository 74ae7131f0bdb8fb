! Analysis of a contact: functions of pressures p(nx, ny) only. boundary: RC_BOUNDARY_*, across which patches may extend.
module roughcontact_analysis
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_options, only: rcf_or_null
  implicit none
  private
  public :: rcf_area_measure, rcf_patches_find, rcf_histogram_fill, rcf_crossing_find, rcf_patch, rcf_conductance, &
    rcf_punch_stiffness

  ! One connected part of a contact.
  type :: rcf_patch
    integer(c_int64_t) :: cells = 0, peak = 0  ! peak: the point with the largest pressure, from 1 on
    real(c_double) :: area = 0, perimeter = 0, load = 0, mean_pressure = 0, max_pressure = 0
  end type

contains

  ! Area, perimeter, and the area corrected for the grid.
  subroutine rcf_area_measure(p, hx, hy, boundary, area, mask, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: p(:, :)
    type(rc_area), intent(out) :: area
    real(c_double), intent(in) :: hx, hy
    integer(c_int32_t), intent(in) :: boundary
    logical, intent(in), optional :: mask(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    type(rc_const_array) :: there
    if (.not. mask_fits('rcf_area_measure', p, mask, bytes, there, stat, errmsg)) return
    call rcf_check(rc_area_measure(grid(p, hx, hy, boundary), rcf_in(p), there, area), stat, errmsg)
  end subroutine

  ! label(ix, iy): number of the point's patch, from 1 on, 0: no contact. neighbours: 4 (across edges) or 8 (corners as well).
  subroutine rcf_patches_find(p, hx, hy, boundary, patches, label, mask, neighbours, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: p(:, :)
    type(rcf_patch), allocatable, intent(out) :: patches(:)
    integer(c_int64_t), intent(inout), optional, target, contiguous :: label(:, :)
    real(c_double), intent(in) :: hx, hy
    integer(c_int32_t), intent(in) :: boundary
    logical, intent(in), optional :: mask(:, :)
    integer, intent(in), optional :: neighbours
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_patches) :: found
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    type(rc_const_array) :: there
    integer(c_int64_t), allocatable, target :: counts(:, :)
    real(c_double), allocatable, target :: values(:, :)
    integer(rc_status) :: status
    integer(c_int64_t) :: k
    allocate (patches(0))
    if (.not. mask_fits('rcf_patches_find', p, mask, bytes, there, stat, errmsg)) return
    if (present(label)) then
      if (.not. rcf_extents_fit('rcf_patches_find', 'label', shape(label), size(p, 1, c_int64_t), size(p, 2, c_int64_t), &
        stat, errmsg)) return
      if (size(label) > 0) found%label%data = c_loc(label)
    end if
    if (present(neighbours)) found%neighbours = neighbours
    status = rc_patches_find(grid(p, hx, hy, boundary), rcf_in(p), there, found)
    if (status == RC_OK .and. found%count > 0) then
      found%room = found%count
      allocate (counts(found%count, 2), values(found%count, 5))
      found%cells%data = c_loc(counts(1, 1))
      found%peak%data = c_loc(counts(1, 2))
      found%area%data = c_loc(values(1, 1))
      found%perimeter%data = c_loc(values(1, 2))
      found%load%data = c_loc(values(1, 3))
      found%mean_pressure%data = c_loc(values(1, 4))
      found%max_pressure%data = c_loc(values(1, 5))
      status = rc_patches_find(grid(p, hx, hy, boundary), rcf_in(p), there, found)
      if (status == RC_OK) patches = [(rcf_patch(counts(k, 1), counts(k, 2) + 1, values(k, 1), values(k, 2), values(k, 3), &
        values(k, 4), values(k, 5)), k=1, found%count)]
    end if
    if (status == RC_OK .and. present(label)) label = label + 1
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! counts(k): points with (k - 1) width < p <= k width; density: their share per pressure; upper 0 or absent: the largest
  ! pressure.
  subroutine rcf_histogram_fill(p, counts, density, upper, mask, histogram, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: p(:, :)
    integer(c_int64_t), intent(inout), target, contiguous :: counts(:)
    real(c_double), intent(inout), optional, target, contiguous :: density(:)
    real(c_double), intent(in), optional :: upper
    logical, intent(in), optional :: mask(:, :)
    type(rc_histogram), intent(out), optional :: histogram
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_histogram) :: filled
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    type(rc_const_array) :: there
    integer(rc_status) :: status
    if (.not. mask_fits('rcf_histogram_fill', p, mask, bytes, there, stat, errmsg)) return
    filled%bins = size(counts, kind=c_int64_t)
    if (filled%bins > 0) filled%counts%data = c_loc(counts)
    if (present(density)) then
      if (size(density) /= size(counts)) then
        call rcf_refuse(RC_ERR_SHAPE, 'rcf_histogram_fill: counts and density have different lengths', stat, errmsg)
        return
      end if
      if (size(density) > 0) filled%density%data = c_loc(density)
    end if
    if (present(upper)) filled%upper = upper
    status = rc_histogram_fill(grid(p, 1.0_c_double, 1.0_c_double, RC_BOUNDARY_FREE), rcf_in(p), there, filled)
    if (present(histogram)) histogram = filled
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Along which axes contact and gap reach across: sums of RC_CROSSES_...
  subroutine rcf_crossing_find(p, boundary, contact, gap, mask, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: p(:, :)
    integer(c_int32_t), intent(in) :: boundary
    integer(c_int32_t), intent(inout) :: contact, gap
    logical, intent(in), optional :: mask(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    type(rc_const_array) :: there
    if (.not. mask_fits('rcf_crossing_find', p, mask, bytes, there, stat, errmsg)) return
    call rcf_check(rc_crossing_find(grid(p, 1.0_c_double, 1.0_c_double, boundary), rcf_in(p), there, contact, gap), &
      stat, errmsg)
  end subroutine

  ! Electrical or thermal conductance of a contact of half-spaces, and the interval it lies in. result: with option stiffness 1
  ! or 2. rho1, rho2: resistivities, or reciprocals of thermal conductivities.
  subroutine rcf_conductance(system, result, rho1, rho2, conductance, lower, upper, stat, errmsg)
    type(rc_system), intent(in) :: system
    type(rc_result), intent(in) :: result
    real(c_double), intent(in) :: rho1, rho2
    real(c_double), intent(inout) :: conductance
    real(c_double), intent(inout), optional :: lower, upper
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_conductance(system, result, rho1, rho2, conductance, lower, upper), stat, errmsg)
  end subroutine

  ! dW/dd of a rigid flat punch on exactly the points of the mask (absent: all), and the interval it lies in.
  subroutine rcf_punch_stiffness(system, stiffness, mask, lower, upper, options, stat, errmsg)
    type(rc_system), intent(in) :: system
    real(c_double), intent(inout) :: stiffness
    logical, intent(in), optional :: mask(:, :)
    real(c_double), intent(inout), optional :: lower, upper
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    type(rc_const_array) :: there
    if (.not. rcf_masked('rcf_punch_stiffness', mask, system%nx, system%ny, bytes, there, stat, errmsg)) return
    call rcf_check(rc_punch_stiffness(system, there, rcf_or_null(options), stiffness, lower, upper), stat, errmsg)
  end subroutine

  pure function grid(p, hx, hy, boundary) result(system)
    real(c_double), intent(in) :: p(:, :)
    real(c_double), intent(in) :: hx, hy
    integer(c_int32_t), intent(in) :: boundary
    type(rc_system) :: system
    system = rc_system(boundary=boundary, nx=size(p, 1, c_int64_t), ny=size(p, 2, c_int64_t), hx=hx, hy=hy)
  end function

  logical function mask_fits(where, p, mask, bytes, there, stat, errmsg) result(fits)
    character(*), intent(in) :: where
    real(c_double), intent(in) :: p(:, :)
    logical, intent(in), optional :: mask(:, :)
    integer(c_int8_t), allocatable, intent(out), target :: bytes(:, :)
    type(rc_const_array), intent(out) :: there
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    fits = rcf_masked(where, mask, size(p, 1, c_int64_t), size(p, 2, c_int64_t), bytes, there, stat, errmsg)
  end function
end module
