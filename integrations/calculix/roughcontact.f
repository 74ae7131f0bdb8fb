!
!     CalculiX - A 3-dimensional finite element program: contact laws
!     of roughcontact
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
      include 'rough_functions.f'
!
!     The laws of the deck. Laws are added while the deck is read, by
!     one thread; after that they are only read.
!
      module roughcontact_laws
      use rough_functions
      implicit none
      integer, parameter :: most=64
      type law_of_the_deck
         character(80) :: name=' '
         type(c_ptr) :: law=c_null_ptr
!        conductivities of both bodies; one unit of pressure and of
!        length of the law in units of the deck
         real(c_double) :: k(2)=0.d0,pressure=1.d0,length=1.d0
      end type
      type(law_of_the_deck), save :: laws(most)
      integer, save :: number_of_laws=0
      end module
!
!     opens the law of a surface interaction. numbers(1..2):
!     conductivities, (3..4): one unit of length and of force of the law
!     in units of the deck; 0: unset
!
      subroutine rough_law_open(name,numbers,number,ier)
      use roughcontact_laws
      implicit none
      character*80 name
      real*8 numbers(4),length,force
      integer number,ier,status
!
!     *CHANGE SURFACE BEHAVIOR may name an interaction again
!
      do number=1,number_of_laws
         if(laws(number)%name.eq.name) exit
      enddo
      if(number.gt.most) then
         write(*,*) '*ERROR reading *SURFACE BEHAVIOR: more than',most
         write(*,*) '       interactions have a law'
         ier=1
         return
      endif
      call open_law_of(name,laws(number)%law,status)
      if(status.gt.0) then
         write(*,*) '*WARNING reading *SURFACE BEHAVIOR: the law of'
         write(*,*) '       interaction ',trim(name),' is not proven:'
         call print_last_error()
      endif
      if(status.lt.0) then
         write(*,*) '*ERROR reading *SURFACE BEHAVIOR: the law of'
         write(*,*) '       interaction ',trim(name)
         call print_last_error()
         ier=1
         return
      endif
      length=numbers(3)
      force=numbers(4)
      if(length.eq.0.d0) length=1.d0
      if(force.eq.0.d0) force=1.d0
      if((minval(numbers(1:2)).lt.0.d0).or.(length.lt.0.d0).or.
     &     (force.lt.0.d0)) then
         write(*,*) '*ERROR reading *SURFACE BEHAVIOR: conductivities'
         write(*,*) '       and units must not be negative'
         ier=1
         return
      endif
      laws(number)%name=name
      laws(number)%k=numbers(1:2)
      laws(number)%length=length
      laws(number)%pressure=force/length**2
      number_of_laws=max(number,number_of_laws)
!
      return
      end
!
!     pressure at an overclosure, its derivative and its integral
!
      subroutine rough_law(number,overlap,pres,dpresdoverlap,energy)
      use roughcontact_laws
      implicit none
      integer number
      real*8 overlap,pres,dpresdoverlap,energy
!
      call check(rc_law_pressure(laws(number)%law,
     &     overlap/laws(number)%length,pres,dpresdoverlap,energy))
      pres=pres*laws(number)%pressure
      dpresdoverlap=dpresdoverlap*laws(number)%pressure/
     &     laws(number)%length
      energy=energy*laws(number)%pressure*laws(number)%length
!
      return
      end
!
!     conductance at a contact pressure
!
      subroutine rough_law_conductance(name,pres,conductance)
      use roughcontact_laws
      implicit none
      character*80 name
      integer number
      real*8 pres,conductance
!
      do number=1,number_of_laws
         if(laws(number)%name.eq.name) exit
      enddo
      if(number.gt.number_of_laws) then
         write(*,*) '*ERROR in gapcon: *GAP CONDUCTANCE,USER needs'
         write(*,*) '       PRESSURE-OVERCLOSURE=USER'
         call exit(201)
      endif
      if(minval(laws(number)%k).le.0.d0) then
         write(*,*) '*ERROR in gapcon: interaction ',trim(name)
         write(*,*) '       needs the conductivities of both bodies on'
         write(*,*) '       the line after *SURFACE BEHAVIOR'
         call exit(201)
      endif
      call check(rc_law_gap_conductance(laws(number)%law,
     &     pres/laws(number)%pressure,1.d0/laws(number)%k(1),
     &     1.d0/laws(number)%k(2),conductance))
      conductance=conductance/laws(number)%length
!
      return
      end
