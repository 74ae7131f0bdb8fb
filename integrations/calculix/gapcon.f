!
!     CalculiX - A 3-dimensional finite element program: conductance of
!     a rough interface, in the place of CalculiX's own gapcon.f
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
!     *GAP CONDUCTANCE,USER follows the law name.law (lower case, in the
!     job's folder) of the surface interaction name or LAW_name.
!
      subroutine gapcon(ak,d,flowm,temp,predef,time,ciname,slname,
     &  msname,coords,noel,node,npred,kstep,kinc,area)
      use, intrinsic :: iso_c_binding
      implicit none
!
!     to be adapted: conductivities of both bodies, one unit of length
!     and of force of the law in units of the deck
!
      real*8, parameter :: k1=50.d0,k2=50.d0,length=1.d0,force=1.d0
!
      character*80 ciname,slname,msname,name
      integer noel,node,npred,kstep,kinc,i
      real*8 ak(5),d(2),flowm(2),temp(2),predef(2,*),time(*),coords(3),
     &  area
      type(c_ptr) law,text
      integer(c_int32_t) status
      character(kind=c_char), pointer :: letters(:)
      interface
         function rc_law_open(name,path,law) bind(c) result(status)
         import
         character(kind=c_char), intent(in) :: name(*)
         type(c_ptr), value :: path
         type(c_ptr), intent(out) :: law
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
!
      name=ciname
      do i=1,len_trim(name)
         if((name(i:i).ge.'A').and.(name(i:i).le.'Z'))
     &        name(i:i)=char(ichar(name(i:i))+32)
      enddo
      if(name(1:4).eq.'law_') name=name(5:)
      status=rc_law_open(trim(name)//c_null_char,c_null_ptr,law)
      if(status.ge.0) status=rc_law_gap_conductance(law,
     &     d(2)*length**2/force,1.d0/k1,1.d0/k2,ak(1))
      if(status.lt.0) then
         text=rc_last_error()
         call c_f_pointer(text,letters,[1024])
         do i=1,1023
            if(letters(i).eq.c_null_char) exit
         enddo
         write(*,*) '*ERROR in gapcon: ',letters(1:i-1)
         call exit(201)
      endif
      ak(1)=ak(1)/length
!
      return
      end
