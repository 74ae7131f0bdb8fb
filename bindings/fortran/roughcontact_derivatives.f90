! Derivatives of the last step of a contact, which must be certified; the conductance is in roughcontact_analysis.
module roughcontact_derivatives
  use roughcontact_arrays
  use roughcontact_contacts
  use roughcontact_errors
  use roughcontact_functions
  implicit none
  private
  public :: rcf_contact_gradient, rcf_contact_tangent

contains

  ! How a number J changes with the data of the step, from how it changes with the answer. dJ_dp, dJ_dgap, dJ_dload and
  ! dJ_dapproach absent: 0; all absent: J is the load of a step with a given approach, the approach of one with a given load.
  ! gradient has the derivatives by target and modulus, and what the call took.
  subroutine rcf_contact_gradient(contact, dJ_dundeformed_gap, dJ_dp, dJ_dgap, dJ_dload, dJ_dapproach, gradient, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    real(c_double), intent(inout), optional, target, contiguous :: dJ_dundeformed_gap(:, :)
    real(c_double), intent(in), optional, target, contiguous :: dJ_dp(:, :), dJ_dgap(:, :)
    real(c_double), intent(in), optional :: dJ_dload, dJ_dapproach
    type(rc_gradient), intent(out), optional :: gradient
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(*), parameter :: where = 'rcf_contact_gradient'
    type(rc_gradient) :: found
    integer(rc_status) :: status
    if (.not. rcf_shaped(where, 'dJ_dundeformed_gap', dJ_dundeformed_gap, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'dJ_dp', dJ_dp, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'dJ_dgap', dJ_dgap, contact%nx, contact%ny, stat, errmsg)) return
    found%dJ_dundeformed_gap = rcf_out(dJ_dundeformed_gap)
    found%dJ_dp = rcf_in(dJ_dp)
    found%dJ_dgap = rcf_in(dJ_dgap)
    if (present(dJ_dload)) found%dJ_dload = dJ_dload
    if (present(dJ_dapproach)) found%dJ_dapproach = dJ_dapproach
    status = rc_contact_gradient(contact%handle, found)
    if (present(gradient)) gradient = found
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! How the answer of the step changes with given changes of its data; absent: 0. tangent has the changes of load and approach.
  subroutine rcf_contact_tangent(contact, dundeformed_gap, dtarget, dmodulus, dp, dgap, tangent, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    real(c_double), intent(in), optional, target, contiguous :: dundeformed_gap(:, :)
    real(c_double), intent(in), optional :: dtarget, dmodulus
    real(c_double), intent(inout), optional, target, contiguous :: dp(:, :), dgap(:, :)
    type(rc_tangent), intent(out), optional :: tangent
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(*), parameter :: where = 'rcf_contact_tangent'
    type(rc_tangent) :: found
    integer(rc_status) :: status
    if (.not. rcf_shaped(where, 'dundeformed_gap', dundeformed_gap, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'dp', dp, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'dgap', dgap, contact%nx, contact%ny, stat, errmsg)) return
    found%dundeformed_gap = rcf_in(dundeformed_gap)
    found%dp = rcf_out(dp)
    found%dgap = rcf_out(dgap)
    if (present(dtarget)) found%dtarget = dtarget
    if (present(dmodulus)) found%dmodulus = dmodulus
    status = rc_contact_tangent(contact%handle, found)
    if (present(tangent)) tangent = found
    call rcf_check(status, stat, errmsg)
  end subroutine
end module
