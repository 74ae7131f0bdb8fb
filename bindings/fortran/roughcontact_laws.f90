! Contact laws: made or loaded once, then evaluated by number from any thread, as user routines need it that get no pointer.
module roughcontact_laws
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_options, only: rcf_or_null
  use roughcontact_strings
  implicit none
  private
  public :: rcf_law_create, rcf_law_save, rcf_law_destroy, rcf_law_open, rcf_law_at, rcf_law_gap_conductance, rcf_law_slip

  integer, parameter :: most = 64
  type(c_ptr), save :: laws(most) = c_null_ptr  ! those that rcf_law_open has given a number

  interface rcf_law_at
    module procedure law_at_point, law_at_points
  end interface

contains

  ! spec: p_lower and p_upper at least; its undeformed_gap is that of the argument. Positive stat: law is usable, see rc_law_create.
  subroutine rcf_law_create(law, system, undeformed_gap, spec, options, stat, errmsg)
    type(c_ptr), intent(out) :: law
    type(rc_system), intent(in) :: system
    real(c_double), intent(in), target, contiguous :: undeformed_gap(:, :)
    type(rc_law_spec), intent(in) :: spec
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_law_spec) :: wanted
    law = c_null_ptr
    if (.not. rcf_shaped('rcf_law_create', 'undeformed_gap', undeformed_gap, system%nx, system%ny, stat, errmsg)) return
    wanted = spec
    wanted%undeformed_gap%data = c_loc(undeformed_gap)
    call rcf_check(rc_law_create(system, rcf_or_null(options), wanted, law), stat, errmsg)
  end subroutine

  subroutine rcf_law_save(law, path, stat, errmsg)
    type(c_ptr), intent(in) :: law
    character(*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_law_save(law, rc_to_c(path)), stat, errmsg)
  end subroutine

  subroutine rcf_law_destroy(law)
    type(c_ptr), intent(inout) :: law
    call rc_law_destroy(law)
    law = c_null_ptr
  end subroutine

  ! The law of the file gets the number, 1 .. 64, for the whole process. Positive stat: the law is usable, and its tolerance is not
  ! proven, see rc_law_create; without stat the program stops. To be called where a deck is read, not while another thread
  ! evaluates.
  subroutine rcf_law_open(name, path, number, stat, errmsg)
    character(*), intent(in) :: name, path
    integer, intent(in) :: number
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: law
    integer(rc_status) :: status
    if (number < 1 .or. number > most) then
      call rcf_refuse(RC_ERR_ARGUMENT, 'rcf_law_open: laws have numbers 1 .. 64', stat, errmsg)
      return
    end if
    law = c_null_ptr
    status = rc_law_open(rc_to_c(name), rc_to_c(path), law)
    if (c_associated(law)) laws(number) = law
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Pressure, slope and energy per area at an overclosure. stat: 0, 106 beyond the last node, -1: NaN or no such law.
  subroutine law_at_point(number, x, p, slope, energy, stat)
    integer, intent(in) :: number
    real(c_double), intent(in) :: x
    real(c_double), intent(inout) :: p, slope, energy
    integer, intent(out) :: stat
    stat = RC_ERR_ARGUMENT
    if (number >= 1 .and. number <= most) stat = rc_law_pressure(laws(number), x, p, slope, energy)
  end subroutine

  ! The same at a vector of points, such as the Gauss points of an element. stat: 106 if any is beyond the last node, -1 also if the
  ! vectors have different lengths.
  subroutine law_at_points(number, x, p, slope, energy, stat)
    integer, intent(in) :: number
    real(c_double), intent(in), target, contiguous :: x(:)
    real(c_double), intent(inout), target, contiguous :: p(:), slope(:), energy(:)
    integer, intent(out) :: stat
    stat = RC_ERR_ARGUMENT
    if (number < 1 .or. number > most) return
    if (.not. c_associated(laws(number))) return
    if (size(p) /= size(x) .or. size(slope) /= size(x) .or. size(energy) /= size(x)) return
    stat = RC_OK
    if (size(x) == 0) return
    stat = rc_law_pressures(laws(number), size(x, kind=c_int64_t), rc_const_array(data=c_loc(x)), rc_array(data=c_loc(p)), &
      rc_array(data=c_loc(slope)), rc_array(data=c_loc(energy)))
  end subroutine

  ! Conductance per area at a pressure. stat as in rcf_law_at.
  subroutine rcf_law_gap_conductance(number, p, rho1, rho2, conductance, stat)
    integer, intent(in) :: number
    real(c_double), intent(in) :: p, rho1, rho2
    real(c_double), intent(inout) :: conductance
    integer, intent(out) :: stat
    stat = RC_ERR_ARGUMENT
    if (number >= 1 .and. number <= most) stat = rc_law_gap_conductance(laws(number), p, rho1, rho2, conductance)
  end subroutine

  ! A step of a patch that slips, see rc_law_slip. state: rc_law_slip_state(mu=..., nu=...) before the first step. stat as in
  ! rcf_law_at, also RC_ERR_ARGUMENT for bad numbers, RC_ERR_INCOMPATIBLE for a law from which no slip follows.
  subroutine rcf_law_slip(number, state, x, slip, stat)
    integer, intent(in) :: number
    type(rc_law_slip_state), intent(inout) :: state
    real(c_double), intent(in) :: x, slip(2)
    integer, intent(out) :: stat
    type(rc_law_slip_state) :: after
    stat = RC_ERR_ARGUMENT
    if (number < 1 .or. number > most) return
    stat = rc_law_slip(laws(number), state, x, slip, after)
    if (stat >= 0) state = after
  end subroutine
end module
