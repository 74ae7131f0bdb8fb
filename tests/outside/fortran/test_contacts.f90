! Contacts, histories and batches: the rcf_ procedures give the bits of the rc_ functions, and check shapes.
module callbacks
  use roughcontact
  implicit none
contains
  integer(c_int32_t) function second_is_enough(step, result, user) bind(c) result(stop_now)
    integer(c_int64_t), value :: step
    type(rc_result), intent(in) :: result
    type(c_ptr), value :: user
    integer, pointer :: seen
    call c_f_pointer(user, seen)
    seen = seen + 1
    stop_now = merge(1, 0, step == 1 .and. result%load > 0)
  end function

  integer(c_int32_t) function half_is_enough(ended, user) bind(c) result(stop_now)
    integer(c_int64_t), value :: ended
    type(c_ptr), value :: user
    integer, pointer :: seen
    call c_f_pointer(user, seen)
    seen = int(ended)
    stop_now = merge(1, 0, ended == 3)
  end function
end module

program test_contacts
  use callbacks
  use checks
  implicit none
  integer, parameter :: nx = 24, ny = 18, n = nx * ny
  real(c_double), target :: z(nx, ny), gap(nx, ny), p(nx, ny), expected(nx, ny), deformed(nx, ny)
  type(rc_system) :: system
  character(300) :: message
  integer :: stat

  z = rough(nx, ny)
  gap = rcf_gap_from_heights(z)
  call check('the gap of the highest point is 0', minval(gap) == 0 .and. all(gap == maxval(z) - z))
  system = rc_system(boundary=RC_BOUNDARY_FREE, nx=nx, ny=ny, hx=0.5_c_double, hy=0.25_c_double, modulus=3.0_c_double)
  call one_shot()
  call many_steps()
  call paths()
  call kept()
  call batches()
  call derivatives()
  call finish()

contains

  ! What goes in and comes out of derivatives: forward and reverse mode agree, shapes are checked.
  subroutine derivatives()
    type(rcf_contact) :: contact
    type(rc_result) :: result
    type(rc_gradient) :: gradient
    type(rc_tangent) :: tangent
    type(c_ptr) :: options, copy
    real(c_double) :: level, by_gap(nx, ny), dp(nx, ny), conductance, lower, upper, punch
    call rcf_options_create(options)
    call rcf_options_set(options, 'tol', 1e-12_c_double)
    call rcf_options_set(options, 'stiffness', 2)
    call rcf_contact_create(contact, system, options)
    call rcf_contact_solve(contact, approach=0.4_c_double, undeformed_gap=gap, p=p, result=result)
    call rcf_contact_gradient(contact, by_gap, gradient=gradient)
    call rcf_contact_tangent(contact, dundeformed_gap=z, dtarget=0.3_c_double, dmodulus=0.1_c_double, dp=dp, tangent=tangent)
    call check('forward and reverse mode agree', abs(tangent%dload - sum(by_gap * z) - 0.3_c_double * gradient%dJ_dtarget - &
      0.1_c_double * gradient%dJ_dmodulus) < 1e-8 * gradient%dJ_dtarget)
    call rcf_contact_gradient(contact, by_gap(1:2, :), stat=stat, errmsg=message)
    call check('shape of the gradient', stat == RC_ERR_SHAPE .and. index(message, 'dJ_dundeformed_gap') > 0)
    call rcf_contact_tangent(contact, dp=dp(1:2, :), stat=stat, errmsg=message)
    call check('shape of the tangent', stat == RC_ERR_SHAPE .and. index(message, 'dp') > 0)
    call rcf_conductance(system, result, 1.0_c_double, 3.0_c_double, conductance, lower, upper)
    call check('the conductance is in its interval', lower <= conductance * 1.000001_c_double .and. &
      conductance <= upper * 1.000001_c_double .and. abs(conductance - result%stiffness / 6) < 1e-12 * conductance)
    call rcf_options_copy(options, copy)
    call rcf_options_set(options, 'stiffness', 0)
    call rcf_options_get(copy, 'stiffness', level)
    call check('a copy of options keeps its values', level == 2.0_c_double)
    call rcf_punch_stiffness(system, punch, p > 0, lower, upper, copy)
    call check('a punch on the contact set', abs(punch / result%stiffness - 1) < 1e-8 .and. lower <= punch .and. punch <= upper)
    call rcf_punch_stiffness(system, punch, p(1:2, :) > 0, stat=stat)
    call check('shape of the punch', stat == RC_ERR_SHAPE)
    call rcf_options_destroy(copy)
    call rcf_contact_destroy(contact)
    call rcf_options_destroy(options)
  end subroutine

  subroutine one_shot()
    type(rc_result) :: ours, theirs
    type(rc_step) :: step
    real(c_double) :: larger(2 * nx, ny + 3)
    step = rc_step(control=RC_CONTROL_APPROACH, target=0.4_c_double, undeformed_gap=rc_const_array(c_loc(gap)))
    theirs%p%data = c_loc(expected)
    call check('rc_solve', rc_solve(system, step, c_null_ptr, theirs) == RC_OK)
    call rcf_solve(system, gap, approach=0.4_c_double, p=p, gap=deformed, result=ours, stat=stat)
    call check('rcf_solve is certified', stat == RC_OK .and. ours%status == RC_OK)
    call check('rcf_solve gives the bits of rc_solve', all(p == expected) .and. ours%load == theirs%load)
    call check('the deformed gap comes back', minval(deformed) > -1e-6 .and. maxval(deformed) > 0.1)
    larger = -1
    call rcf_solve(system, gap, approach=0.4_c_double, p=larger(1:2 * nx:2, 2:ny + 1))
    call check('a section of a larger array is filled', all(larger(1:2 * nx:2, 2:ny + 1) == expected))
    call check('and nothing else of it', all(larger(2:2 * nx:2, :) == -1) .and. all(larger(:, 1) == -1))
    call rcf_solve(system, gap, approach=0.4_c_double, mask=z < 1.9_c_double, p=p)
    call check('masked points carry no pressure', all(p == 0 .or. z < 1.9_c_double) .and. sum(p) > 0)

    message = 'untouched'
    call rcf_solve(system, gap, approach=0.4_c_double, stat=stat, errmsg=message)
    call check('errmsg is untouched without an error', message == 'untouched')
    call rcf_solve(system, gap, stat=stat, errmsg=message)
    call check('one of approach and load', stat == RC_ERR_ARGUMENT .and. index(message, 'approach and load') > 0)
    call rcf_solve(system, gap, approach=0.4_c_double, p=larger, stat=stat, errmsg=message)
    call check('p of another shape: '//trim(message), stat == RC_ERR_SHAPE .and. index(message, 'give 24 by 18') > 0)
    gap(3, 2) = -1 / (gap(3, 2) - gap(3, 2))
    call rcf_solve(system, gap, approach=0.4_c_double, stat=stat, errmsg=message)
    call check('the library''s message: '//trim(message), stat == RC_ERR_ARGUMENT .and. index(message, 'not finite') > 0)
    gap = rcf_gap_from_heights(z)
  end subroutine

  subroutine many_steps()
    type(rcf_contact) :: contact
    type(rc_result) :: result
    type(c_ptr) :: options
    integer(c_int64_t), allocatable :: points(:)
    real(c_double), allocatable :: values(:)
    real(c_double) :: tol
    character(:), allocatable :: text
    call rcf_options_create(options)
    call rcf_options_set(options, RC_OPT_SOLVER, 'nnls')
    call rcf_options_set(options, RC_OPT_STIFFNESS, 1)
    call rcf_options_set(options, RC_OPT_TOL, '1e-10')
    call rcf_options_get(options, RC_OPT_TOL, tol)
    call rcf_options_get(options, RC_OPT_SOLVER, text)
    call check('options come back', tol == 1e-10_c_double .and. text == 'nnls')
    call rcf_options_set(options, 'tolerance', 1.0_c_double, stat, message)
    call check('unknown option: '//trim(message), stat == RC_ERR_OPTION .and. index(message, 'tol') > 0)

    call rcf_contact_create(contact, rc_system(boundary=RC_BOUNDARY_FREE, nx=nx, ny=ny, hx=-1.0_c_double), stat=stat)
    call rcf_contact_points(contact, points, values, stat)
    call check('a contact that was not made has no points', stat == RC_ERR_ARGUMENT .and. size(points) == 0)
    call rcf_contact_create(contact, system, options, stat)
    call check('a contact', stat == RC_OK .and. contact%nx == nx)
    call rcf_contact_solve(contact, approach=0.3_c_double, undeformed_gap=gap, result=result)
    call rcf_contact_solve(contact, approach=0.4_c_double, p=p, result=result)
    call check('solver by name', rc_from_c(result%solver) == 'nnls' .and. result%stiffness > 0)
    call rcf_contact_points(contact, points, values)
    call check('the contact set', size(points) == result%contacts .and. &
      all(pack(reshape(p, [n]), reshape(p, [n]) > 0) == values))
    call rcf_contact_explain(contact, text)
    call check('the choice: '//text, index(text, 'nnls on ') > 0 .and. index(text, ', taken') > 0)
    call rcf_contact_certify(contact, p, approach=0.4_c_double, stat=stat)
    call check('pressures are certified', stat == RC_OK)
    call rcf_options_set(options, RC_OPT_SOLVER, 'cmr')
    call rcf_contact_set_options(contact, options)
    call rcf_contact_reset(contact)
    call rcf_contact_solve(contact, approach=0.4_c_double, stat=stat)
    call check('a reset contact has no gap', stat == RC_ERR_ARGUMENT)
    call rcf_contact_solve(contact, approach=0.4_c_double, undeformed_gap=gap, result=result)
    call coarse_solutions(contact, int(result%levels))
    call rcf_contact_cancel(contact)
    call rcf_contact_solve(contact, approach=0.4_c_double, warm_start=.false., stat=stat)
    call check('cancelled', stat == RC_STOP_CANCELLED)
    call rcf_contact_destroy(contact)
    call rcf_options_destroy(options)
    call check('destroyed', .not. c_associated(contact%handle) .and. .not. c_associated(options))
  end subroutine

  subroutine coarse_solutions(contact, levels)
    type(rcf_contact), intent(in) :: contact
    integer, intent(in) :: levels
    type(rc_level) :: level
    real(c_double), allocatable :: coarse(:, :)
    integer :: k
    do k = 1, levels
      call rcf_contact_level(contact, k, level, coarse)
      call check('a coarse solution', all(shape(coarse) == [level%nx, level%ny]) .and. count(coarse > 0) == level%contacts)
    end do
    call rcf_contact_level(contact, levels + 1, level, stat=stat)
    call check('there is no level after the last', stat == RC_ERR_ARGUMENT)
  end subroutine

  subroutine paths()
    type(rcf_contact) :: contact
    real(c_double) :: approaches(4), load(4), area(4), certificate(4)
    real(c_double), dimension(4) :: mean_gap, energy, lower, upper, stiffness, less, more
    integer(c_int64_t) :: products(4)
    integer :: completed
    integer, target :: seen
    type(c_funptr) :: fn
    approaches = [0.1_c_double, 0.3_c_double, 0.2_c_double, 0.4_c_double]
    call rcf_contact_create(contact, system)
    call rcf_contact_solve_history(contact, approaches, undeformed_gap=gap, load=load, contact_area=area, certificate=certificate, &
      products=products, completed=completed)
    call check('a history', completed == 4 .and. load(2) > load(3) .and. all(certificate < 1e-8) .and. all(products > 0))
    call rcf_contact_solve_history(contact, approaches, load=load, mean_gap=mean_gap, energy=energy, load_lower=lower, &
      load_upper=upper, stiffness=stiffness, stiffness_lower=less, stiffness_upper=more, virgin=.true.)
    call check('intervals of a history', all(lower <= load .and. load <= upper .and. less <= stiffness .and. stiffness <= more))
    call check('mean gap and energy of a history', mean_gap(2) < mean_gap(3) .and. energy(2) < energy(3))
    seen = 0
    fn = c_funloc(second_is_enough)
    call rcf_contact_solve_history(contact, loads=load, fn=fn, user=c_loc(seen), completed=completed, stat=stat)
    call check('ended by the callback', stat == RC_STOP_CANCELLED .and. completed == 2 .and. seen == 2)
    call rcf_contact_solve_history(contact, approaches, load=load(1:3), stat=stat)
    call check('an output that is too short', stat == RC_ERR_SHAPE)
    call rcf_contact_destroy(contact)
  end subroutine

  ! What a contact of bodies that yield and creep keeps goes out, and into a contact that goes on with the same bits.
  subroutine kept()
    integer, parameter :: steps = 4
    real(c_double), parameter :: targets(steps) = 0.01_c_double * [20, 35, 36, 37], times(steps) = [1, 2, 20, 30]
    real(c_double), target :: ratio(2) = [0.5_c_double, 1.0_c_double], tau(2) = [1.0_c_double, 10.0_c_double]
    type(rcf_contact) :: contact
    type(rc_system) :: rubber
    type(c_ptr) :: options
    type(rc_result) :: results(steps), again
    real(c_double) :: pressures(nx, ny, steps), time, load(steps), batched(steps, 1)
    real(c_double), allocatable :: left(:, :, :), dents(:, :), same(:, :, :), same_dents(:, :)
    integer :: k
    rubber = system
    rubber%hardness = 0.4 * maxval(expected)
    rubber%creep_terms = 2
    rubber%creep_ratio%data = c_loc(ratio)
    rubber%creep_time%data = c_loc(tau)
    call rcf_options_create(options)
    call rcf_options_set(options, RC_OPT_RESUMABLE, 1)
    call rcf_contact_create(contact, rubber, options)
    do k = 1, steps
      if (k == steps) then
        call rcf_contact_creep(contact, left, time)
        call rcf_contact_indentation(contact, dents)
      end if
      call rcf_contact_solve(contact, approach=targets(k), time=times(k), undeformed_gap=gap, p=pressures(:, :, k), &
        result=results(k))
    end do
    call check('the memory', time == times(3) .and. all(shape(left) == [nx, ny, 3]) .and. maxval(left(:, :, 2)) > 0)
    call check('at the hardness', maxval(dents) > 0 .and. maxval(pressures(:, :, 2)) == rubber%hardness .and. &
      results(2)%capped == count(pressures(:, :, 2) == rubber%hardness))
    call rcf_contact_certify(contact, pressures(:, :, 4), approach=targets(4), time=times(4), stat=stat)
    call check('certified at its time', stat == RC_OK)
    call rcf_contact_reset(contact)
    call rcf_contact_restore(contact, gap, pressures(:, :, 3), results(3)%approach, results(3)%load, pressures(:, :, 2), &
      results(2)%approach, results(2)%load, indentation=dents, creep=left, time=time)
    call rcf_contact_creep(contact, same)
    call rcf_contact_indentation(contact, same_dents)
    call check('restored', all(same == left) .and. all(same_dents == dents))
    call rcf_contact_solve(contact, approach=targets(4), time=times(4), p=p, result=again)
    call check('the same bits after a cut', all(p == pressures(:, :, 4)) .and. again%load == results(4)%load .and. &
      again%products == results(4)%products)
    call rcf_contact_restore(contact, gap, p, 0.1_c_double, 1.0_c_double, p_before=p, creep=left, time=time, stat=stat, &
      errmsg=message)
    call check('all of the step before or nothing: '//trim(message), stat == RC_ERR_ARGUMENT .and. index(message, 'or none') > 0)
    call rcf_contact_restore(contact, gap, p(:nx - 1, :), 0.1_c_double, 1.0_c_double, creep=left, time=time, stat=stat)
    call check('pressures of another shape', stat == RC_ERR_SHAPE)
    call rcf_contact_restore(contact, gap, p, 0.1_c_double, 1.0_c_double, creep=left(:, :, :2), time=time, stat=stat)
    call check('a memory that is too short', stat == RC_ERR_SHAPE)
    call rcf_contact_reset(contact)
    call rcf_contact_solve_history(contact, approaches=targets, times=times, undeformed_gap=gap, load=load)
    call check('a history in time', all(abs(load / results%load - 1) < 1e-7))
    call rcf_contact_solve_history(contact, approaches=targets, times=times(:2), undeformed_gap=gap, stat=stat)
    call check('too few times', stat == RC_ERR_SHAPE)
    call rcf_contact_destroy(contact)
    call rcf_batch_solve(rubber, reshape(gap, [nx, ny, 1]), approaches=reshape(targets, [steps, 1]), &
      times=reshape(times, [steps, 1]), load=batched)
    call check('a batch in time', all(abs(batched(:, 1) / load - 1) < 1e-7))
    call rcf_options_destroy(options)
  end subroutine

  subroutine batches()
    real(c_double) :: gaps(nx, ny, 3), approaches(2, 1), load(2, 3), lower(2, 3), upper(2, 3), all_p(nx, ny, 3)
    integer(rc_status) :: statuses(2, 3)
    integer(c_int64_t) :: iterations(2, 3)
    integer :: k, certified, first
    integer, target :: seen
    type(c_funptr) :: progress
    do k = 1, 3
      gaps(:, :, k) = rcf_gap_from_heights(k * z)
    end do
    approaches(:, 1) = [0.2_c_double, 0.4_c_double]
    call rcf_batch_solve(system, gaps, approaches, p=all_p, load=load, load_lower=lower, load_upper=upper, &
      status=statuses, iterations=iterations, certified=certified, first=first)
    call check('a batch', certified == 3 .and. first == 0 .and. all(statuses == RC_OK) .and. all(iterations > 0))
    call check('intervals of a batch', all(lower <= load .and. load <= upper))
    progress = c_funloc(half_is_enough)
    call rcf_batch_solve(system, gaps, approaches, certified=certified, progress=progress, user=c_loc(seen), stat=stat)
    call check('ended by progress', stat == RC_STOP_CANCELLED .and. seen == 3 .and. certified == 1)
    call rcf_batch_solve(system, gaps(:, :, 1:1), loads=load, stat=stat)
    call check('one surface, three histories of loads', stat == RC_OK)
    call rcf_batch_solve(system, gaps, approaches, load=load(:, 1:2), status=statuses(:, 1:1), stat=stat, errmsg=message)
    call check('shapes: '//trim(message), stat == RC_ERR_SHAPE .and. index(message, 'load') > 0 .and. &
      index(message, 'status') > 0)
  end subroutine
end program
