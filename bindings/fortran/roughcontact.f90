! roughcontact for Fortran: the C interface of <roughcontact/roughcontact.h>, name for name; units, rules and errors are
! described there. Compile this file with your program: module files are not portable between compilers.
!
! Objects (context, options, contact) are type(c_ptr); c_null_ptr where C takes NULL. Arrays inside structs are c_loc(x)
! of contiguous target arrays, x fastest: a Fortran array p(nx, ny) has the library's order. Callbacks are
! c_funloc(f) of bind(c) procedures. Names and keys are passed as rc_to_c('fft').
module roughcontact
  use, intrinsic :: iso_c_binding
  implicit none
  private :: from_array, from_pointer

  integer(c_int32_t), parameter :: RC_VERSION_MAJOR = 0, RC_VERSION_MINOR = 1, RC_VERSION_PATCH = 0, RC_ABI = 0
  integer, parameter :: rc_status = c_int32_t  ! the kind of a status

  integer(rc_status), parameter :: RC_OK = 0, RC_STOP_MAX_ITER = 1, RC_STOP_TIME = 2, RC_STOP_CANCELLED = 3, &
    RC_STOP_STALLED = 4, RC_STOP_UNCERTIFIED = 5, RC_WITHIN_GOAL = 6, RC_ERR_ARGUMENT = -1, RC_ERR_SHAPE = -2, RC_ERR_OPTION = -3, &
    RC_ERR_NO_BACKEND = -4, RC_ERR_NO_SOLVER = -5, RC_ERR_INCOMPATIBLE = -6, RC_ERR_PLUGIN = -7, RC_ERR_MEMORY = -8, &
    RC_ERR_INFEASIBLE = -9, RC_ERR_NUMERIC = -10, RC_ERR_EXTERNAL = -11, RC_ERR_BUSY = -12, RC_ERR_INTERNAL = -99

  integer(c_int32_t), parameter :: RC_OPERATOR_HALFSPACE = 1, RC_OPERATOR_DENSE = 2, RC_OPERATOR_CALLBACK = 3
  integer(c_int32_t), parameter :: RC_BOUNDARY_FREE = 1, RC_BOUNDARY_PERIODIC = 2
  integer(c_int32_t), parameter :: RC_CONTROL_DISPLACEMENT = 1, RC_CONTROL_LOAD = 2
  integer(c_int32_t), parameter :: RC_BATCH_SHARED = -1
  integer(c_int32_t), parameter :: RC_LOG_INFO = 1, RC_LOG_WARNING = 2
  integer(c_int32_t), parameter :: RC_CONTEXT_NO_PLUGINS = 1, RC_CONTEXT_NO_ENVIRONMENT = 2
  integer(c_int32_t), parameter :: RC_TYPE_INT = 1, RC_TYPE_REAL = 2, RC_TYPE_TEXT = 3

  character(*), parameter :: RC_OPT_SOLVER = 'solver', RC_OPT_BACKEND = 'backend', RC_OPT_KERNEL = 'kernel', &
    RC_OPT_TOL = 'tol', RC_OPT_MAX_ITER = 'max_iter', RC_OPT_TIME_LIMIT = 'time_limit', RC_OPT_THREADS = 'threads', &
    RC_OPT_STIFFNESS = 'stiffness', RC_OPT_ALLOW_FALLBACK = 'allow_fallback', RC_OPT_CERTIFY_BACKEND = 'certify_backend', &
    RC_OPT_WARMUP = 'warmup', RC_OPT_WARMUP_ITERATIONS = 'warmup.iterations', RC_OPT_BOUNDS = 'bounds', &
    RC_OPT_DETERMINISTIC = 'deterministic', RC_OPT_ACCURACY = 'accuracy', RC_OPT_ACCURACY_OF = 'accuracy.of'

  type, bind(c) :: rc_system
    integer(c_size_t) :: struct_size = 88
    integer(c_int32_t) :: op = RC_OPERATOR_HALFSPACE, boundary = RC_BOUNDARY_FREE
    integer(c_int64_t) :: nx = 1, ny = 1
    real(c_double) :: hx = 1, hy = 1, modulus = 1
    type(c_ptr) :: dense = c_null_ptr
    integer(c_int64_t) :: dense_ld = 0
    type(c_funptr) :: apply = c_null_funptr  ! integer(c_int32_t) function apply(x, y, n, user) bind(c)
    type(c_ptr) :: user = c_null_ptr
  end type

  type, bind(c) :: rc_step
    integer(c_size_t) :: struct_size = 56
    integer(c_int32_t) :: control = RC_CONTROL_DISPLACEMENT, warm_start = 1
    real(c_double) :: target = 0
    type(c_ptr) :: gap = c_null_ptr, p0 = c_null_ptr
    type(c_ptr) :: mask = c_null_ptr  ! integer(c_int8_t)
    integer(c_int32_t) :: borrow = 0, reserved = 0
  end type

  type, bind(c) :: rc_result
    integer(c_size_t) :: struct_size = 544
    type(c_ptr) :: p = c_null_ptr, gap = c_null_ptr
    integer(rc_status) :: status = 0
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: iterations = 0, applications = 0, points = 0, candidates = 0, modelled = 0, contacts = 0
    real(c_double) :: load = 0, displacement = 0, mean_pressure = 0, contact_area = 0, energy = 0, stiffness = 0
    real(c_double) :: kkt_primal = 0, kkt_dual = 0, kkt_complementarity = 0, kkt_control = 0
    real(c_double) :: seconds = 0, setup_seconds = 0
    character(kind=c_char) :: solver(32) = c_null_char, backend(32) = c_null_char, kernel(32) = c_null_char
    character(kind=c_char) :: note(160) = c_null_char
    real(c_double) :: duality_gap = 0, load_lower = 0, load_upper = 0, area_lower = 0, area_upper = 0
    integer(c_int64_t) :: proven_contacts = 0, proven_open = 0, undecided = 0, levels = 0
    real(c_double) :: tolerance = 0
    integer(c_int64_t) :: model_nx = 0, model_ny = 0
    real(c_double) :: error_estimate = 0, left_out = 0
  end type

  type, bind(c) :: rc_level
    integer(c_size_t) :: struct_size = 88
    type(c_ptr) :: p = c_null_ptr
    integer(rc_status) :: status = 0
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: nx = 0, ny = 0
    real(c_double) :: hx = 0, hy = 0, displacement = 0, load = 0
    integer(c_int64_t) :: candidates = 0, contacts = 0
  end type

  type, bind(c) :: rc_path
    integer(c_size_t) :: struct_size = 120
    integer(c_int32_t) :: control = RC_CONTROL_DISPLACEMENT, warm_start = 1
    integer(c_int64_t) :: n = 0
    type(c_ptr) :: targets = c_null_ptr, gap = c_null_ptr
    type(c_ptr) :: mask = c_null_ptr  ! integer(c_int8_t)
    type(c_ptr) :: load = c_null_ptr, displacement = c_null_ptr, contact_area = c_null_ptr, stiffness = c_null_ptr
    type(c_ptr) :: certificate = c_null_ptr
    type(c_ptr) :: applications = c_null_ptr  ! integer(c_int64_t)
    type(c_funptr) :: fn = c_null_funptr  ! integer(c_int32_t) function fn(step, result, user) bind(c), step by value
    type(c_ptr) :: user = c_null_ptr
    integer(c_int64_t) :: completed = 0
  end type

  type, bind(c) :: rc_batch
    integer(c_size_t) :: struct_size = 200
    integer(c_int32_t) :: control = RC_CONTROL_DISPLACEMENT, warm_start = 1
    integer(c_int64_t) :: n = 0, steps = 0
    type(c_ptr) :: targets = c_null_ptr
    integer(c_int64_t) :: target_stride = 0
    type(c_ptr) :: gap = c_null_ptr
    integer(c_int64_t) :: gap_stride = 0
    type(c_ptr) :: mask = c_null_ptr  ! integer(c_int8_t)
    integer(c_int64_t) :: mask_stride = 0
    type(c_ptr) :: p0 = c_null_ptr, p = c_null_ptr, load = c_null_ptr, displacement = c_null_ptr, contact_area = c_null_ptr
    type(c_ptr) :: stiffness = c_null_ptr, certificate = c_null_ptr
    type(c_ptr) :: status = c_null_ptr  ! integer(rc_status)
    type(c_ptr) :: iterations = c_null_ptr, applications = c_null_ptr  ! integer(c_int64_t)
    type(c_funptr) :: fn = c_null_funptr  ! integer(c_int32_t) function fn(contact, step, result, user) bind(c), numbers by value
    type(c_ptr) :: user = c_null_ptr
    integer(c_int64_t) :: written = 0, certified = 0, first = -1
  end type

  type, bind(c) :: rc_direct
    integer(c_size_t) :: struct_size = 248
    integer(rc_status) :: status = 0
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: iterations = 0, applications = 0, contacts = 0
    real(c_double) :: load = 0, energy = 0, kkt = 0, duality_gap = 0, load_lower = 0, load_upper = 0
    character(kind=c_char) :: note(160) = c_null_char
  end type

  type, bind(c) :: rc_area
    integer(c_size_t) :: struct_size = 40
    integer(c_int64_t) :: contacts = 0
    real(c_double) :: area = 0, perimeter = 0, corrected_area = 0
  end type

  type, bind(c) :: rc_patches
    integer(c_size_t) :: struct_size = 96
    integer(c_int32_t) :: neighbours = 4, reserved = 0
    integer(c_int64_t) :: room = 0
    type(c_ptr) :: label = c_null_ptr, cells = c_null_ptr  ! integer(c_int64_t), patches and points from 0
    type(c_ptr) :: area = c_null_ptr, perimeter = c_null_ptr, load = c_null_ptr
    type(c_ptr) :: mean_pressure = c_null_ptr, max_pressure = c_null_ptr
    type(c_ptr) :: peak = c_null_ptr  ! integer(c_int64_t)
    integer(c_int64_t) :: count = 0
  end type

  type, bind(c) :: rc_histogram
    integer(c_size_t) :: struct_size = 80
    integer(c_int64_t) :: bins = 0
    real(c_double) :: upper = 0
    type(c_ptr) :: counts = c_null_ptr  ! integer(c_int64_t)
    type(c_ptr) :: density = c_null_ptr
    real(c_double) :: width = 0
    integer(c_int64_t) :: contacts = 0, above = 0
    real(c_double) :: mean_pressure = 0, max_pressure = 0
  end type

  type, bind(c) :: rc_progress
    integer(c_size_t) :: struct_size = 40
    integer(c_int64_t) :: iteration = 0, applications = 0
    real(c_double) :: kkt = 0, seconds = 0
  end type

  type, bind(c) :: rc_context_config
    integer(c_size_t) :: struct_size = 40
    integer(c_int32_t) :: flags = 0, reserved = 0
    type(c_ptr) :: plugin_path = c_null_ptr
    type(c_funptr) :: log = c_null_funptr  ! subroutine log(level, message, user) bind(c)
    type(c_ptr) :: log_user = c_null_ptr
  end type

  type, bind(c) :: rc_component
    integer(c_size_t) :: struct_size = 40
    type(c_ptr) :: name = c_null_ptr, summary = c_null_ptr, license = c_null_ptr, origin = c_null_ptr  ! rc_from_c reads them
  end type

  type, bind(c) :: rc_option_spec
    integer(c_size_t) :: struct_size = 64
    type(c_ptr) :: key = c_null_ptr, default_value = c_null_ptr, choices = c_null_ptr, help = c_null_ptr
    integer(c_int32_t) :: type = 0, fixed = 0
    real(c_double) :: minimum = 0, maximum = 0
  end type

  interface
    subroutine rc_version(major, minor, patch, abi) bind(c); import
      integer(c_int32_t), intent(out), optional :: major, minor, patch, abi
    end subroutine
    type(c_ptr) function rc_status_name(status) bind(c); import
      integer(rc_status), value :: status
    end function
    type(c_ptr) function rc_status_text(status) bind(c); import
      integer(rc_status), value :: status
    end function
    type(c_ptr) function rc_last_error() bind(c); import
    end function
    subroutine rc_system_init(system, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_system), intent(out) :: system
    end subroutine
    subroutine rc_step_init(step, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_step), intent(out) :: step
    end subroutine
    subroutine rc_result_init(result, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_result), intent(out) :: result
    end subroutine
    subroutine rc_context_config_init(config, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_context_config), intent(out) :: config
    end subroutine
    subroutine rc_path_init(path, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_path), intent(out) :: path
    end subroutine
    subroutine rc_batch_init(batch, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_batch), intent(out) :: batch
    end subroutine
    subroutine rc_level_init(level, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_level), intent(out) :: level
    end subroutine
    subroutine rc_direct_init(result, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_direct), intent(out) :: result
    end subroutine
    subroutine rc_area_init(area, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_area), intent(out) :: area
    end subroutine
    subroutine rc_patches_init(patches, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_patches), intent(out) :: patches
    end subroutine
    subroutine rc_histogram_init(histogram, struct_size) bind(c); import
      integer(c_size_t), value :: struct_size
      type(rc_histogram), intent(out) :: histogram
    end subroutine

    integer(rc_status) function rc_context_create(config, out) bind(c); import
      type(rc_context_config), intent(in), optional :: config
      type(c_ptr), intent(out) :: out
    end function
    subroutine rc_context_destroy(context) bind(c); import
      type(c_ptr), value :: context
    end subroutine
    integer(c_int64_t) function rc_backend_count(context) bind(c); import
      type(c_ptr), value :: context
    end function
    integer(rc_status) function rc_backend_describe(context, i, out) bind(c); import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: i
      type(rc_component), intent(inout) :: out
    end function
    integer(c_int64_t) function rc_solver_count(context) bind(c); import
      type(c_ptr), value :: context
    end function
    integer(rc_status) function rc_solver_describe(context, i, out) bind(c); import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: i
      type(rc_component), intent(inout) :: out
    end function
    integer(c_int64_t) function rc_kernel_count(context) bind(c); import
      type(c_ptr), value :: context
    end function
    integer(rc_status) function rc_kernel_describe(context, i, out) bind(c); import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: i
      type(rc_component), intent(inout) :: out
    end function
    integer(rc_status) function rc_pair_supported(context, solver, backend, system, control, options) bind(c); import
      type(c_ptr), value :: context, options
      character(kind=c_char), intent(in) :: solver(*), backend(*)
      type(rc_system), intent(in) :: system
      integer(c_int32_t), value :: control
    end function
    integer(rc_status) function rc_kernel_coefficients(kernel, hx, hy, nx, ny, out) bind(c); import
      character(kind=c_char), intent(in) :: kernel(*)
      real(c_double), value :: hx, hy
      integer(c_int64_t), value :: nx, ny
      real(c_double), intent(out) :: out(nx, ny)
    end function

    integer(rc_status) function rc_options_create(context, out) bind(c); import
      type(c_ptr), value :: context
      type(c_ptr), intent(out) :: out
    end function
    subroutine rc_options_destroy(options) bind(c); import
      type(c_ptr), value :: options
    end subroutine
    integer(rc_status) function rc_options_set_int(options, key, value) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      integer(c_int64_t), value :: value
    end function
    integer(rc_status) function rc_options_set_real(options, key, value) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      real(c_double), value :: value
    end function
    integer(rc_status) function rc_options_set_text(options, key, value) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*), value(*)
    end function
    integer(rc_status) function rc_options_parse(options, key, text) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*), text(*)
    end function
    integer(rc_status) function rc_options_get_int(options, key, out) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      integer(c_int64_t), intent(out) :: out
    end function
    integer(rc_status) function rc_options_get_real(options, key, out) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      real(c_double), intent(out) :: out
    end function
    integer(rc_status) function rc_options_get_text(options, key, out) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      type(c_ptr), intent(out) :: out
    end function
    integer(c_int64_t) function rc_options_count(context) bind(c); import
      type(c_ptr), value :: context
    end function
    integer(rc_status) function rc_options_describe(context, i, out) bind(c); import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: i
      type(rc_option_spec), intent(inout) :: out
    end function

    integer(rc_status) function rc_contact_create(system, options, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(c_ptr), intent(out) :: out
    end function
    integer(rc_status) function rc_contact_set_options(contact, options) bind(c); import
      type(c_ptr), value :: contact, options
    end function
    integer(rc_status) function rc_contact_on_progress(contact, fn, user, every) bind(c); import
      type(c_ptr), value :: contact, user
      type(c_funptr), value :: fn  ! integer(c_int32_t) function fn(progress, user) bind(c)
      integer(c_int64_t), value :: every
    end function
    integer(rc_status) function rc_contact_solve(contact, step, result) bind(c); import
      type(c_ptr), value :: contact
      type(rc_step), intent(in) :: step
      type(rc_result), intent(inout) :: result
    end function
    integer(rc_status) function rc_contact_certify(contact, step, result) bind(c); import
      type(c_ptr), value :: contact
      type(rc_step), intent(in) :: step
      type(rc_result), intent(inout) :: result
    end function
    integer(rc_status) function rc_contact_solve_path(contact, path) bind(c); import
      type(c_ptr), value :: contact
      type(rc_path), intent(inout) :: path
    end function
    integer(rc_status) function rc_contact_level(contact, i, out) bind(c); import
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: i
      type(rc_level), intent(inout) :: out
    end function
    integer(rc_status) function rc_contact_points(contact, room, index, p, n) bind(c); import
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: room
      integer(c_int64_t), intent(out), optional :: index(*)  ! point numbers from 0
      real(c_double), intent(out), optional :: p(*)
      integer(c_int64_t), intent(out) :: n
    end function
    integer(rc_status) function rc_contact_reset(contact) bind(c); import
      type(c_ptr), value :: contact
    end function
    subroutine rc_contact_cancel(contact) bind(c); import
      type(c_ptr), value :: contact
    end subroutine
    subroutine rc_contact_destroy(contact) bind(c); import
      type(c_ptr), value :: contact
    end subroutine
    integer(rc_status) function rc_solve(system, step, options, result) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_step), intent(in) :: step
      type(c_ptr), value :: options
      type(rc_result), intent(inout) :: result
    end function
    integer(rc_status) function rc_batch_solve(system, options, batch) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(rc_batch), intent(inout) :: batch
    end function

    ! H(ld, n): a symmetric matrix is the same by rows and by columns.
    integer(rc_status) function rc_greedy(n, H, ld, u, p, w, tol, max_iter, result) bind(c); import
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(ld, *), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_polonsky_keer(n, H, ld, u, p, w, tol, max_iter, result) bind(c); import
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(ld, *), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_nnls(n, H, ld, u, p, w, tol, max_iter, result) bind(c); import
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(ld, *), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_gp(n, H, ld, u, p, w, tol, max_iter, result) bind(c); import
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(ld, *), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_admm(n, H, ld, u, p, w, tol, max_iter, result) bind(c); import
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(ld, *), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_cmr(nx, ny, hx, hy, modulus, heights, delta, levels, h, inner, p, result) bind(c); import
      integer(c_int64_t), value :: nx, ny, levels
      real(c_double), value :: hx, hy, modulus, delta, h
      real(c_double), intent(in) :: heights(nx, *)
      character(kind=c_char), intent(in), optional :: inner(*)
      real(c_double), intent(inout) :: p(nx, *)
      type(rc_direct), intent(inout), optional :: result
    end function

    integer(rc_status) function rc_area_measure(system, p, mask, out) bind(c); import
      type(rc_system), intent(in) :: system
      real(c_double), intent(in) :: p(*)
      type(c_ptr), value :: mask  ! integer(c_int8_t)
      type(rc_area), intent(inout) :: out
    end function
    integer(rc_status) function rc_patches_find(system, p, mask, out) bind(c); import
      type(rc_system), intent(in) :: system
      real(c_double), intent(in) :: p(*)
      type(c_ptr), value :: mask  ! integer(c_int8_t)
      type(rc_patches), intent(inout) :: out
    end function
    integer(rc_status) function rc_histogram_fill(system, p, mask, out) bind(c); import
      type(rc_system), intent(in) :: system
      real(c_double), intent(in) :: p(*)
      type(c_ptr), value :: mask  ! integer(c_int8_t)
      type(rc_histogram), intent(inout) :: out
    end function
  end interface

  ! A Fortran string from a C one: a char array of a struct, or a pointer such as rc_status_text(status).
  interface rc_from_c
    procedure from_array, from_pointer
  end interface

contains

  ! The string as C wants it: trailing blanks off, a NUL at the end.
  pure function rc_to_c(string) result(c)
    character(*), intent(in) :: string
    character(len_trim(string) + 1, kind=c_char) :: c
    c = trim(string)//c_null_char
  end function

  ! The text of the calling thread's last failure.
  function rc_error_message() result(text)
    character(:), allocatable :: text
    text = from_pointer(rc_last_error())
  end function

  pure function from_array(c) result(text)
    character(kind=c_char), intent(in) :: c(:)
    character(:), allocatable :: text
    integer :: i, n
    n = findloc(c, c_null_char, dim=1) - 1
    if (n < 0) n = size(c)
    allocate (character(n) :: text)
    do i = 1, n
      text(i:i) = c(i)
    end do
  end function

  function from_pointer(c) result(text)
    type(c_ptr), intent(in) :: c
    character(:), allocatable :: text
    character(kind=c_char), pointer :: chars(:)
    interface
      pure integer(c_size_t) function strlen(string) bind(c); import
        type(c_ptr), value :: string
      end function
    end interface
    text = ''
    if (.not. c_associated(c)) return
    call c_f_pointer(c, chars, [strlen(c)])
    text = from_array(chars)
  end function
end module
