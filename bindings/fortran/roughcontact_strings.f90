! Strings of Fortran and of C.
module roughcontact_strings
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: rc_to_c, rc_from_c

  ! A Fortran string from a C one: a char array of a struct, or a pointer such as rc_status_text(status).
  interface rc_from_c
    procedure from_array, from_pointer
  end interface

contains

  ! The string as C wants it: trailing blanks off, a NUL at the end.
  pure function rc_to_c(string) result(c)
    character(*), intent(in) :: string
    character(len_trim(string) + 1, kind=c_char) :: c
    c = trim(string)//c_null_char
  end function

  pure function from_array(c) result(text)
    character(kind=c_char), intent(in) :: c(:)
    character(:), allocatable :: text
    integer :: i, n
    do n = 0, size(c) - 1
      if (c(n + 1) == c_null_char) exit
    end do
    allocate (character(n) :: text)
    do i = 1, n
      text(i:i) = c(i)
    end do
  end function

  function from_pointer(c) result(text)
    type(c_ptr), intent(in) :: c
    character(:), allocatable :: text
    character(kind=c_char), pointer :: chars(:)
    interface
      pure integer(c_size_t) function strlen(string) bind(c); import
        type(c_ptr), value :: string
      end function
    end interface
    text = ''
    if (.not. c_associated(c)) return
    call c_f_pointer(c, chars, [strlen(c)])
    text = from_array(chars)
  end function
end module
