! How much leaks through a gap: <roughcontact/flow.h> name for name (rc_flow_...), and procedures in the manner of Fortran
! (rcf_flow_...) that take arrays (nx, ny) and report as those of module roughcontact do. An interval that is wider than wanted
! has the status RC_STOP_STALLED.
module roughcontact_flow
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_options, only: rcf_or_null
  use roughcontact_strings
  use roughcontact_flow_interface
  implicit none
  private :: given, check

contains

  ! The flow through a gap; nx and ny are those of the gap, whatever spec says. So in rcf_flow_factors_find.
  subroutine rcf_flow_solve(spec, gap, answer, gap_error, potential, stat, errmsg)
    type(rc_flow_spec), intent(in) :: spec
    real(c_double), intent(in), target, contiguous :: gap(:, :)
    type(rc_flow_result), intent(out) :: answer
    real(c_double), intent(in), optional, target, contiguous :: gap_error(:, :)
    real(c_double), intent(inout), optional, target, contiguous :: potential(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_flow_spec) :: whole
    if (.not. given('rcf_flow_solve', spec, gap, gap_error, whole, stat, errmsg)) return
    if (.not. rcf_shaped('rcf_flow_solve', 'potential', potential, whole%nx, whole%ny, stat, errmsg)) return
    whole%potential = rcf_out(potential)
    call check(rc_flow_solve(whole, answer), stat, errmsg)
  end subroutine

  subroutine rcf_flow_factors_find(spec, gap, answer, gap_error, stat, errmsg)
    type(rc_flow_spec), intent(in) :: spec
    real(c_double), intent(in), target, contiguous :: gap(:, :)
    type(rc_flow_factors), intent(out) :: answer
    real(c_double), intent(in), optional, target, contiguous :: gap_error(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_flow_spec) :: whole
    if (.not. given('rcf_flow_factors_find', spec, gap, gap_error, whole, stat, errmsg)) return
    call check(rc_flow_factors_find(whole, answer), stat, errmsg)
  end subroutine

  ! The flow through the gap of a step, which gave result, p and gap.
  subroutine rcf_flow_of_result(spec, system, result, p, gap, answer, mask, options, stat, errmsg)
    type(rc_flow_spec), intent(in) :: spec
    type(rc_system), intent(in) :: system
    type(rc_result), intent(in) :: result
    real(c_double), intent(in), target, contiguous :: p(:, :), gap(:, :)
    type(rc_flow_result), intent(out) :: answer
    logical, intent(in), optional :: mask(:, :)
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(*), parameter :: where = 'rcf_flow_of_result'
    type(rc_flow_spec) :: whole
    type(rc_result) :: solved
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    whole = spec
    if (.not. rcf_masked(where, mask, system%nx, system%ny, bytes, whole%mask, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'p', p, system%nx, system%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'gap', gap, system%nx, system%ny, stat, errmsg)) return
    solved = result
    if (size(p) > 0) solved%p%data = c_loc(p)
    if (size(gap) > 0) solved%gap%data = c_loc(gap)
    call check(rc_flow_of_result(system, rcf_or_null(options), solved, whole, answer), stat, errmsg)
  end subroutine

  ! The pressure at which a seal closes; spec: along, sides and width.
  subroutine rcf_flow_closing_pressure(spec, system, undeformed_gap, answer, mask, options, stat, errmsg)
    type(rc_flow_spec), intent(in) :: spec
    type(rc_system), intent(in) :: system
    real(c_double), intent(in), target, contiguous :: undeformed_gap(:, :)
    type(rc_flow_closing), intent(out) :: answer
    logical, intent(in), optional :: mask(:, :)
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(*), parameter :: where = 'rcf_flow_closing_pressure'
    type(rc_step) :: step
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    if (.not. rcf_masked(where, mask, system%nx, system%ny, bytes, step%mask, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'undeformed_gap', undeformed_gap, system%nx, system%ny, stat, errmsg)) return
    step%undeformed_gap = rcf_in(undeformed_gap)
    call check(rc_flow_closing_pressure(system, rcf_or_null(options), step, spec, answer), stat, errmsg)
  end subroutine

  logical function given(where, spec, gap, gap_error, whole, stat, errmsg) result(fits)
    character(*), intent(in) :: where
    type(rc_flow_spec), intent(in) :: spec
    real(c_double), intent(in), target, contiguous :: gap(:, :)
    real(c_double), intent(in), optional, target, contiguous :: gap_error(:, :)
    type(rc_flow_spec), intent(out) :: whole
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    whole = spec
    whole%nx = size(gap, 1)
    whole%ny = size(gap, 2)
    whole%gap = rcf_in(gap)
    whole%gap_error = rcf_in(gap_error)
    fits = rcf_shaped(where, 'gap_error', gap_error, whole%nx, whole%ny, stat, errmsg)
  end function

  subroutine check(status, stat, errmsg)
    integer(rc_status), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(status, stat, errmsg, rc_from_c(rc_flow_last_error()))
  end subroutine
end module
