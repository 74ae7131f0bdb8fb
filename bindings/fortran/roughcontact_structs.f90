! The structs of the headers but surface.h, formats.h, flow.h, ranks.h, mpi.h and plugin.h, member for member,
! with the values of the RC_..._INIT macros.
!
! Arrays are rc_const_array(c_loc(x)) and rc_array(c_loc(x)) of contiguous target arrays, x fastest: a Fortran array
! p(nx, ny) has the order of the library; rc_array() is none. A remark after a pointer is its type in C. Callbacks
! are c_funloc(f) of bind(c) procedures. Logical masks of Fortran are no masks of C: integer(c_int8_t), 0 or 1.
! Written by scripts/bindings.py.
module roughcontact_structs
  use roughcontact_constants
  implicit none

  type, bind(c) :: rc_array
    type(c_ptr) :: data = c_null_ptr  ! void *
    integer(c_int32_t) :: type = 0, reserved = 0
    type(c_ptr) :: memory = c_null_ptr  ! const char *
  end type

  type, bind(c) :: rc_const_array
    type(c_ptr) :: data = c_null_ptr  ! const void *
    integer(c_int32_t) :: type = 0, reserved = 0
    type(c_ptr) :: memory = c_null_ptr  ! const char *
  end type

  type, bind(c) :: rc_system
    integer(c_size_t) :: struct_size = merge(152, 120, c_intptr_t == 8)
    integer(c_int32_t) :: op = RC_OPERATOR_HALFSPACE, boundary = 0
    integer(c_int64_t) :: nx = 0, ny = 0
    real(c_double) :: hx = 0, hy = 0, modulus = 0
    type(c_ptr) :: dense = c_null_ptr  ! const double *
    integer(c_int64_t) :: dense_ld = 0
    type(c_funptr) :: apply = c_null_funptr  ! integer(c_int32_t) function apply(x, y, n, user) bind(c)
    type(c_ptr) :: user = c_null_ptr  ! void *
    real(c_double) :: hardness = 0
    integer(c_int32_t) :: creep_by = 0, creep_terms = 0
    type(rc_const_array) :: creep_ratio = rc_const_array(), creep_time = rc_const_array()
  end type

  type, bind(c) :: rc_step
    integer(c_size_t) :: struct_size = merge(112, 84, c_intptr_t == 8)
    integer(c_int32_t) :: control = 0, warm_start = 1
    real(c_double) :: target = 0
    type(rc_const_array) :: undeformed_gap = rc_const_array(), mask = rc_const_array(), p0 = rc_const_array()
    integer(c_int32_t) :: borrow = 0, reserved = 0
    real(c_double) :: time = 0
  end type

  type, bind(c) :: rc_result
    integer(c_size_t) :: struct_size = merge(1016, 996, c_intptr_t == 8)
    type(rc_array) :: p = rc_array(), gap = rc_array()
    integer(rc_status) :: status = RC_ERR_ARGUMENT
    integer(c_int32_t) :: homogeneous = 0
    real(c_double) :: load = 0, approach = 0, mean_pressure = 0, max_pressure = 0, contact_area = 0, area_fraction = 0, &
      mean_gap = 0, energy = 0
    integer(c_int64_t) :: contacts = 0
    real(c_double) :: kkt_primal = 0, kkt_dual = 0, kkt_complementarity = 0, kkt_control = 0, tolerance = 0, duality_gap = 0, &
      gap_error = 0, load_lower = 0, load_upper = 0, area_lower = 0, area_upper = 0
    integer(c_int64_t) :: proven_contacts = 0, proven_open = 0, undecided = 0
    real(c_double) :: stiffness = 0, stiffness_lower = 0, stiffness_upper = 0, punch_stiffness = 0
    integer(c_int64_t) :: capped = 0
    real(c_double) :: plastic_volume = 0
    integer(c_int64_t) :: proven_capped = 0, model_nx = 0, model_ny = 0
    real(c_double) :: error_estimate = 0, area_estimate = 0, left_out = 0
    integer(c_int64_t) :: points = 0, candidates = 0, modelled = 0, iterations = 0, products = 0, levels = 0
    real(c_double) :: seconds = 0, setup_seconds = 0
    character(kind=c_char) :: solver(32) = c_null_char, backend(32) = c_null_char, kernel(32) = c_null_char, note(512) = c_null_char
  end type

  type, bind(c) :: rc_progress
    integer(c_size_t) :: struct_size = merge(40, 36, c_intptr_t == 8)
    integer(c_int64_t) :: iteration = 0, products = 0
    real(c_double) :: kkt = 0, seconds = 0
  end type

  type, bind(c) :: rc_columns
    type(rc_array) :: load = rc_array(), approach = rc_array(), contact_area = rc_array(), mean_gap = rc_array(), &
      energy = rc_array(), stiffness = rc_array(), load_lower = rc_array(), load_upper = rc_array(), area_lower = rc_array(), &
      area_upper = rc_array(), stiffness_lower = rc_array(), stiffness_upper = rc_array(), certificate = rc_array(), &
      iterations = rc_array(), products = rc_array(), status = rc_array()
  end type

  type, bind(c) :: rc_history
    integer(c_size_t) :: struct_size = merge(536, 364, c_intptr_t == 8)
    integer(c_int32_t) :: control = 0, warm_start = 1
    integer(c_int64_t) :: n = 0
    type(rc_const_array) :: targets = rc_const_array(), undeformed_gap = rc_const_array(), mask = rc_const_array()
    type(c_funptr) :: fn = c_null_funptr  ! integer(c_int32_t) function fn(step, result, user) bind(c)
    type(c_ptr) :: user = c_null_ptr  ! void *
    integer(c_int64_t) :: completed = 0
    integer(c_int32_t) :: want_gap = 1, virgin = 0
    type(rc_columns) :: columns = rc_columns()
    type(rc_const_array) :: times = rc_const_array()
  end type

  type, bind(c) :: rc_state
    integer(c_size_t) :: struct_size = merge(192, 140, c_intptr_t == 8)
    type(rc_const_array) :: undeformed_gap = rc_const_array(), mask = rc_const_array(), p = rc_const_array()
    real(c_double) :: approach = 0, load = 0
    type(rc_const_array) :: p_before = rc_const_array()
    real(c_double) :: approach_before = 0, load_before = 0
    type(rc_const_array) :: indentation = rc_const_array(), creep = rc_const_array()
    real(c_double) :: time = 0
  end type

  type, bind(c) :: rc_batch
    integer(c_size_t) :: struct_size = merge(640, 448, c_intptr_t == 8)
    integer(c_int32_t) :: control = 0, warm_start = 1
    integer(c_int64_t) :: n = 0, steps = 0
    type(rc_const_array) :: targets = rc_const_array()
    integer(c_int64_t) :: target_stride = 0
    type(rc_const_array) :: undeformed_gap = rc_const_array()
    integer(c_int64_t) :: undeformed_gap_stride = 0
    type(rc_const_array) :: mask = rc_const_array()
    integer(c_int64_t) :: mask_stride = 0
    type(rc_const_array) :: p0 = rc_const_array()
    type(rc_array) :: p = rc_array()
    type(c_funptr) :: fn = c_null_funptr  ! integer(c_int32_t) function fn(contact, step, result, user) bind(c)
    type(c_ptr) :: user = c_null_ptr  ! void *
    integer(c_int64_t) :: written = 0, certified = 0, first = -1
    type(c_funptr) :: progress = c_null_funptr  ! integer(c_int32_t) function progress(ended, user) bind(c)
    integer(c_int32_t) :: virgin = 0, reserved = 0
    type(rc_columns) :: columns = rc_columns()
    type(rc_const_array) :: times = rc_const_array()
  end type

  type, bind(c) :: rc_level
    integer(c_size_t) :: struct_size = merge(104, 92, c_intptr_t == 8)
    type(rc_array) :: p = rc_array()
    integer(rc_status) :: status = RC_ERR_ARGUMENT
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: nx = 0, ny = 0
    real(c_double) :: hx = 0, hy = 0, approach = 0, load = 0
    integer(c_int64_t) :: candidates = 0, contacts = 0
  end type

  type, bind(c) :: rc_gradient
    integer(c_size_t) :: struct_size = merge(136, 108, c_intptr_t == 8)
    type(rc_const_array) :: dJ_dp = rc_const_array(), dJ_dgap = rc_const_array()
    real(c_double) :: dJ_dload = 0, dJ_dapproach = 0
    type(rc_array) :: dJ_dundeformed_gap = rc_array()
    real(c_double) :: dJ_dtarget = 0, dJ_dmodulus = 0, error = 0
    integer(c_int64_t) :: undecided = 0, products = 0
  end type

  type, bind(c) :: rc_tangent
    integer(c_size_t) :: struct_size = merge(136, 108, c_intptr_t == 8)
    type(rc_const_array) :: dundeformed_gap = rc_const_array()
    real(c_double) :: dtarget = 0, dmodulus = 0
    type(rc_array) :: dp = rc_array(), dgap = rc_array()
    real(c_double) :: dload = 0, dapproach = 0, error = 0
    integer(c_int64_t) :: undecided = 0, products = 0
  end type

  type, bind(c) :: rc_direct
    integer(c_size_t) :: struct_size = merge(600, 596, c_intptr_t == 8)
    integer(rc_status) :: status = RC_ERR_ARGUMENT
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: iterations = 0, products = 0, contacts = 0
    real(c_double) :: load = 0, energy = 0, kkt = 0, duality_gap = 0, load_lower = 0, load_upper = 0
    character(kind=c_char) :: note(512) = c_null_char
  end type

  type, bind(c) :: rc_area
    integer(c_size_t) :: struct_size = merge(40, 36, c_intptr_t == 8)
    integer(c_int64_t) :: contacts = 0
    real(c_double) :: area = 0, perimeter = 0, corrected_area = 0
  end type

  type, bind(c) :: rc_patches
    integer(c_size_t) :: struct_size = merge(224, 156, c_intptr_t == 8)
    integer(c_int32_t) :: neighbours = 4, reserved = 0
    integer(c_int64_t) :: room = 0
    type(rc_array) :: label = rc_array(), cells = rc_array(), area = rc_array(), perimeter = rc_array(), load = rc_array(), &
      mean_pressure = rc_array(), max_pressure = rc_array(), peak = rc_array()
    integer(c_int64_t) :: count = 0
  end type

  type, bind(c) :: rc_histogram
    integer(c_size_t) :: struct_size = merge(112, 92, c_intptr_t == 8)
    integer(c_int64_t) :: bins = 0
    real(c_double) :: upper = 0
    type(rc_array) :: counts = rc_array(), density = rc_array()
    real(c_double) :: width = 0
    integer(c_int64_t) :: contacts = 0, above = 0
    real(c_double) :: mean_pressure = 0, max_pressure = 0
  end type

  type, bind(c) :: rc_law_spec
    integer(c_size_t) :: struct_size = merge(136, 108, c_intptr_t == 8)
    type(rc_const_array) :: undeformed_gap = rc_const_array(), mask = rc_const_array()
    real(c_double) :: area = 0, p_lower = 0, p_upper = 0, tolerance = 0.001_c_double, tolerance_conductance = 0
    integer(c_int32_t) :: bulk = 0, reserved = 0
    real(c_double) :: bulk_stiffness = 0
    integer(c_int64_t) :: max_nodes = 0
    type(c_funptr) :: progress = c_null_funptr  ! integer(c_int32_t) function progress(progress, user) bind(c)
    type(c_ptr) :: user = c_null_ptr  ! void *
  end type

  type, bind(c) :: rc_law_info
    integer(c_size_t) :: struct_size = merge(144, 140, c_intptr_t == 8)
    integer(c_int64_t) :: nodes = 0, solves = 0
    real(c_double) :: seconds = 0
    integer(c_int32_t) :: bounds = 0, bulk = 0
    real(c_double) :: width = 0, width_conductance = 0, width_area = 0, energy_error = 0, modulus = 0, hardness = 0, area = 0, &
      bulk_stiffness = 0, mean_gap = 0, x_lower = 0, x_upper = 0, p_lower = 0, p_upper = 0
  end type

  type, bind(c) :: rc_law_point
    integer(c_size_t) :: struct_size = merge(144, 140, c_intptr_t == 8)
    real(c_double) :: x = 0, p = 0, p_lower = 0, p_upper = 0, slope = 0, slope_lower = 0, slope_upper = 0, energy = 0, &
      area_fraction = 0, area_lower = 0, area_upper = 0, conductance = 0, conductance_lower = 0, conductance_upper = 0, &
      between_lower = 0, between_upper = 0
    integer(c_int32_t) :: bounds = 0, reserved = 0
  end type

  type, bind(c) :: rc_law_slip_state
    integer(c_size_t) :: struct_size = merge(632, 628, c_intptr_t == 8)
    real(c_double) :: mu = 0, nu = 0, p = 0, slope = 0, shear(2) = 0, shear_by_x(2) = 0, shear_by_slip(4) = 0, dissipated = 0, &
      joined = 0, memory(64) = 0
  end type

  type, bind(c) :: rc_law_export_spec
    integer(c_size_t) :: struct_size = merge(88, 84, c_intptr_t == 8)
    integer(c_int32_t) :: format = 0, reserved = 0
    integer(c_int64_t) :: rows = 0
    real(c_double) :: rho1 = 0, rho2 = 0, length = 0, force = 0, beyond = 0, error = 0, mu = 0, nu = 0
  end type

  type, bind(c) :: rc_component
    integer(c_size_t) :: struct_size = merge(80, 52, c_intptr_t == 8)
    ! const char *
    type(c_ptr) :: name = c_null_ptr, summary = c_null_ptr, license = c_null_ptr, origin = c_null_ptr, default_value = c_null_ptr, &
      choices = c_null_ptr
    integer(c_int32_t) :: type = 0, fixed = 0
    real(c_double) :: minimum = 0, maximum = 0
  end type
end module
