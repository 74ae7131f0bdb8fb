! Direct routines: one call, plain arrays. Minimise 1/2 p'Hp - u'p over p >= 0 for a symmetric positive definite matrix H, by the
! methods of Bemporad & Paggi (2015). p: start in, solution out; w: Hp - u. tol is 1e-8 and max_iter 10000 if absent.
module roughcontact_direct
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_strings
  implicit none
  private
  public :: rcf_greedy, rcf_polonsky_keer, rcf_nnls, rcf_gp, rcf_admm, rcf_cmr

  abstract interface
    function matrix_routine(n, H, ld, u, p, w, tol, max_iter, result) bind(c) result(status)
      import c_int64_t, c_double, rc_direct, rc_status
      integer(c_int64_t), value :: n, ld, max_iter
      real(c_double), intent(in) :: H(ld, *), u(*)
      real(c_double), intent(inout) :: p(*)
      real(c_double), intent(inout), optional :: w(*)
      real(c_double), value :: tol
      type(rc_direct), intent(inout), optional :: result
      integer(rc_status) :: status
    end function
  end interface

contains

  ! Greedy active set (Algorithm 1).
  subroutine rcf_greedy(H, u, p, w, tol, max_iter, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: H(:, :)
    real(c_double), intent(in), contiguous :: u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call solve_matrix(rc_greedy, 'rcf_greedy', H, u, p, w, tol, max_iter, result, stat, errmsg)
  end subroutine

  ! Constrained conjugate gradients (Algorithm 2).
  subroutine rcf_polonsky_keer(H, u, p, w, tol, max_iter, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: H(:, :)
    real(c_double), intent(in), contiguous :: u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call solve_matrix(rc_polonsky_keer, 'rcf_polonsky_keer', H, u, p, w, tol, max_iter, result, stat, errmsg)
  end subroutine

  ! Non-negative least squares, finite and exact (Algorithm 3).
  subroutine rcf_nnls(H, u, p, w, tol, max_iter, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: H(:, :)
    real(c_double), intent(in), contiguous :: u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call solve_matrix(rc_nnls, 'rcf_nnls', H, u, p, w, tol, max_iter, result, stat, errmsg)
  end subroutine

  ! Accelerated gradient projection (Algorithm 4).
  subroutine rcf_gp(H, u, p, w, tol, max_iter, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: H(:, :)
    real(c_double), intent(in), contiguous :: u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call solve_matrix(rc_gp, 'rcf_gp', H, u, p, w, tol, max_iter, result, stat, errmsg)
  end subroutine

  ! Alternating direction method of multipliers (Algorithm 5).
  subroutine rcf_admm(H, u, p, w, tol, max_iter, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: H(:, :)
    real(c_double), intent(in), contiguous :: u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call solve_matrix(rc_admm, 'rcf_admm', H, u, p, w, tol, max_iter, result, stat, errmsg)
  end subroutine

  ! Cascade multi-resolution (Algorithm 6) on a height map, free boundaries. displacement: compression below the highest point;
  ! levels: grids of the cascade, the given one included; radius: of influence, in coarse cells, >= 1.
  subroutine rcf_cmr(heights, hx, hy, modulus, displacement, levels, p, radius, inner, result, stat, errmsg)
    real(c_double), intent(in), contiguous :: heights(:, :)
    real(c_double), intent(in) :: hx, hy, modulus, displacement
    integer, intent(in) :: levels
    real(c_double), intent(inout), contiguous :: p(:, :)
    real(c_double), intent(in), optional :: radius
    character(*), intent(in), optional :: inner
    type(rc_direct), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_direct) :: answer
    integer(c_int64_t) :: nx, ny
    integer(rc_status) :: status
    real(c_double) :: h
    if (any(shape(p) /= shape(heights))) then
      call rcf_refuse(RC_ERR_SHAPE, 'rcf_cmr: heights and p have different shapes', stat, errmsg)
      return
    end if
    nx = size(heights, 1, c_int64_t)
    ny = size(heights, 2, c_int64_t)
    h = 1.5_c_double
    if (present(radius)) h = radius
    if (present(inner)) then
      status = rc_cmr(nx, ny, hx, hy, modulus, heights, displacement, int(levels, c_int64_t), h, rc_to_c(inner), p, answer)
    else
      status = rc_cmr(nx, ny, hx, hy, modulus, heights, displacement, int(levels, c_int64_t), h, p=p, result=answer)
    end if
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine

  subroutine solve_matrix(routine, where, H, u, p, w, tol, max_iter, result, stat, errmsg)
    procedure(matrix_routine) :: routine
    character(*), intent(in) :: where
    real(c_double), intent(in), contiguous :: H(:, :)
    real(c_double), intent(in), contiguous :: u(:)
    real(c_double), intent(inout), contiguous :: p(:)
    real(c_double), intent(inout), optional, contiguous :: w(:)
    real(c_double), intent(in), optional :: tol
    integer, intent(in), optional :: max_iter
    type(rc_direct), intent(inout), optional :: result
    integer, intent(inout), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_direct) :: answer
    real(c_double) :: limit
    integer(c_int64_t) :: most
    integer(rc_status) :: status
    integer :: n
    logical :: fits
    n = size(u)
    fits = size(H, 1) == n .and. size(H, 2) == n .and. size(p) == n
    if (present(w)) fits = fits .and. size(w) == n
    if (.not. fits) then
      call rcf_refuse(RC_ERR_SHAPE, where//': give H(n, n), u(n), p(n) and w(n)', stat, errmsg)
      return
    end if
    limit = 1e-8_c_double
    if (present(tol)) limit = tol
    most = 10000
    if (present(max_iter)) most = max_iter
    status = routine(int(n, c_int64_t), H, int(n, c_int64_t), u, p, w, limit, most, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine
end module
