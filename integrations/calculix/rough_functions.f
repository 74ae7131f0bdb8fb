!
!     CalculiX - A 3-dimensional finite element program: the functions
!     of libroughcontact for its laws
!
!     This program is free software; you can redistribute it and/or
!     modify it under the terms of the GNU General Public License as
!     published by the Free Software Foundation(version 2);
!
!     This program is distributed in the hope that it will be useful,
!     but WITHOUT ANY WARRANTY; without even the implied warranty of
!     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE. See the
!     GNU General Public License for more details.
!
!     gapcon.f and roughcontact.f include this file. A program has one
!     of them.
!
      module rough_functions
      use, intrinsic :: iso_c_binding
      implicit none
      interface
         function rc_law_open(name,path,law) bind(c) result(status)
         import
         character(kind=c_char), intent(in) :: name(*)
         type(c_ptr), value :: path
         type(c_ptr), intent(out) :: law
         integer(c_int32_t) :: status
         end function
         function rc_law_pressure(law,x,p,slope,energy) bind(c)
     &        result(status)
         import
         type(c_ptr), value :: law
         real(c_double), value :: x
         real(c_double), intent(out) :: p,slope,energy
         integer(c_int32_t) :: status
         end function
         function rc_law_gap_conductance(law,p,rho1,rho2,h) bind(c)
     &        result(status)
         import
         type(c_ptr), value :: law
         real(c_double), value :: p,rho1,rho2
         real(c_double), intent(out) :: h
         integer(c_int32_t) :: status
         end function
         function rc_last_error() bind(c) result(text)
         import
         type(c_ptr) :: text
         end function
      end interface
      contains
!
!     opens the law of a surface interaction name or LAW_name: the file
!     name.law, in lower case, in the job's folder
!
      subroutine open_law_of(interaction,law,status)
      character(80), intent(in) :: interaction
      type(c_ptr), intent(out) :: law
      integer(c_int32_t), intent(out) :: status
      character(80) :: name
      integer :: i
      name=interaction
      do i=1,len_trim(name)
         if((name(i:i).ge.'A').and.(name(i:i).le.'Z'))
     &        name(i:i)=char(ichar(name(i:i))+32)
      enddo
      if(name(1:4).eq.'law_') name=name(5:)
      status=rc_law_open(trim(name)//c_null_char,c_null_ptr,law)
      end subroutine
!
!     a negative status ends the run, as errors do in the routines of
!     contact springs
!
      subroutine check(status)
      integer(c_int32_t), intent(in) :: status
      if(status.lt.0) then
         call print_last_error()
         call exit(201)
      endif
      end subroutine
!
      subroutine print_last_error()
      character(kind=c_char), pointer :: text(:)
      integer :: i
      call c_f_pointer(rc_last_error(),text,[1024])
      do i=1,size(text)-1
         if(text(i).eq.c_null_char) exit
      enddo
      write(*,*) '       ',text(1:i-1)
      end subroutine
      end module
