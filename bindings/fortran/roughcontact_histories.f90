! Loading histories: of one contact (a history), and of many contacts in one call (a batch). Exactly one of approaches and loads
! is given.
module roughcontact_histories
  use roughcontact_arrays
  use roughcontact_contacts, only: rcf_contact
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_options, only: rcf_or_null
  implicit none
  private
  public :: rcf_contact_solve_history, rcf_batch_solve

contains

  ! Outputs have one value a step; completed: steps that are written. fn: a variable with the c_funloc
  ! (itself a constant that linkers dislike) of
  !   integer(c_int32_t) function fn(step, result, user) bind(c)   ! nonzero: end the history
  !     integer(c_int64_t), value :: step                          ! from 0
  !     type(rc_result), intent(in) :: result                      ! %p%data and %gap%data last until it returns
  !     type(c_ptr), value :: user
  subroutine rcf_contact_solve_history(contact, approaches, loads, undeformed_gap, mask, warm_start, load, approach, contact_area, &
    mean_gap, energy, stiffness, load_lower, load_upper, area_lower, area_upper, stiffness_lower, stiffness_upper, certificate, &
    products, fn, user, virgin, completed, stat, errmsg, times)
    type(rcf_contact), intent(in) :: contact
    real(c_double), intent(in), optional, target, contiguous :: approaches(:), loads(:), undeformed_gap(:, :)
    logical, intent(in), optional :: mask(:, :), warm_start
    real(c_double), intent(inout), optional, target, contiguous :: load(:), approach(:), contact_area(:), mean_gap(:), energy(:), &
      stiffness(:), load_lower(:), load_upper(:), area_lower(:), area_upper(:), stiffness_lower(:), stiffness_upper(:), &
      certificate(:)
    integer(c_int64_t), intent(inout), optional, target, contiguous :: products(:)
    type(c_funptr), intent(in), optional :: fn
    type(c_ptr), intent(in), optional :: user
    logical, intent(in), optional :: virgin  ! every step presses the surface as it is before the first
    integer, intent(out), optional :: completed
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional, target, contiguous :: times(:)  ! of the steps' ends, with creep
    character(*), parameter :: where = 'rcf_contact_solve_history'
    type(rc_history) :: history
    integer(c_int8_t), allocatable, target :: bytes(:, :)
    integer(rc_status) :: status
    integer :: shortest
    if (present(completed)) completed = 0
    if (present(approaches) .eqv. present(loads)) then
      call rcf_refuse(RC_ERR_ARGUMENT, where//': give one of approaches and loads', stat, errmsg)
      return
    end if
    history%control = merge(RC_CONTROL_LOAD, RC_CONTROL_APPROACH, present(loads))
    if (present(approaches)) then
      history%n = size(approaches, kind=c_int64_t)
      if (history%n > 0) history%targets%data = c_loc(approaches)
    else
      history%n = size(loads, kind=c_int64_t)
      if (history%n > 0) history%targets%data = c_loc(loads)
    end if
    if (present(warm_start)) history%warm_start = merge(1, 0, warm_start)
    if (.not. rcf_shaped(where, 'undeformed_gap', undeformed_gap, contact%nx, contact%ny, stat, errmsg)) return
    if (.not. rcf_masked(where, mask, contact%nx, contact%ny, bytes, history%mask, stat, errmsg)) return
    history%undeformed_gap = rcf_in(undeformed_gap)
    if (present(times)) then
      if (size(times) /= history%n) then
        call rcf_refuse(RC_ERR_SHAPE, where//': times has not one value for each step', stat, errmsg)
        return
      end if
      if (size(times) > 0) history%times%data = c_loc(times)
    end if
    shortest = int(history%n)
    call place(load, history%columns%load)
    call place(approach, history%columns%approach)
    call place(contact_area, history%columns%contact_area)
    call place(mean_gap, history%columns%mean_gap)
    call place(energy, history%columns%energy)
    call place(stiffness, history%columns%stiffness)
    call place(load_lower, history%columns%load_lower)
    call place(load_upper, history%columns%load_upper)
    call place(area_lower, history%columns%area_lower)
    call place(area_upper, history%columns%area_upper)
    call place(stiffness_lower, history%columns%stiffness_lower)
    call place(stiffness_upper, history%columns%stiffness_upper)
    call place(certificate, history%columns%certificate)
    if (present(products)) then
      shortest = min(shortest, size(products))
      if (size(products) > 0) history%columns%products%data = c_loc(products)
    end if
    if (shortest < history%n) then
      call rcf_refuse(RC_ERR_SHAPE, where//': an output array has fewer values than there are steps', stat, errmsg)
      return
    end if
    if (present(fn)) history%fn = fn
    if (present(virgin)) history%virgin = merge(1, 0, virgin)
    history%user = rcf_or_null(user)
    status = rc_contact_solve_history(contact%handle, history)
    if (present(completed)) completed = int(history%completed)
    call rcf_check(status, stat, errmsg)

  contains

    subroutine place(x, array)
      real(c_double), intent(inout), optional, target, contiguous :: x(:)
      type(rc_array), intent(inout) :: array
      if (.not. present(x)) return
      shortest = min(shortest, size(x))
      if (size(x) > 0) array%data = c_loc(x)
    end subroutine
  end subroutine

  ! undeformed_gap(nx, ny, contacts) and approaches or loads (steps, contacts), either with 1 as its last extent: the same
  ! for all.
  ! Outputs have the shape (steps, contacts), p and p0 the shape (nx, ny, contacts). status: of every step. fn: as above, with the
  ! contact's number, from 0, before the step's; it is called from several threads at the same time.
  ! progress: likewise, of
  !   integer(c_int32_t) function progress(ended, user) bind(c)    ! nonzero: end the batch
  !     integer(c_int64_t), value :: ended                         ! steps of all contacts so far
  !     type(c_ptr), value :: user
  subroutine rcf_batch_solve(system, undeformed_gap, approaches, loads, mask, warm_start, p0, p, load, approach, contact_area, &
    mean_gap, energy, stiffness, load_lower, load_upper, area_lower, area_upper, stiffness_lower, stiffness_upper, certificate, &
    status, iterations, products, fn, user, options, virgin, certified, first, progress, stat, errmsg, times)
    type(rc_system), intent(in) :: system
    real(c_double), intent(in), target, contiguous :: undeformed_gap(:, :, :)
    real(c_double), intent(in), optional, target, contiguous :: approaches(:, :), loads(:, :), p0(:, :, :)
    logical, intent(in), optional :: mask(:, :, :), warm_start, virgin
    real(c_double), intent(inout), optional, target, contiguous :: p(:, :, :), load(:, :), approach(:, :), &
      contact_area(:, :), mean_gap(:, :), energy(:, :), stiffness(:, :), load_lower(:, :), load_upper(:, :), area_lower(:, :), &
      area_upper(:, :), stiffness_lower(:, :), stiffness_upper(:, :), certificate(:, :)
    integer(rc_status), intent(inout), optional, target, contiguous :: status(:, :)
    integer(c_int64_t), intent(inout), optional, target, contiguous :: iterations(:, :), products(:, :)
    type(c_funptr), intent(in), optional :: fn, progress
    type(c_ptr), intent(in), optional :: user, options
    integer, intent(out), optional :: certified, first  ! certified contacts; the one whose status is returned, or 0
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double), intent(in), optional, target, contiguous :: times(:, :)  ! of the steps' ends, with creep
    type(rc_system) :: sized
    type(rc_batch) :: batch
    integer(c_int8_t), allocatable, target :: bytes(:, :, :)
    integer(rc_status) :: answer
    integer :: targets(2), n
    character(:), allocatable :: misshapen
    if (present(certified)) certified = 0
    if (present(first)) first = 0
    if (present(approaches) .eqv. present(loads)) then
      call rcf_refuse(RC_ERR_ARGUMENT, 'rcf_batch_solve: give one of approaches and loads', stat, errmsg)
      return
    end if
    sized = system
    sized%nx = size(undeformed_gap, 1, c_int64_t)
    sized%ny = size(undeformed_gap, 2, c_int64_t)
    batch%control = merge(RC_CONTROL_LOAD, RC_CONTROL_APPROACH, present(loads))
    batch%targets = merged(approaches, loads, targets)
    n = max(size(undeformed_gap, 3), targets(2))
    batch%n = n
    batch%steps = targets(1)
    if (size(undeformed_gap) > 0) batch%undeformed_gap%data = c_loc(undeformed_gap)
    if (size(undeformed_gap, 3) == 1) batch%undeformed_gap_stride = RC_BATCH_SHARED
    if (targets(2) == 1) batch%target_stride = RC_BATCH_SHARED

    misshapen = ''
    if (size(undeformed_gap, 3) /= n .and. size(undeformed_gap, 3) /= 1) misshapen = misshapen//' undeformed_gap'
    if (targets(2) /= n .and. targets(2) /= 1) misshapen = misshapen//' approaches or loads'
    if (present(mask)) then
      if (.not. (stacked(shape(mask), n) .or. stacked(shape(mask), 1))) then
        misshapen = misshapen//' mask'
      else
        bytes = merge(1_c_int8_t, 0_c_int8_t, mask)
        batch%mask%data = c_loc(bytes)
        if (size(mask, 3) == 1) batch%mask_stride = RC_BATCH_SHARED
      end if
    end if
    if (present(times)) then
      if (any(shape(times) /= targets)) misshapen = misshapen//' times'
      batch%times = rcf_in(times)
    end if
    call pile(p0, 'p0', batch%p0%data)
    call pile(p, 'p', batch%p%data)
    call place(load, 'load', batch%columns%load)
    call place(approach, 'approach', batch%columns%approach)
    call place(contact_area, 'contact_area', batch%columns%contact_area)
    call place(mean_gap, 'mean_gap', batch%columns%mean_gap)
    call place(energy, 'energy', batch%columns%energy)
    call place(stiffness, 'stiffness', batch%columns%stiffness)
    call place(load_lower, 'load_lower', batch%columns%load_lower)
    call place(load_upper, 'load_upper', batch%columns%load_upper)
    call place(area_lower, 'area_lower', batch%columns%area_lower)
    call place(area_upper, 'area_upper', batch%columns%area_upper)
    call place(stiffness_lower, 'stiffness_lower', batch%columns%stiffness_lower)
    call place(stiffness_upper, 'stiffness_upper', batch%columns%stiffness_upper)
    call place(certificate, 'certificate', batch%columns%certificate)
    if (present(status)) then
      if (.not. tabled(shape(status))) misshapen = misshapen//' status'
      if (size(status) > 0) batch%columns%status%data = c_loc(status)
    end if
    call count_into(iterations, 'iterations', batch%columns%iterations)
    call count_into(products, 'products', batch%columns%products)
    if (len(misshapen) > 0) then
      call rcf_refuse(RC_ERR_SHAPE, 'rcf_batch_solve: shapes do not go together:'//misshapen, stat, errmsg)
      return
    end if

    if (present(warm_start)) batch%warm_start = merge(1, 0, warm_start)
    if (present(fn)) batch%fn = fn
    if (present(progress)) batch%progress = progress
    if (present(virgin)) batch%virgin = merge(1, 0, virgin)
    batch%user = rcf_or_null(user)
    answer = rc_batch_solve(sized, rcf_or_null(options), batch)
    if (present(certified)) certified = int(batch%certified)
    if (present(first)) first = int(batch%first) + 1
    call rcf_check(answer, stat, errmsg)

  contains

    logical function stacked(found, contacts)
      integer, intent(in) :: found(3), contacts
      stacked = found(1) == size(undeformed_gap, 1) .and. found(2) == size(undeformed_gap, 2) .and. found(3) == contacts
    end function

    logical function tabled(found)
      integer, intent(in) :: found(2)
      tabled = found(1) == targets(1) .and. found(2) == n
    end function

    subroutine pile(x, name, address)
      real(c_double), intent(in), optional, target, contiguous :: x(:, :, :)
      character(*), intent(in) :: name
      type(c_ptr), intent(inout) :: address
      if (.not. present(x)) return
      if (.not. stacked(shape(x), n)) misshapen = misshapen//' '//name
      if (size(x) > 0) address = c_loc(x)
    end subroutine

    subroutine place(x, name, array)
      real(c_double), intent(inout), optional, target, contiguous :: x(:, :)
      character(*), intent(in) :: name
      type(rc_array), intent(inout) :: array
      if (.not. present(x)) return
      if (.not. tabled(shape(x))) misshapen = misshapen//' '//name
      array = rcf_out(x)
    end subroutine

    subroutine count_into(x, name, array)
      integer(c_int64_t), intent(inout), optional, target, contiguous :: x(:, :)
      character(*), intent(in) :: name
      type(rc_array), intent(inout) :: array
      if (.not. present(x)) return
      if (.not. tabled(shape(x))) misshapen = misshapen//' '//name
      if (size(x) > 0) array%data = c_loc(x)
    end subroutine
  end subroutine

  ! The one of two optional arrays that is there.
  function merged(a, b, extents) result(array)
    real(c_double), intent(in), optional, target, contiguous :: a(:, :), b(:, :)
    integer, intent(out) :: extents(2)
    type(rc_const_array) :: array
    if (present(a)) then
      extents = shape(a)
      array = rcf_in(a)
    else
      extents = shape(b)
      array = rcf_in(b)
    end if
  end function
end module
