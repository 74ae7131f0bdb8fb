! The direct routines as a Fortran code calls them.
function matrix_from_fortran(which, n, H, ld, u, p, w, tol, max_iter, result) bind(c) result(status)
  use roughcontact
  implicit none
  integer(c_int32_t), value :: which
  integer(c_int64_t), value :: n, ld, max_iter
  real(c_double), intent(in) :: H(ld, n), u(n)
  real(c_double), intent(inout) :: p(n)
  real(c_double), intent(inout), optional :: w(n)
  real(c_double), value :: tol
  type(rc_direct), intent(inout), optional :: result
  integer(rc_status) :: status

  select case (which)
  case (0)
    status = rc_greedy(n, H, ld, u, p, w, tol, max_iter, result)
  case (1)
    status = rc_polonsky_keer(n, H, ld, u, p, w, tol, max_iter, result)
  case (2)
    status = rc_nnls(n, H, ld, u, p, w, tol, max_iter, result)
  case (3)
    status = rc_gp(n, H, ld, u, p, w, tol, max_iter, result)
  case default
    status = rc_admm(n, H, ld, u, p, w, tol, max_iter, result)
  end select
end function

function cascade_from_fortran(nx, ny, hx, hy, modulus, heights, delta, levels, h, inner, p, result) bind(c) result(status)
  use roughcontact
  implicit none
  integer(c_int64_t), value :: nx, ny, levels
  real(c_double), value :: hx, hy, modulus, delta, h
  real(c_double), intent(in) :: heights(nx, ny)
  type(c_ptr), value :: inner
  real(c_double), intent(inout) :: p(nx, ny)
  type(rc_direct), intent(inout) :: result
  integer(rc_status) :: status

  if (rc_from_c(inner) == 'auto') then  ! the optional argument left out
    status = rc_cmr(nx, ny, hx, hy, modulus, heights, delta, levels, h, p=p, result=result)
  else
    status = rc_cmr(nx, ny, hx, hy, modulus, heights, delta, levels, h, rc_to_c(rc_from_c(inner)), p, result)
  end if
end function
