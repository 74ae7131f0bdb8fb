! The caller's own influence matrix, as numbers and as a product: a row of springs coupled through an elastic layer, into which a
! parabolic punch is pressed. The matrix for direct solvers; the product where the matrix is too large or never formed.
module layer
  use roughcontact
  implicit none
  real(c_double), parameter :: reach = 3

contains

  real(c_double) elemental function influence(i, j)
    integer, intent(in) :: i, j
    influence = exp(-abs(i - j) / reach)
  end function

  ! y = H x in 2 n operations: exp(-|i - j| / reach) is a sum over those before and one over those behind. The library calls it
  ! with all points in order; user is not needed here.
  integer(c_int32_t) function layer_product(x, y, n, user) bind(c) result(failed)
    integer(c_int64_t), value :: n
    real(c_double), intent(in) :: x(n)
    real(c_double), intent(out) :: y(n)
    type(c_ptr), value :: user
    real(c_double) :: before, behind, decay
    integer(c_int64_t) :: i
    decay = exp(-1 / reach)
    before = 0
    do i = 1, n
      before = decay * before + x(i)
      y(i) = before
    end do
    behind = 0
    do i = n, 1, -1
      y(i) = y(i) + behind
      behind = decay * (behind + x(i))
    end do
    failed = merge(1, 0, c_associated(user))
  end function
end module

program own_matrix
  use layer
  implicit none
  integer, parameter :: n = 41
  real(c_double), target :: H(n, n)
  real(c_double) :: gap(n, 1), p(n, 1), p_product(n, 1), w(n)
  type(rc_result) :: with_matrix, with_product
  integer :: i, j

  H = reshape([((influence(i, j), i=1, n), j=1, n)], [n, n])
  gap(:, 1) = [(0.5_c_double * ((i - 21) / 10.0_c_double)**2, i=1, n)]

  call rcf_solve(rc_system(op=RC_OPERATOR_DENSE, hx=1.0_c_double, hy=1.0_c_double, dense=c_loc(H), dense_ld=n), gap, &
    load=2.0_c_double, p=p, result=with_matrix)
  print '(a, f9.6, a, f9.6, a, i0, a)', 'matrix:  load', with_matrix%load, ' at approach', with_matrix%approach, ', ', &
    with_matrix%contacts, ' points in contact'

  call rcf_solve(rc_system(op=RC_OPERATOR_CALLBACK, hx=1.0_c_double, hy=1.0_c_double, apply=c_funloc(layer_product)), gap, &
    load=2.0_c_double, p=p_product, result=with_product)
  print '(a, f9.6, a, f9.6, a, i0, a)', 'product: load', with_product%load, ' at approach', with_product%approach, ', ', &
    with_product%contacts, ' points in contact'
  if (maxval(abs(p_product - p)) > 1e-6_c_double * maxval(p)) error stop 'the two differ'

  ! The same without objects: minimise 1/2 p'Hp - u'p over p >= 0.
  p = 0
  call rcf_direct(rc_nnls, H, with_matrix%approach - gap(:, 1), p(:, 1), w)
  print '(a, f9.6)', 'nnls:    load', sum(p)
end program
