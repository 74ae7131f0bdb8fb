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
      include 'rough_functions.f'
!
      subroutine gapcon(ak,d,flowm,temp,predef,time,ciname,slname,
     &  msname,coords,noel,node,npred,kstep,kinc,area)
      use rough_functions
      implicit none
!
!     to be adapted: conductivities of both bodies, one unit of length
!     and of force of the law in units of the deck
!
      real*8, parameter :: k1=50.d0,k2=50.d0,length=1.d0,force=1.d0
!
      character*80 ciname,slname,msname
      integer noel,node,npred,kstep,kinc
      real*8 ak(5),d(2),flowm(2),temp(2),predef(2,*),time(*),coords(3),
     &  area
      type(c_ptr) law
      integer(c_int32_t) status
!
      call open_law_of(ciname,law,status)
      if(status.ge.0) status=rc_law_gap_conductance(law,
     &     d(2)*length**2/force,1.d0/k1,1.d0/k2,ak(1))
      if(status.lt.0) write(*,*) '*ERROR in gapcon:'
      call check(status)
      ak(1)=ak(1)/length
!
      return
      end
