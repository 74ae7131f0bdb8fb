! How the rcf_ procedures report, in the manner of ALLOCATE: with stat= the status is handed back (0: certified), and errmsg= is
! set where it is not 0. Without stat= a status other than RC_OK and RC_WITHIN_GOAL ends the program with the message.
module roughcontact_errors
  use roughcontact_functions
  use roughcontact_strings
  implicit none
  private
  public :: rc_error_message, rcf_check, rcf_refuse

contains

  ! The text of the calling thread's last failure or stop.
  function rc_error_message() result(text)
    character(:), allocatable :: text
    text = rc_from_c(rc_last_error())
  end function

  ! Reports the status of a call that has just been made, with the message of its library, libroughcontact's if absent.
  subroutine rcf_check(status, stat, errmsg, message)
    integer(rc_status), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(*), intent(in), optional :: message
    character(:), allocatable :: text
    if (present(stat)) stat = int(status)
    if (status == RC_OK) return
    if (present(message)) then
      text = message
    else
      text = rc_error_message()
    end if
    if (len(text) == 0) text = rc_from_c(rc_status_text(status))
    if (present(errmsg)) errmsg = text
    if (.not. present(stat) .and. status /= RC_WITHIN_GOAL) error stop rc_from_c(rc_status_name(status))//': '//text
  end subroutine

  ! Reports a failure that was found before the library was called.
  subroutine rcf_refuse(status, message, stat, errmsg)
    integer(rc_status), intent(in) :: status
    character(*), intent(in) :: message
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call rcf_check(status, stat, errmsg, message)
  end subroutine
end module
