! The C interface of <roughcontact/formats.h>, name for name; units, rules and errors are described there.
! Written by scripts/bindings.py.
module roughcontact_formats_interface
  use roughcontact_constants, only: rc_status
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int32_t), parameter :: RC_SURFACE_FORM_MEAN = 1, RC_SURFACE_FORM_PLANE = 2, RC_SURFACE_FORM_QUADRIC = 3
  integer(c_int32_t), parameter :: RC_SURFACE_MIRROR_X = 1, RC_SURFACE_MIRROR_Y = 2
  integer(c_int32_t), parameter :: RC_SURFACE_LINEAR = 1, RC_SURFACE_CUBIC = 2

  type, bind(c) :: rc_surface_read_spec
    integer(c_size_t) :: struct_size = merge(48, 36, c_intptr_t == 8)
    type(c_ptr) :: format = c_null_ptr, unit = c_null_ptr  ! const char *
    real(c_double) :: hx = 0, hy = 0, height_range = 0
  end type

  type, bind(c) :: rc_surface_file
    integer(c_size_t) :: struct_size = merge(512, 500, c_intptr_t == 8)
    integer(c_int64_t) :: nx = 0, ny = 0
    real(c_double) :: hx = 0, hy = 0
    type(c_ptr) :: heights = c_null_ptr  ! double *
    integer(c_int64_t) :: missing = 0
    integer(c_int32_t) :: periodic = -1, unit_assumed = 0
    character(kind=c_char) :: format(32) = c_null_char, assumed(400) = c_null_char
    type(c_ptr) :: storage = c_null_ptr  ! void *
    real(c_double) :: full_scale = 0
  end type

  type, bind(c) :: rc_surface_format
    integer(c_size_t) :: struct_size = merge(48, 28, c_intptr_t == 8)
    type(c_ptr) :: name = c_null_ptr, summary = c_null_ptr, suffixes = c_null_ptr, says = c_null_ptr  ! const char *
    integer(c_int32_t) :: by_contents = 0, reserved = 0
  end type

  type, bind(c) :: rc_surface_resampling
    integer(c_size_t) :: struct_size = merge(120, 108, c_intptr_t == 8)
    integer(c_int64_t) :: nx = 0, ny = 0
    real(c_double) :: hx = 0, hy = 0
    type(c_ptr) :: heights = c_null_ptr  ! const double *
    integer(c_int32_t) :: periodic = 0, interpolation = RC_SURFACE_CUBIC
    integer(c_int64_t) :: to_nx = 0, to_ny = 0
    real(c_double) :: to_hx = 0, to_hy = 0, x0 = 0, y0 = 0
    type(c_ptr) :: to = c_null_ptr  ! double *
    integer(c_int64_t) :: missing = 0
  end type

  interface
    type(c_ptr) function rc_surface_read_last_error() bind(c); import
    end function
    integer(rc_status) function rc_surface_read(path, spec, out) bind(c); import
      character(kind=c_char), intent(in) :: path(*)
      type(rc_surface_read_spec), intent(in), optional :: spec
      type(rc_surface_file), intent(inout) :: out
    end function
    integer(rc_status) function rc_surface_read_memory(data, size, name, spec, out) bind(c); import
      type(c_ptr), value :: data
      integer(c_size_t), value :: size
      character(kind=c_char), intent(in), optional :: name(*)
      type(rc_surface_read_spec), intent(in), optional :: spec
      type(rc_surface_file), intent(inout) :: out
    end function
    subroutine rc_surface_file_free(file) bind(c); import
      type(rc_surface_file), intent(inout) :: file
    end subroutine
    integer(rc_status) function rc_surface_unit(name, metres) bind(c); import
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: metres
    end function
    integer(c_int64_t) function rc_surface_format_count() bind(c); import
    end function
    integer(rc_status) function rc_surface_format_describe(index, out) bind(c); import
      integer(c_int64_t), value :: index
      type(rc_surface_format), intent(inout) :: out
    end function
    integer(rc_status) function rc_surface_remove_form(nx, ny, form, heights) bind(c); import
      integer(c_int64_t), value :: nx, ny
      integer(c_int32_t), value :: form
      real(c_double), intent(inout) :: heights(*)
    end function
    integer(rc_status) function rc_surface_fill(nx, ny, hx, hy, heights) bind(c); import
      integer(c_int64_t), value :: nx, ny
      real(c_double), value :: hx, hy
      real(c_double), intent(inout) :: heights(*)
    end function
    integer(rc_status) function rc_surface_despike(nx, ny, factor, heights, spikes, largest) bind(c); import
      integer(c_int64_t), value :: nx, ny
      real(c_double), value :: factor
      real(c_double), intent(inout) :: heights(*), largest(*)
      integer(c_int64_t), intent(inout) :: spikes(*)
    end function
    integer(rc_status) function rc_surface_crop(nx, ny, hx, hy, x0, x1, y0, y1, heights) bind(c); import
      integer(c_int64_t), intent(inout) :: nx(*), ny(*)
      real(c_double), value :: hx, hy, x0, x1, y0, y1
      real(c_double), intent(inout) :: heights(*)
    end function
    integer(rc_status) function rc_surface_mirror(nx, ny, axes, heights) bind(c); import
      integer(c_int64_t), value :: nx, ny
      integer(c_int32_t), value :: axes
      real(c_double), intent(inout) :: heights(*)
    end function
    integer(rc_status) function rc_surface_resample(resampling) bind(c); import
      type(rc_surface_resampling), intent(inout) :: resampling
    end function
    integer(rc_status) function rc_surface_shift(nx, ny, hx, hy, dx, dy, periodic, interpolation, heights, missing) bind(c); import
      integer(c_int64_t), value :: nx, ny
      real(c_double), value :: hx, hy, dx, dy
      integer(c_int32_t), value :: periodic, interpolation
      real(c_double), intent(inout) :: heights(*)
      integer(c_int64_t), intent(inout) :: missing(*)
    end function
  end interface
end module
