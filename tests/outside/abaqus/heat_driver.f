C     Calls GAPCON as Abaqus/Standard does: for each pressure of the
C     input the conductance and its derivative by the pressure.
      PROGRAM HEAT
      IMPLICIT REAL*8(A-H,O-Z)
      CHARACTER*80 CINAME
      DIMENSION AK(5), D(2), FLOWM(2), TEMP(2), PREDEF(2,1), TIME(2),
     1     COORDS(3)
      CINAME = 'JOINT'
      TIME(1) = 0
      CALL UEXTERNALDB(0, 0, TIME, 0D0, 1, 0)
   10 READ(*,*,END=90) D(2)
      DO 20 I = 1, 5
        AK(I) = 0
   20 CONTINUE
      CALL GAPCON(AK,D,FLOWM,TEMP,PREDEF,TIME,CINAME,'SLAVE','MASTER',
     1     COORDS,1,1,0,1,1)
      WRITE(*,'(2ES25.16)') AK(1), AK(3)
      GOTO 10
   90 END
