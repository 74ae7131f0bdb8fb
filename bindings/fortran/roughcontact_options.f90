! Options, and what the library has: components and the schema of options.
module roughcontact_options
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_strings
  implicit none
  private
  public :: rcf_options_create, rcf_options_copy, rcf_options_destroy, rcf_options_set, rcf_options_get, rcf_context_create, &
    rcf_context_destroy, rcf_component_describe, rcf_option_default, rcf_pair_supported, rcf_kernel_coefficients, rcf_version, &
    rcf_or_null

  ! (options, key, value, [stat, errmsg]): a text is read as the option's type needs it.
  interface rcf_options_set
    procedure set_integer, set_number, set_text
  end interface
  interface rcf_options_get
    procedure get_number, get_text
  end interface

contains

  ! "0.1.0", of the library in use.
  function rcf_version() result(text)
    character(:), allocatable :: text
    character(40) :: buffer
    integer(c_int32_t) :: major, minor, patch
    call rc_version(major, minor, patch)
    write (buffer, '(i0, ".", i0, ".", i0)') major, minor, patch
    text = trim(buffer)
  end function

  ! An object, or null where it is absent.
  pure function rcf_or_null(object) result(p)
    type(c_ptr), intent(in), optional :: object
    type(c_ptr) :: p
    p = c_null_ptr
    if (present(object)) p = object
  end function

  ! A registry of its own. plugin_path: absolute directories, separated by ':'. log: c_funloc of a
  !   subroutine log(level, message, user) bind(c)
  !     integer(c_int32_t), value :: level      ! RC_LOG_...
  !     type(c_ptr), value :: message, user     ! rc_from_c(message)
  subroutine rcf_context_create(context, plugins, environment, plugin_path, log, user, stat, errmsg)
    type(c_ptr), intent(out) :: context
    logical, intent(in), optional :: plugins, environment
    character(*), intent(in), optional :: plugin_path
    type(c_funptr), intent(in), optional :: log
    type(c_ptr), intent(in), optional :: user
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(:, kind=c_char), allocatable :: path ! absent in C where it is not allocated
    type(c_funptr) :: called
    integer(c_int32_t) :: flags
    context = c_null_ptr
    flags = 0
    if (present(plugins)) then
      if (.not. plugins) flags = ior(flags, RC_CONTEXT_NO_PLUGINS)
    end if
    if (present(environment)) then
      if (.not. environment) flags = ior(flags, RC_CONTEXT_NO_ENVIRONMENT)
    end if
    if (present(plugin_path)) path = rc_to_c(plugin_path)
    called = c_null_funptr
    if (present(log)) called = log
    call rcf_check(rc_context_create(flags, path, called, rcf_or_null(user), context), stat, errmsg)
  end subroutine

  subroutine rcf_context_destroy(context)
    type(c_ptr), intent(inout) :: context
    call rc_context_destroy(context)
    context = c_null_ptr
  end subroutine

  subroutine rcf_options_create(options, context, stat, errmsg)
    type(c_ptr), intent(out) :: options
    type(c_ptr), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    options = c_null_ptr
    call rcf_check(rc_options_create(rcf_or_null(context), options), stat, errmsg)
  end subroutine

  ! Options of their own with the values of `from`.
  subroutine rcf_options_copy(from, options, stat, errmsg)
    type(c_ptr), intent(in) :: from
    type(c_ptr), intent(out) :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    options = c_null_ptr
    call rcf_check(rc_options_copy(from, options), stat, errmsg)
  end subroutine

  subroutine rcf_options_destroy(options)
    type(c_ptr), intent(inout) :: options
    call rc_options_destroy(options)
    options = c_null_ptr
  end subroutine

  subroutine set_integer(options, key, value, stat, errmsg)
    type(c_ptr), intent(in) :: options
    character(*), intent(in) :: key
    integer, intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call set_number(options, key, real(value, c_double), stat, errmsg)
  end subroutine

  subroutine set_number(options, key, value, stat, errmsg)
    type(c_ptr), intent(in) :: options
    character(*), intent(in) :: key
    real(c_double), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_options_set_number(options, rc_to_c(key), value), stat, errmsg)
  end subroutine

  subroutine set_text(options, key, value, stat, errmsg)
    type(c_ptr), intent(in) :: options
    character(*), intent(in) :: key, value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_options_set_text(options, rc_to_c(key), rc_to_c(value)), stat, errmsg)
  end subroutine

  subroutine get_number(options, key, value, stat, errmsg)
    type(c_ptr), intent(in) :: options
    character(*), intent(in) :: key
    real(c_double), intent(out) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    value = 0
    call rcf_check(rc_options_get_number(options, rc_to_c(key), value), stat, errmsg)
  end subroutine

  subroutine get_text(options, key, value, stat, errmsg)
    type(c_ptr), intent(in) :: options
    character(*), intent(in) :: key
    character(:), allocatable, intent(out) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: text
    integer(rc_status) :: status
    text = c_null_ptr
    status = rc_options_get_text(options, rc_to_c(key), text)
    value = rc_from_c(text)
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! `given`, or where it is absent what an option is where nobody sets it, real or integer.
  function rcf_option_default(key, given) result(value)
    character(*), intent(in) :: key
    real(c_double), intent(in), optional :: given
    real(c_double) :: value
    type(c_ptr) :: options
    integer(rc_status) :: status
    value = 0
    if (present(given)) then
      value = given
      return
    end if
    options = c_null_ptr
    if (rc_options_create(c_null_ptr, options) /= RC_OK) return
    status = rc_options_get_number(options, rc_to_c(key), value)
    if (status /= RC_OK) value = 0
    call rc_options_destroy(options)
  end function

  ! Component i = 1 .. rc_component_count(c_null_ptr, kind) of a kind, RC_COMPONENT_*. Members are C strings:
  ! rc_from_c(component%name).
  subroutine rcf_component_describe(kind, i, component, context, stat, errmsg)
    integer(c_int32_t), intent(in) :: kind
    integer, intent(in) :: i
    type(rc_component), intent(out) :: component
    type(c_ptr), intent(in), optional :: context
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_component_describe(rcf_or_null(context), kind, int(i - 1, c_int64_t), component), stat, errmsg)
  end subroutine

  ! Whether this solver can run on this backend for this system and control; if not, errmsg says why.
  function rcf_pair_supported(solver, backend, system, control, options, context, errmsg) result(supported)
    character(*), intent(in) :: solver, backend
    type(rc_system), intent(in) :: system
    integer(c_int32_t), intent(in) :: control
    type(c_ptr), intent(in), optional :: options, context
    character(*), intent(inout), optional :: errmsg
    logical :: supported
    integer :: stat
    call rcf_check(rc_pair_supported(rcf_or_null(context), rc_to_c(solver), rc_to_c(backend), system, control, &
      rcf_or_null(options)), stat, errmsg)
    supported = stat == RC_OK
  end function

  ! out(1 + ix, 1 + iy) = E* times the deflection at offset (ix hx, iy hy) from a cell under unit pressure.
  subroutine rcf_kernel_coefficients(kernel, hx, hy, out, stat, errmsg)
    character(*), intent(in) :: kernel
    real(c_double), intent(in) :: hx, hy
    real(c_double), intent(out), contiguous :: out(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_kernel_coefficients(rc_to_c(kernel), hx, hy, size(out, 1, c_int64_t), size(out, 2, c_int64_t), out), &
      stat, errmsg)
  end subroutine
end module
