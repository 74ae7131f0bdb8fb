! Direct routines: one call, plain arrays. Minimise 1/2 p'Hp - u'p over p >= 0 for a symmetric positive definite matrix H, by the
! methods of Bemporad & Paggi (2015). Tolerances, limits and radii that are absent are those of the options.
module roughcontact_direct
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_options, only: rcf_option_default
  use roughcontact_strings
  implicit none
  private
  public :: rcf_direct, rcf_cmr

contains

  ! routine: rc_greedy, rc_polonsky_keer, rc_nnls, rc_gp or rc_admm. H(n, n); p(n): start in, solution out; w(n): Hp - u.
  subroutine rcf_direct(routine, H, u, p, w, tol, max_iter, result, stat, errmsg)
    procedure(rc_greedy) :: routine
    real(c_double), intent(in), contiguous :: H(:, :), u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_direct) :: answer
    integer(c_int64_t) :: n, most
    integer(rc_status) :: status
    logical :: fits
    n = size(u, kind=c_int64_t)
    fits = size(H, 1) == n .and. size(H, 2) == n .and. size(p) == n
    if (present(w)) fits = fits .and. size(w) == n
    if (.not. fits) then
      call rcf_refuse(RC_ERR_SHAPE, 'rcf_direct: give H(n, n), u(n), p(n) and w(n)', stat, errmsg)
      return
    end if
    if (present(max_iter)) then
      most = max_iter
    else
      most = int(rcf_option_default(RC_OPT_MAX_ITER), c_int64_t)
    end if
    status = routine(n, H, n, u, p, w, rcf_option_default(RC_OPT_TOL, tol), most, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Cascade multi-resolution (Algorithm 6) on a height map, free boundaries. approach: from the highest point;
  ! levels: grids of the cascade, the given one included; radius: of influence, in coarse cells, >= 1.
  subroutine rcf_cmr(heights, hx, hy, modulus, approach, levels, p, radius, inner, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: heights(:, :)
    real(c_double), intent(in) :: hx, hy, modulus, approach
    integer, intent(in) :: levels
    real(c_double), intent(inout), contiguous :: p(:, :)
    real(c_double), intent(in), optional :: radius
    character(*), intent(in), optional :: inner
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_direct) :: answer
    character(:, kind=c_char), allocatable :: name
    integer(rc_status) :: status
    if (any(shape(p) /= shape(heights))) then
      call rcf_refuse(RC_ERR_SHAPE, 'rcf_cmr: heights and p have different shapes', stat, errmsg)
      return
    end if
    if (present(inner)) name = rc_to_c(inner)
    status = rc_cmr(size(heights, 1, c_int64_t), size(heights, 2, c_int64_t), hx, hy, modulus, heights, approach, &
      int(levels, c_int64_t), rcf_option_default('cmr.radius', radius), name, p, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine
end module
