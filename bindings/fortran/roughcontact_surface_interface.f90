! The C interface of <roughcontact/surface.h>, name for name; units, rules and errors are described there. A
! program that uses it links libroughcontact-surface, and is then under the GPL because of GSL.
! Written by scripts/bindings.py.
module roughcontact_surface_interface
  use roughcontact_constants, only: rc_status
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int32_t), parameter :: RC_SURFACE_PEAKS = 4
  integer(c_int32_t), parameter :: RC_SURFACE_PARABOLOID = 1, RC_SURFACE_SPHERE = 2, RC_SURFACE_WAVES = 3, &
    RC_SURFACE_PYRAMIDS = 4, RC_SURFACE_NOISE = 5
  integer(c_int32_t), parameter :: RC_SURFACE_TREND_AUTO = 0, RC_SURFACE_TREND_MEAN = 1, RC_SURFACE_TREND_PLANE = 2
  integer(c_int32_t), parameter :: RC_SURFACE_SUBSAMPLE = 1, RC_SURFACE_MEAN = 2, RC_SURFACE_MAX = 3

  type, bind(c) :: rc_surface_rmd_spec
    integer(c_size_t) :: struct_size = merge(48, 44, c_intptr_t == 8)
    integer(c_int64_t) :: seed = 1
    integer(c_int32_t) :: levels = 8, additions = 0
    real(c_double) :: hurst = 0.7_c_double, sigma = 1, rms_height = 0
  end type

  type, bind(c) :: rc_surface_spectral_spec
    integer(c_size_t) :: struct_size = merge(104, 100, c_intptr_t == 8)
    integer(c_int64_t) :: seed = 1, nx = 256, ny = 256
    real(c_double) :: hx = 1, hy = 1, hurst = 0.8_c_double, q_low = 0, q_rolloff = 0, q_high = 0, rms_height = 1, rms_slope = 0
    integer(c_int32_t) :: fixed_amplitudes = 0, reserved = 0
  end type

  type, bind(c) :: rc_surface_shape_spec
    integer(c_size_t) :: struct_size = merge(88, 84, c_intptr_t == 8)
    integer(c_int32_t) :: shape = RC_SURFACE_PARABOLOID, reserved = 0
    integer(c_int64_t) :: seed = 1, nx = 256, ny = 256
    real(c_double) :: hx = 1, hy = 1, radius = 1, height = 1, period_x = 0, period_y = 0
  end type

  type, bind(c) :: rc_surface_map
    integer(c_size_t) :: struct_size = merge(56, 48, c_intptr_t == 8)
    integer(c_int64_t) :: nx = 1, ny = 1
    real(c_double) :: hx = 1, hy = 1
    type(c_ptr) :: heights = c_null_ptr  ! const double *
    integer(c_int32_t) :: periodic = 0, trend = RC_SURFACE_TREND_AUTO
  end type

  type, bind(c) :: rc_surface_statistics
    integer(c_size_t) :: struct_size = merge(112, 108, c_intptr_t == 8)
    real(c_double) :: rms_height = 0, skewness = 0, kurtosis = 0, highest = 0, lowest = 0, rms_slope = 0, rms_slope_x = 0, &
      rms_slope_y = 0, rms_curvature = 0, m0 = 0, m2 = 0, m4 = 0, nayak = 0
  end type

  type, bind(c) :: rc_surface_power_law
    integer(c_size_t) :: struct_size = merge(176, 172, c_intptr_t == 8)
    real(c_double) :: hurst = 0, hurst_error = 0, slope = 0, prefactor = 0, q_min = 0, q_max = 0, q_rolloff = 0, q_cutoff = 0
    integer(c_int64_t) :: peaks = 0
    real(c_double) :: peak_qx(4) = 0, peak_qy(4) = 0, peak_share(4) = 0
  end type

  type, bind(c) :: rc_surface_cmr
    integer(c_size_t) :: struct_size = merge(472, 468, c_intptr_t == 8)
    integer(c_int32_t) :: trustworthy = 0, levels = 0, safe_levels = 0, reserved = 0
    real(c_double) :: unresolved = 0, limit = 0, unresolved_overall = 0, peak_loss = 0, approach = 0, coarsest_pitch = 0
    character(kind=c_char) :: reason(400) = c_null_char
  end type

  interface
    type(c_ptr) function rc_surface_last_error() bind(c); import
    end function
    subroutine rc_surface_stop_when(flag) bind(c); import
      integer(c_int32_t), intent(in), optional :: flag
    end subroutine
    integer(rc_status) function rc_surface_rmd(spec, stage, crop, out) bind(c); import
      type(rc_surface_rmd_spec), intent(in) :: spec
      integer(c_int32_t), value :: stage, crop
      real(c_double), intent(inout) :: out(*)
    end function
    integer(rc_status) function rc_surface_spectral(spec, out) bind(c); import
      type(rc_surface_spectral_spec), intent(in) :: spec
      real(c_double), intent(inout) :: out(*)
    end function
    integer(rc_status) function rc_surface_shape(spec, out) bind(c); import
      type(rc_surface_shape_spec), intent(in) :: spec
      real(c_double), intent(inout) :: out(*)
    end function
    integer(rc_status) function rc_surface_analyze(map, out) bind(c); import
      type(rc_surface_map), intent(in) :: map
      type(rc_surface_statistics), intent(inout) :: out
    end function
    integer(rc_status) function rc_surface_psd(map, q, psd, modes, count) bind(c); import
      type(rc_surface_map), intent(in) :: map
      real(c_double), intent(inout), optional :: q(*), psd(*)
      integer(c_int64_t), intent(inout), optional :: modes(*)
      integer(c_int64_t), intent(inout) :: count
    end function
    integer(rc_status) function rc_surface_fit(map, out) bind(c); import
      type(rc_surface_map), intent(in) :: map
      type(rc_surface_power_law), intent(inout) :: out
    end function
    integer(rc_status) function rc_surface_cmr_advice(map, levels, approach, out) bind(c); import
      type(rc_surface_map), intent(in) :: map
      integer(c_int32_t), value :: levels
      real(c_double), value :: approach
      type(rc_surface_cmr), intent(inout) :: out
    end function
    integer(rc_status) function rc_surface_downsample(nx, ny, heights, mask, filter, out, out_mask) bind(c); import
      integer(c_int64_t), value :: nx, ny
      real(c_double), intent(in) :: heights(*)
      type(c_ptr), value :: mask, out_mask
      integer(c_int32_t), value :: filter
      real(c_double), intent(inout) :: out(*)
    end function
  end interface
end module
