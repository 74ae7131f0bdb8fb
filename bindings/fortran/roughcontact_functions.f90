! The functions of the headers but surface.h, formats.h, flow.h, ranks.h, mpi.h and plugin.h, name for name;
! units, rules and errors are described there.
!
! Objects (context, options, contact) are type(c_ptr); c_null_ptr where C takes NULL. Names and keys are passed
! as rc_to_c('fft'). Points and components are numbered from 0, as in C.
! Written by scripts/bindings.py.
module roughcontact_functions
  use roughcontact_structs
  implicit none

  interface
    type(c_ptr) function rc_status_name(status) bind(c); import
      integer(rc_status), value :: status
    end function
    type(c_ptr) function rc_last_error() bind(c); import
    end function
    subroutine rc_stop_when(flag) bind(c); import
      integer(c_int32_t), intent(in), optional :: flag
    end subroutine
    integer(rc_status) function rc_file_write(path, data, size) bind(c); import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: data
      integer(c_size_t), value :: size
    end function
    subroutine rc_version(major, minor, patch, abi) bind(c); import
      integer(c_int32_t), intent(inout), optional :: major, minor, patch, abi
    end subroutine
    integer(rc_status) function rc_gap_from_heights(n, heights, mask, undeformed_gap) bind(c); import
      integer(c_int64_t), value :: n
      type(rc_const_array), value :: heights, mask
      type(rc_array), value :: undeformed_gap
    end function
    integer(rc_status) function rc_options_create(context, out) bind(c); import
      type(c_ptr), value :: context
      type(c_ptr), intent(inout) :: out
    end function
    integer(rc_status) function rc_options_copy(options, out) bind(c); import
      type(c_ptr), value :: options
      type(c_ptr), intent(inout) :: out
    end function
    subroutine rc_options_destroy(options) bind(c); import
      type(c_ptr), value :: options
    end subroutine
    integer(rc_status) function rc_options_set_number(options, key, value) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      real(c_double), value :: value
    end function
    integer(rc_status) function rc_options_set_text(options, key, text) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*), text(*)
    end function
    integer(rc_status) function rc_options_get_number(options, key, out) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      real(c_double), intent(inout) :: out
    end function
    integer(rc_status) function rc_options_get_text(options, key, out) bind(c); import
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: key(*)
      type(c_ptr), intent(inout) :: out
    end function
    integer(rc_status) function rc_solve(system, step, options, result) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_step), intent(in) :: step
      type(c_ptr), value :: options
      type(rc_result), intent(inout) :: result
    end function
    integer(rc_status) function rc_contact_create(system, options, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(c_ptr), intent(inout) :: out
    end function
    subroutine rc_contact_destroy(contact) bind(c); import
      type(c_ptr), value :: contact
    end subroutine
    integer(rc_status) function rc_contact_solve(contact, step, result) bind(c); import
      type(c_ptr), value :: contact
      type(rc_step), intent(in) :: step
      type(rc_result), intent(inout) :: result
    end function
    integer(rc_status) function rc_contact_points(contact, room, index, p, n) bind(c); import
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: room
      type(rc_array), value :: index, p
      integer(c_int64_t), intent(inout) :: n
    end function
    integer(rc_status) function rc_contact_set_options(contact, options) bind(c); import
      type(c_ptr), value :: contact, options
    end function
    integer(rc_status) function rc_contact_on_progress(contact, fn, user, every) bind(c); import
      type(c_ptr), value :: contact, user
      type(c_funptr), value :: fn
      integer(c_int64_t), value :: every
    end function
    integer(rc_status) function rc_contact_explain(contact, out) bind(c); import
      type(c_ptr), value :: contact
      type(c_ptr), intent(inout) :: out
    end function
    integer(rc_status) function rc_contact_reset(contact) bind(c); import
      type(c_ptr), value :: contact
    end function
    integer(rc_status) function rc_contact_solve_history(contact, history) bind(c); import
      type(c_ptr), value :: contact
      type(rc_history), intent(inout) :: history
    end function
    integer(rc_status) function rc_contact_indentation(contact, indentation) bind(c); import
      type(c_ptr), value :: contact
      type(rc_array), value :: indentation
    end function
    integer(rc_status) function rc_contact_creep(contact, creep, time) bind(c); import
      type(c_ptr), value :: contact
      type(rc_array), value :: creep
      real(c_double), intent(inout), optional :: time
    end function
    integer(rc_status) function rc_contact_restore(contact, state) bind(c); import
      type(c_ptr), value :: contact
      type(rc_state), intent(in) :: state
    end function
    integer(rc_status) function rc_batch_solve(system, options, batch) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(rc_batch), intent(inout) :: batch
    end function
    integer(rc_status) function rc_contact_level(contact, i, out) bind(c); import
      type(c_ptr), value :: contact
      integer(c_int64_t), value :: i
      type(rc_level), intent(inout) :: out
    end function
    integer(rc_status) function rc_contact_gradient(contact, gradient) bind(c); import
      type(c_ptr), value :: contact
      type(rc_gradient), intent(inout) :: gradient
    end function
    integer(rc_status) function rc_contact_tangent(contact, tangent) bind(c); import
      type(c_ptr), value :: contact
      type(rc_tangent), intent(inout) :: tangent
    end function
    integer(rc_status) function rc_greedy(n, H, ld, u, p, w, tol, max_iter, result) bind(c); import
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(*), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_cmr(nx, ny, hx, hy, modulus, heights, approach, levels, radius, inner, p, result) bind(c); import
      integer(c_int64_t), value :: nx, ny, levels
      real(c_double), value :: hx, hy, modulus, approach, radius
      real(c_double), intent(in) :: heights(*)
      character(kind=c_char), intent(in), optional :: inner(*)
      real(c_double), intent(inout) :: p(*)
      type(rc_direct), intent(inout), optional :: result
    end function
    integer(rc_status) function rc_product_create(system, options, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(c_ptr), intent(inout) :: out
    end function
    subroutine rc_product_destroy(product) bind(c); import
      type(c_ptr), value :: product
    end subroutine
    integer(rc_status) function rc_product_apply(product, p, u) bind(c); import
      type(c_ptr), value :: product
      type(rc_const_array), value :: p
      type(rc_array), value :: u
    end function
    integer(rc_status) function rc_area_measure(system, p, mask, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_const_array), value :: p, mask
      type(rc_area), intent(inout) :: out
    end function
    integer(rc_status) function rc_patches_find(system, p, mask, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_const_array), value :: p, mask
      type(rc_patches), intent(inout) :: out
    end function
    integer(rc_status) function rc_histogram_fill(system, p, mask, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_const_array), value :: p, mask
      type(rc_histogram), intent(inout) :: out
    end function
    integer(rc_status) function rc_crossing_find(system, p, mask, contact, gap) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_const_array), value :: p, mask
      integer(c_int32_t), intent(inout) :: contact, gap
    end function
    integer(rc_status) function rc_conductance(system, result, rho1, rho2, conductance, lower, upper) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_result), intent(in) :: result
      real(c_double), value :: rho1, rho2
      real(c_double), intent(inout) :: conductance
      real(c_double), intent(inout), optional :: lower, upper
    end function
    integer(rc_status) function rc_punch_stiffness(system, mask, options, stiffness, lower, upper) bind(c); import
      type(rc_system), intent(in) :: system
      type(rc_const_array), value :: mask
      type(c_ptr), value :: options
      real(c_double), intent(inout) :: stiffness
      real(c_double), intent(inout), optional :: lower, upper
    end function
    integer(rc_status) function rc_law_create(system, options, spec, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(rc_law_spec), intent(in) :: spec
      type(c_ptr), intent(inout) :: out
    end function
    subroutine rc_law_destroy(law) bind(c); import
      type(c_ptr), value :: law
    end subroutine
    integer(rc_status) function rc_law_describe(law, out) bind(c); import
      type(c_ptr), value :: law
      type(rc_law_info), intent(inout) :: out
    end function
    integer(rc_status) function rc_law_describe_node(law, i, out) bind(c); import
      type(c_ptr), value :: law
      integer(c_int64_t), value :: i
      type(rc_law_point), intent(inout) :: out
    end function
    integer(rc_status) function rc_law_pressure(law, x, p, slope, energy) bind(c); import
      type(c_ptr), value :: law
      real(c_double), value :: x
      real(c_double), intent(inout) :: p
      real(c_double), intent(inout), optional :: slope, energy
    end function
    integer(rc_status) function rc_law_pressures(law, n, x, p, slope, energy) bind(c); import
      type(c_ptr), value :: law
      integer(c_int64_t), value :: n
      type(rc_const_array), value :: x
      type(rc_array), value :: p, slope, energy
    end function
    integer(rc_status) function rc_law_overclosure(law, p, x) bind(c); import
      type(c_ptr), value :: law
      real(c_double), value :: p
      real(c_double), intent(inout) :: x
    end function
    integer(rc_status) function rc_law_gap_conductance(law, p, rho1, rho2, conductance) bind(c); import
      type(c_ptr), value :: law
      real(c_double), value :: p, rho1, rho2
      real(c_double), intent(inout) :: conductance
    end function
    integer(rc_status) function rc_law_evaluate(law, x, out) bind(c); import
      type(c_ptr), value :: law
      real(c_double), value :: x
      type(rc_law_point), intent(inout) :: out
    end function
    integer(rc_status) function rc_law_slip(law, before, x, slip, after) bind(c); import
      type(c_ptr), value :: law
      type(rc_law_slip_state), intent(in) :: before
      real(c_double), value :: x
      real(c_double), intent(in) :: slip(*)
      type(rc_law_slip_state), intent(inout) :: after
    end function
    integer(rc_status) function rc_law_slip_bounds(law, state, lower, upper) bind(c); import
      type(c_ptr), value :: law
      type(rc_law_slip_state), intent(in) :: state
      real(c_double), intent(inout) :: lower(*), upper(*)
    end function
    integer(rc_status) function rc_law_save(law, path) bind(c); import
      type(c_ptr), value :: law
      character(kind=c_char), intent(in) :: path(*)
    end function
    integer(rc_status) function rc_law_load(path, out) bind(c); import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(inout) :: out
    end function
    integer(rc_status) function rc_law_export(law, path, spec) bind(c); import
      type(c_ptr), value :: law
      character(kind=c_char), intent(in) :: path(*)
      type(rc_law_export_spec), intent(inout) :: spec
    end function
    integer(rc_status) function rc_law_open(name, path, out) bind(c); import
      character(kind=c_char), intent(in) :: name(*), path(*)
      type(c_ptr), intent(inout) :: out
    end function
    integer(rc_status) function rc_context_create(flags, plugin_path, log, log_user, out) bind(c); import
      integer(c_int32_t), value :: flags
      character(kind=c_char), intent(in), optional :: plugin_path(*)
      type(c_funptr), value :: log
      type(c_ptr), value :: log_user
      type(c_ptr), intent(inout) :: out
    end function
    subroutine rc_context_destroy(context) bind(c); import
      type(c_ptr), value :: context
    end subroutine
    integer(c_int64_t) function rc_component_count(context, kind) bind(c); import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: kind
    end function
    integer(rc_status) function rc_component_describe(context, kind, i, out) bind(c); import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: kind
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
      real(c_double), intent(inout) :: out(*)
    end function
    integer(c_int64_t) function rc_usable_cores(allowed) bind(c); import
      integer(c_int64_t), value :: allowed
    end function
  end interface
  procedure(rc_status_name), bind(c) :: rc_status_text
  procedure(rc_contact_destroy), bind(c) :: rc_contact_cancel
  procedure(rc_contact_solve), bind(c) :: rc_contact_certify
  procedure(rc_greedy), bind(c) :: rc_polonsky_keer, rc_nnls, rc_gp, rc_admm
end module
