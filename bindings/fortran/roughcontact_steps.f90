! The input of a step, as the library takes it.
module roughcontact_steps
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions
  implicit none
  private
  public :: rcf_prepared

contains

  ! Step and result of the arguments that the solving procedures share; false where the arguments are refused.
  logical function rcf_prepared(where, nx, ny, step, answer, bytes, approach, load, undeformed_gap, mask, p0, warm_start, p, &
    gap, stat, errmsg) result(ready)
    character(*), intent(in) :: where
    integer(c_int64_t), intent(in) :: nx, ny
    type(rc_step), intent(out) :: step
    type(rc_result), intent(out) :: answer
    integer(c_int8_t), allocatable, intent(out), target :: bytes(:, :)
    real(c_double), intent(in), optional :: approach, load
    real(c_double), intent(in), optional, target, contiguous :: undeformed_gap(:, :), p0(:, :)
    logical, intent(in), optional :: mask(:, :), warm_start
    real(c_double), intent(inout), optional, target, contiguous :: p(:, :), gap(:, :)
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    ready = .false.
    if (present(approach) .eqv. present(load)) then
      call rcf_refuse(RC_ERR_ARGUMENT, where//': give one of approach and load', stat, errmsg)
      return
    end if
    if (.not. rcf_shaped(where, 'undeformed_gap', undeformed_gap, nx, ny, stat, errmsg)) return
    if (.not. rcf_masked(where, mask, nx, ny, bytes, step%mask, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'p0', p0, nx, ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'p', p, nx, ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'gap', gap, nx, ny, stat, errmsg)) return
    step%control = merge(RC_CONTROL_LOAD, RC_CONTROL_APPROACH, present(load))
    if (present(approach)) step%target = approach
    if (present(load)) step%target = load
    if (present(warm_start)) step%warm_start = merge(1, 0, warm_start)
    step%undeformed_gap = rcf_in(undeformed_gap)
    step%p0 = rcf_in(p0)
    answer%p = rcf_out(p)
    answer%gap = rcf_out(gap)
    ready = .true.
  end function
end module
