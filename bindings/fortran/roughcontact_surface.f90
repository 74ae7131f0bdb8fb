! Making and judging rough surfaces: <roughcontact/surface.h> name for name (rc_surface_...), and procedures in the manner of
! Fortran (rcf_surface_...) that take height maps z(nx, ny) and report as those of module roughcontact do.
module roughcontact_surface
  use roughcontact_constants
  use roughcontact_errors
  use roughcontact_strings
  use roughcontact_surface_interface
  implicit none
  private :: map_of, check

contains

  ! Random midpoint displacement. z has 2^stage or 2^stage + 1 points a side; spec%levels is the finest stage.
  subroutine rcf_surface_rmd(spec, z, stat, errmsg)
    type(rc_surface_rmd_spec), intent(in) :: spec
    real(c_double), intent(inout), contiguous :: z(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: stage
    integer :: side, crop
    side = size(z, 1)
    crop = merge(1, 0, iand(side, 1) == 0)
    if (side == 1) crop = 1  ! one point: the first of stage 0
    stage = 0
    do while (2**stage < side - 1 + crop)
      stage = stage + 1
    end do
    if (size(z, 2) /= side .or. 2**stage /= side - 1 + crop) then
      call rcf_refuse(RC_ERR_SHAPE, 'rcf_surface_rmd: give z with 2^k or 2^k + 1 points a side', stat, errmsg)
      return
    end if
    call check(rc_surface_rmd(spec, stage, int(crop, c_int32_t), z), stat, errmsg)
  end subroutine

  ! Periodic self-affine surface; nx and ny are those of z, whatever spec says. So in rcf_surface_shape.
  subroutine rcf_surface_spectral(spec, z, stat, errmsg)
    type(rc_surface_spectral_spec), intent(in) :: spec
    real(c_double), intent(inout), contiguous :: z(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_surface_spectral_spec) :: sized
    sized = spec
    sized%nx = size(z, 1)
    sized%ny = size(z, 2)
    call check(rc_surface_spectral(sized, z), stat, errmsg)
  end subroutine

  subroutine rcf_surface_shape(spec, z, stat, errmsg)
    type(rc_surface_shape_spec), intent(in) :: spec
    real(c_double), intent(inout), contiguous :: z(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_surface_shape_spec) :: sized
    sized = spec
    sized%nx = size(z, 1)
    sized%ny = size(z, 2)
    call check(rc_surface_shape(sized, z), stat, errmsg)
  end subroutine

  ! Moments of heights, slopes and curvatures.
  subroutine rcf_surface_analyze(z, hx, hy, statistics, periodic, trend, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: z(:, :)
    real(c_double), intent(in) :: hx, hy
    type(rc_surface_statistics), intent(out) :: statistics
    logical, intent(in), optional :: periodic
    integer(c_int32_t), intent(in), optional :: trend
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call check(rc_surface_analyze(map_of(z, hx, hy, periodic, trend), statistics), stat, errmsg)
  end subroutine

  ! Radial average of the power spectral density: wave numbers, PSD and number of modes of its rings.
  subroutine rcf_surface_psd(z, hx, hy, q, psd, modes, periodic, trend, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: z(:, :)
    real(c_double), intent(in) :: hx, hy
    real(c_double), allocatable, intent(out) :: q(:), psd(:)
    integer(c_int64_t), allocatable, intent(out) :: modes(:)
    logical, intent(in), optional :: periodic
    integer(c_int32_t), intent(in), optional :: trend
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_surface_map) :: map
    integer(c_int64_t) :: count
    integer(rc_status) :: status
    map = map_of(z, hx, hy, periodic, trend)
    count = 0
    status = rc_surface_psd(map, count=count)
    allocate (q(count), psd(count), modes(count))
    if (status == RC_OK .and. count > 0) status = rc_surface_psd(map, q, psd, modes, count)
    call check(status, stat, errmsg)
  end subroutine

  ! Hurst exponent, roll-off, cut-off and periodic textures of the spectrum.
  subroutine rcf_surface_fit(z, hx, hy, law, periodic, trend, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: z(:, :)
    real(c_double), intent(in) :: hx, hy
    type(rc_surface_power_law), intent(out) :: law
    logical, intent(in), optional :: periodic
    integer(c_int32_t), intent(in), optional :: trend
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call check(rc_surface_fit(map_of(z, hx, hy, periodic, trend), law), stat, errmsg)
  end subroutine

  ! Whether cascade multi-resolution without a check can be trusted on this surface. approach absent: half the height of the
  ! highest point above the mean.
  subroutine rcf_surface_cmr_advice(z, hx, hy, levels, advice, approach, periodic, trend, stat, errmsg)
    real(c_double), intent(in), target, contiguous :: z(:, :)
    real(c_double), intent(in) :: hx, hy
    integer, intent(in) :: levels
    type(rc_surface_cmr), intent(out) :: advice
    real(c_double), intent(in), optional :: approach
    logical, intent(in), optional :: periodic
    integer(c_int32_t), intent(in), optional :: trend
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: d
    d = 0
    if (present(approach)) d = approach
    call check(rc_surface_cmr_advice(map_of(z, hx, hy, periodic, trend), int(levels, c_int32_t), d, advice), stat, errmsg)
  end subroutine

  ! Halves a grid: coarse((nx + 1)/2, (ny + 1)/2). filter: RC_SURFACE_SUBSAMPLE, _MEAN or _MAX.
  subroutine rcf_surface_downsample(z, filter, coarse, mask, coarse_mask, stat, errmsg)
    real(c_double), intent(in), contiguous :: z(:, :)
    integer(c_int32_t), intent(in) :: filter
    real(c_double), allocatable, intent(out) :: coarse(:, :)
    logical, intent(in), optional :: mask(:, :)
    logical, allocatable, intent(out), optional :: coarse_mask(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int8_t), allocatable, target :: fine(:, :), halved(:, :)
    type(c_ptr) :: given
    integer(rc_status) :: status
    allocate (coarse((size(z, 1) + 1) / 2, (size(z, 2) + 1) / 2))
    allocate (halved(size(coarse, 1), size(coarse, 2)))
    allocate (fine(size(z, 1), size(z, 2)))
    given = c_null_ptr
    if (present(mask)) then
      if (any(shape(mask) /= shape(z))) then
        call rcf_refuse(RC_ERR_SHAPE, 'rcf_surface_downsample: mask and z have different shapes', stat, errmsg)
        return
      end if
      fine = merge(1_c_int8_t, 0_c_int8_t, mask)
      given = c_loc(fine)
    end if
    status = rc_surface_downsample(size(z, 1, c_int64_t), size(z, 2, c_int64_t), z, given, filter, coarse, c_loc(halved))
    if (status == RC_OK .and. present(coarse_mask)) coarse_mask = halved /= 0
    call check(status, stat, errmsg)
  end subroutine

  function map_of(z, hx, hy, periodic, trend) result(map)
    real(c_double), intent(in), target, contiguous :: z(:, :)
    real(c_double), intent(in) :: hx, hy
    logical, intent(in), optional :: periodic
    integer(c_int32_t), intent(in), optional :: trend
    type(rc_surface_map) :: map
    map%nx = size(z, 1)
    map%ny = size(z, 2)
    map%hx = hx
    map%hy = hy
    if (size(z) > 0) map%heights = c_loc(z)
    if (present(periodic)) map%periodic = merge(1, 0, periodic)
    if (present(trend)) map%trend = trend
  end function

  subroutine check(status, stat, errmsg)
    integer(rc_status), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(status, stat, errmsg, rc_from_c(rc_surface_last_error()))
  end subroutine
end module
