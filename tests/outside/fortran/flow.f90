! Flow through gaps in the manner of Fortran.
program flow
  use roughcontact
  use roughcontact_flow
  use checks
  implicit none
  character(300) :: message
  integer :: stat
  type(rc_flow_spec) :: spec

  spec = rc_flow_spec(sides=RC_FLOW_CLOSED, viscosity=1d0 / 12, pressure_drop=1d0, hx=2d0, hy=1d0, width=1d-9)
  call given_gaps()
  call contacts()
  call finish()

contains

  subroutine given_gaps()
    real(c_double) :: gap(4, 5), potential(4, 5), error(4, 5)
    type(rc_flow_result) :: answer
    type(rc_flow_factors) :: factors
    integer :: i
    do i = 1, 4
      gap(i, :) = 0.25d0 * i
    end do
    call rcf_flow_solve(spec, gap, answer, potential=potential)
    call check('strips in series', abs(answer%flow * 2 * sum(1 / gap(:, 1)**3) / 5 - 1) < 1e-9 .and. answer%crosses == 1)
    call check('its interval', answer%lower <= answer%flow .and. answer%flow <= answer%upper .and. answer%constriction_x == 0)
    call check('the pressure falls along the first index', all(potential(2:, :) < potential(:3, :)))
    call rcf_flow_factors_find(spec, gap, factors)
    call check('factors', abs(factors%yy * 4 / sum(gap(:, 1)**3) - 1) < 1e-9 .and. abs(factors%mean_gap - 0.625) < 1e-12)
    error = 0.1d0
    call rcf_flow_solve(spec, gap, answer, gap_error=error, stat=stat, errmsg=message)
    call check('a wide interval', stat == RC_STOP_STALLED .and. index(message, 'wider') > 0 .and. answer%upper > 1.5 * answer%lower)
    call rcf_flow_solve(spec, gap, answer, gap_error=error(:2, :), stat=stat, errmsg=message)
    call check('another shape', stat == RC_ERR_SHAPE .and. index(message, 'gap_error has 2 by 5') > 0)
  end subroutine

  subroutine contacts()
    integer, parameter :: nx = 40, ny = 32
    real(c_double) :: z(nx, ny), p(nx, ny), gap(nx, ny)
    type(rc_system) :: system
    type(rc_result) :: result
    type(rc_flow_spec) :: along_y
    type(rc_flow_result) :: open
    type(rc_flow_closing) :: closing
    logical :: mask(nx, ny)
    z = rough(nx, ny)
    system = rc_system(boundary=RC_BOUNDARY_PERIODIC, nx=nx, ny=ny, hx=1d0, hy=1d0, modulus=3d0)
    along_y = rc_flow_spec(along=RC_FLOW_Y, viscosity=1d0, pressure_drop=1d0)
    call rcf_flow_closing_pressure(along_y, system, rcf_gap_from_heights(z), closing)
    call check('a seal closes', closing%lower > 0 .and. closing%upper < 1.02 * closing%lower)
    call rcf_solve(system, rcf_gap_from_heights(z), load=0.9d0 * closing%lower * nx * ny, p=p, gap=gap, result=result)
    call rcf_flow_of_result(along_y, system, result, p, gap, open, stat=stat)
    call check('open below', stat >= 0 .and. open%lower > 0)
    mask = .true.
    mask(:, 9) = .false.
    call rcf_flow_closing_pressure(along_y, system, rcf_gap_from_heights(z), closing, mask=mask)
    call check('a wall closes without a load', closing%upper <= 0)
    call rcf_flow_of_result(along_y, system, result, p(:, :3), gap, open, stat=stat, errmsg=message)
    call check('pressures of another shape', stat == RC_ERR_SHAPE .and. index(message, 'p has') > 0)
  end subroutine
end program
