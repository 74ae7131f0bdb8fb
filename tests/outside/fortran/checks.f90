! What the tests share: counting checks, a rough gap.
module checks
  use, intrinsic :: iso_c_binding, only: c_double
  implicit none
  integer :: failures = 0

contains

  subroutine check(name, holds)
    character(*), intent(in) :: name
    logical, intent(in) :: holds
    if (holds) return
    failures = failures + 1
    print '(2a)', 'FAILED: ', name
  end subroutine

  subroutine finish()
    if (failures > 0) error stop 1
    print '(a)', 'all checks hold'
  end subroutine

  function rough(nx, ny) result(z)
    integer, intent(in) :: nx, ny
    real(c_double) :: z(nx, ny)
    integer :: i, j
    do j = 1, ny
      do i = 1, nx
        z(i, j) = cos(0.9_c_double * i) * cos(0.5_c_double * j) + cos(0.21_c_double * i + 0.17_c_double * j)
      end do
    end do
  end function
end module
