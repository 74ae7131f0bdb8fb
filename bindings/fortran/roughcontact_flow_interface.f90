! The C interface of <roughcontact/flow.h>, name for name; units, rules and errors are described there. A program
! that uses it links libroughcontact-flow, and is then under the GPL because of CHOLMOD.
! Written by scripts/bindings.py.
module roughcontact_flow_interface
  use roughcontact_structs
  implicit none

  integer(c_int32_t), parameter :: RC_FLOW_X = 1, RC_FLOW_Y = 2
  integer(c_int32_t), parameter :: RC_FLOW_CLOSED = 1, RC_FLOW_PERIODIC = 2

  type, bind(c) :: rc_flow_spec
    integer(c_size_t) :: struct_size = merge(184, 148, c_intptr_t == 8)
    integer(c_int32_t) :: along = RC_FLOW_X, sides = 0
    real(c_double) :: viscosity = 0, pressure_drop = 0, width = 0.01_c_double, memory = 0
    integer(c_int64_t) :: nx = 0, ny = 0
    real(c_double) :: hx = 0, hy = 0
    type(rc_const_array) :: gap = rc_const_array(), gap_error = rc_const_array(), mask = rc_const_array()
    real(c_double) :: load = 0
    type(rc_array) :: potential = rc_array()
  end type

  type, bind(c) :: rc_flow_result
    integer(c_size_t) :: struct_size = merge(96, 92, c_intptr_t == 8)
    integer(rc_status) :: status = RC_ERR_ARGUMENT
    integer(c_int32_t) :: crosses = 0, iterations = 0, reserved = 0
    real(c_double) :: flow = 0, lower = 0, upper = 0, constriction = 0
    integer(c_int64_t) :: constriction_x = 0, constriction_y = 0
    real(c_double) :: gap_error = 0, dropped = 0, seconds = 0
  end type

  type, bind(c) :: rc_flow_factors
    integer(c_size_t) :: struct_size = merge(104, 100, c_intptr_t == 8)
    integer(rc_status) :: status = RC_ERR_ARGUMENT
    integer(c_int32_t) :: reserved = 0
    real(c_double) :: xx = 0, xy = 0, yy = 0, xx_lower = 0, xx_upper = 0, xy_lower = 0, xy_upper = 0, yy_lower = 0, yy_upper = 0, &
      mean_gap = 0, seconds = 0
  end type

  type, bind(c) :: rc_flow_closing
    integer(c_size_t) :: struct_size = merge(56, 52, c_intptr_t == 8)
    integer(rc_status) :: status = RC_ERR_ARGUMENT
    integer(c_int32_t) :: steps = 0
    real(c_double) :: lower = 0, upper = 0, area_fraction = 0, constriction = 0, seconds = 0
  end type

  interface
    type(c_ptr) function rc_flow_last_error() bind(c); import
    end function
    subroutine rc_flow_stop_when(flag) bind(c); import
      integer(c_int32_t), intent(in), optional :: flag
    end subroutine
    integer(rc_status) function rc_flow_solve(spec, out) bind(c); import
      type(rc_flow_spec), intent(in) :: spec
      type(rc_flow_result), intent(inout) :: out
    end function
    integer(rc_status) function rc_flow_of_result(system, options, result, spec, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(rc_result), intent(in) :: result
      type(rc_flow_spec), intent(in) :: spec
      type(rc_flow_result), intent(inout) :: out
    end function
    integer(rc_status) function rc_flow_factors_find(spec, out) bind(c); import
      type(rc_flow_spec), intent(in) :: spec
      type(rc_flow_factors), intent(inout) :: out
    end function
    integer(rc_status) function rc_flow_closing_pressure(system, options, step, spec, out) bind(c); import
      type(rc_system), intent(in) :: system
      type(c_ptr), value :: options
      type(rc_step), intent(in) :: step
      type(rc_flow_spec), intent(in) :: spec
      type(rc_flow_closing), intent(inout) :: out
    end function
  end interface
end module
