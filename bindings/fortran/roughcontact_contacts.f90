! Contacts: one system, many steps; and a solve in one call. Exactly one of approach and load is given. Arrays that are not
! contiguous are copied by the compiler.
module roughcontact_contacts
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_options, only: rcf_or_null
  use roughcontact_steps
  use roughcontact_strings, only: rc_from_c
  implicit none
  private
  public :: rcf_contact, rcf_contact_create, rcf_contact_destroy, rcf_contact_reset, rcf_contact_cancel, &
    rcf_contact_set_options, rcf_contact_on_progress, rcf_contact_solve, rcf_contact_certify, rcf_contact_level, &
    rcf_contact_points, rcf_contact_explain, rcf_contact_indentation, rcf_contact_creep, rcf_contact_restore, rcf_solve

  ! Not to be copied: one variable, destroyed once.
  type :: rcf_contact
    type(c_ptr) :: handle = c_null_ptr  ! for the rc_ functions
    integer(c_int64_t) :: nx = 0, ny = 0
    integer(c_int32_t) :: creep_terms = 0
  end type

contains

  ! system%dense and what system%user points to must be targets that outlive the contact.
  subroutine rcf_contact_create(contact, system, options, stat, errmsg)
    type(rcf_contact), intent(out) :: contact
    type(rc_system), intent(in) :: system
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    contact%nx = system%nx
    contact%ny = system%ny
    contact%creep_terms = system%creep_terms
    call rcf_check(rc_contact_create(system, rcf_or_null(options), contact%handle), stat, errmsg)
  end subroutine

  subroutine rcf_contact_destroy(contact)
    type(rcf_contact), intent(inout) :: contact
    call rc_contact_destroy(contact%handle)
    contact = rcf_contact()
  end subroutine

  subroutine rcf_contact_reset(contact, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_contact_reset(contact%handle), stat, errmsg)
  end subroutine

  subroutine rcf_contact_cancel(contact)
    class(rcf_contact), intent(in) :: contact
    call rc_contact_cancel(contact%handle)
  end subroutine

  subroutine rcf_contact_set_options(contact, options, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    type(c_ptr), intent(in) :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(rc_contact_set_options(contact%handle, options), stat, errmsg)
  end subroutine

  ! Called at least every `every` iterations (1). fn: c_null_funptr for no more calls, or c_funloc of a module procedure
  !   integer(c_int32_t) function fn(progress, user) bind(c)   ! nonzero: stop
  !     type(rc_progress), intent(in) :: progress
  !     type(c_ptr), value :: user
  subroutine rcf_contact_on_progress(contact, fn, user, every, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    type(c_funptr), value :: fn
    type(c_ptr), intent(in), optional :: user
    integer, intent(in), optional :: every
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: interval
    interval = 1
    if (present(every)) interval = every
    call rcf_check(rc_contact_on_progress(contact%handle, fn, rcf_or_null(user), interval), stat, errmsg)
  end subroutine

  ! undeformed_gap and mask absent: as in the step before. p and gap: pressures and deformed gap, written where the status
  ! is >= 0. time: at the step's end, with creep.
  subroutine rcf_contact_solve(contact, approach, load, undeformed_gap, mask, p0, warm_start, p, gap, result, stat, errmsg, time)
    class(rcf_contact), intent(in) :: contact
    real(c_double), intent(in), optional :: approach, load
    real(c_double), intent(in), optional, target, contiguous :: undeformed_gap(:, :), p0(:, :)
    logical, intent(in), optional :: mask(:, :), warm_start
    real(c_double), intent(inout), optional, target, contiguous :: p(:, :), gap(:, :)
    type(rc_result), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional :: time
    type(rc_step) :: step
    type(rc_result) :: answer
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    integer(rc_status) :: status
    if (.not. rcf_prepared('rcf_contact_solve', contact%nx, contact%ny, step, answer, bytes, approach, load, undeformed_gap, &
      mask, p0, warm_start, p, gap, stat, errmsg)) return
    if (present(time)) step%time = time
    status = rc_contact_solve(contact%handle, step, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Certifies the pressures p; nothing is solved.
  subroutine rcf_contact_certify(contact, p, approach, load, undeformed_gap, mask, gap, result, stat, errmsg, time)
    class(rcf_contact), intent(in) :: contact
    real(c_double), intent(inout), target, contiguous :: p(:, :)
    real(c_double), intent(in), optional :: approach, load
    real(c_double), intent(in), optional, target, contiguous :: undeformed_gap(:, :)
    logical, intent(in), optional :: mask(:, :)
    real(c_double), intent(inout), optional, target, contiguous :: gap(:, :)
    type(rc_result), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional :: time
    type(rc_step) :: step
    type(rc_result) :: answer
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    integer(rc_status) :: status
    if (.not. rcf_prepared('rcf_contact_certify', contact%nx, contact%ny, step, answer, bytes, approach, load, undeformed_gap, &
      mask, p=p, gap=gap, stat=stat, errmsg=errmsg)) return
    if (present(time)) step%time = time
    status = rc_contact_certify(contact%handle, step, answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Coarse solution i = 1 (coarsest) .. result%levels of the last step.
  subroutine rcf_contact_level(contact, i, level, p, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    integer, intent(in) :: i
    type(rc_level), intent(out) :: level
    real(c_double), allocatable, intent(out), optional, target :: p(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(rc_status) :: status
    status = rc_contact_level(contact%handle, int(i - 1, c_int64_t), level)
    if (status >= 0 .and. present(p)) then
      allocate (p(level%nx, level%ny))
      level%p%data = c_loc(p)
      status = rc_contact_level(contact%handle, int(i - 1, c_int64_t), level)
    end if
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! The points that carry pressure, from 1 on: p(index(k)) of the pressures as one row, ix = 1 + mod(index(k) - 1, nx).
  subroutine rcf_contact_points(contact, index, p, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    integer(c_int64_t), allocatable, intent(out), target :: index(:)
    real(c_double), allocatable, intent(out), target :: p(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: room, n
    integer(rc_status) :: status
    room = 0
    status = rc_contact_points(contact%handle, 0_c_int64_t, rc_array(), rc_array(), room)
    allocate (index(room), p(room))
    if (status >= 0 .and. room > 0) &
      status = rc_contact_points(contact%handle, room, rc_array(c_loc(index)), rc_array(c_loc(p)), n)
    index = index + 1
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! Why auto chose what it did in the last step on the given grid, in lines.
  subroutine rcf_contact_explain(contact, text, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    character(:), allocatable, intent(out) :: text
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: explanation
    integer(rc_status) :: status
    explanation = c_null_ptr
    status = rc_contact_explain(contact%handle, explanation)
    text = rc_from_c(explanation)
    call rcf_check(status, stat, errmsg)
  end subroutine

  ! The plastic indentation that the steps so far have left where the pressure was system%hardness [length].
  subroutine rcf_contact_indentation(contact, indentation, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    real(c_double), allocatable, intent(out), target :: indentation(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    allocate (indentation(contact%nx, contact%ny))
    call rcf_check(rc_contact_indentation(contact%handle, rcf_out(indentation)), stat, errmsg)
  end subroutine

  ! What the steps so far have left in bodies that creep (nx, ny, terms + 1) [length], and the time of the last one; see
  ! rc_contact_creep.
  subroutine rcf_contact_creep(contact, creep, time, stat, errmsg)
    type(rcf_contact), intent(in) :: contact
    real(c_double), allocatable, intent(out), target :: creep(:, :, :)
    real(c_double), intent(inout), optional :: time
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    allocate (creep(contact%nx, contact%ny, contact%creep_terms + 1))
    call rcf_check(rc_contact_creep(contact%handle, rc_array(c_loc(creep)), time), stat, errmsg)
  end subroutine

  ! Goes on after a certified step that this contact or another has solved: its surface, pressures, and approach and load as its
  ! result has them; with p_before likewise of the step before it, on the same surface; with a hardness the indentation that
  ! rcf_contact_indentation gave after it, and with creep both that rcf_contact_creep gave. See option resumable.
  subroutine rcf_contact_restore(contact, undeformed_gap, p, approach, load, p_before, approach_before, load_before, mask, &
    indentation, stat, errmsg, creep, time)
    type(rcf_contact), intent(in) :: contact
    real(c_double), intent(in), target, contiguous :: undeformed_gap(:, :), p(:, :)
    real(c_double), intent(in) :: approach, load
    real(c_double), intent(in), optional, target, contiguous :: p_before(:, :)
    real(c_double), intent(in), optional :: approach_before, load_before
    logical, intent(in), optional :: mask(:, :)
    real(c_double), intent(in), optional, target, contiguous :: indentation(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional, target, contiguous :: creep(:, :, :)
    real(c_double), intent(in), optional :: time
    character(*), parameter :: where = 'rcf_contact_restore'
    type(rc_state) :: state
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    if ((present(p_before) .neqv. present(approach_before)) .or. (present(p_before) .neqv. present(load_before))) then
      call rcf_refuse(RC_ERR_ARGUMENT, where//': give all of p_before, approach_before and load_before, or none', stat, errmsg)
      return
    end if
    if (present(creep) .neqv. present(time)) then
      call rcf_refuse(RC_ERR_ARGUMENT, where//': give both creep and time, or none', stat, errmsg)
      return
    end if
    if (present(creep)) then
      if (.not. rcf_extents_fit(where, 'creep', [size(creep, 1), size(creep, 2)], contact%nx, contact%ny, stat, errmsg)) return
      if (size(creep, 3) /= contact%creep_terms + 1) then
        call rcf_refuse(RC_ERR_SHAPE, where//': the last extent of creep is not that of rcf_contact_creep', stat, errmsg)
        return
      end if
    end if
    if (.not. rcf_shaped(where, 'undeformed_gap', undeformed_gap, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'p', p, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'p_before', p_before, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_shaped(where, 'indentation', indentation, contact%nx, contact%ny, stat, errmsg)) return
    state = rc_state(undeformed_gap=rcf_in(undeformed_gap), p=rcf_in(p), approach=approach, load=load, &
      p_before=rcf_in(p_before), indentation=rcf_in(indentation))
    if (.not. rcf_masked(where, mask, contact%nx, contact%ny, bytes, state%mask, stat, errmsg)) return
    if (present(approach_before)) state%approach_before = approach_before
    if (present(load_before)) state%load_before = load_before
    if (present(creep)) state%creep = rc_const_array(c_loc(creep))
    if (present(time)) state%time = time
    call rcf_check(rc_contact_restore(contact%handle, state), stat, errmsg)
  end subroutine

  ! Create, solve, destroy. nx and ny are those of undeformed_gap, whatever the system says.
  subroutine rcf_solve(system, undeformed_gap, approach, load, mask, p0, p, gap, options, result, stat, errmsg)
    type(rc_system), intent(in) :: system
    real(c_double), intent(in), target, contiguous :: undeformed_gap(:, :)
    real(c_double), intent(in), optional :: approach, load
    logical, intent(in), optional :: mask(:, :)
    real(c_double), intent(in), optional, target, contiguous :: p0(:, :)
    real(c_double), intent(inout), optional, target, contiguous :: p(:, :), gap(:, :)
    type(c_ptr), intent(in), optional :: options
    type(rc_result), intent(out), optional :: result
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(rc_system) :: sized
    type(rc_step) :: step
    type(rc_result) :: answer
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    integer(rc_status) :: status
    sized = system
    sized%nx = size(undeformed_gap, 1, c_int64_t)
    sized%ny = size(undeformed_gap, 2, c_int64_t)
    if (.not. rcf_prepared('rcf_solve', sized%nx, sized%ny, step, answer, bytes, approach, load, undeformed_gap, mask, p0, &
      p=p, gap=gap, stat=stat, errmsg=errmsg)) return
    status = rc_solve(sized, step, rcf_or_null(options), answer)
    if (present(result)) result = answer
    call rcf_check(status, stat, errmsg)
  end subroutine
end module
