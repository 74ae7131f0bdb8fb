C     Calls UINTER as Abaqus/Standard does: a point of an interface
C     behind three springs, whose ends a path moves; a degree of
C     freedom for each direction, Newton's method, states kept from the
C     start of the increment. Then heat, and a perturbation about the
C     end. Lines of the input: U(3), TEMP(2). Standard output: for each
C     the iterations, RDISP(3), STRESS(3), FLUX(1), SED, total SFD; last
C     the STRESS(3) of a perturbation, and GAPCON's conductances.
      PROGRAM DRIVER
      IMPLICIT REAL*8(A-H,O-Z)
      PARAMETER (NSTATV=64)
      CHARACTER*80 CINAME
      DIMENSION S(3), C(3,3), DV(3,3), DS(3,3), FLUX(2), FT(2,2),
     1     ST(3,2), FR(2,3), OLD(NSTATV), STATEV(NSTATV), R(3), DR(3),
     2     R0(3), T(2), DT(2), PRE(2,1), DPRE(2,1), TIME(2), PROPS(1),
     3     COORDS(3), ALOCAL(3,3), DROT(2,2), U(3), SPRING(3), A(3,4)
      DATA SPRING /4.0D4, 2.0D4, 2.0D4/, OLD /NSTATV*0D0/,
     1     R0 /-1D-4, 0D0, 0D0/, DROT /1D0, 0D0, 0D0, 1D0/
      CINAME = 'Joint'
      LOPEN = -1
      SUM = 0
      TIME(1) = 0
      CALL UEXTERNALDB(0, 0, TIME, 0D0, 1, 0)
   10 READ(*,*,END=90) U, T
      DO 11 I = 1, 3
        R(I) = R0(I)
   11 CONTINUE
      DO 50 KIT = 0, 30
        DO 20 I = 1, NSTATV
          STATEV(I) = OLD(I)
   20   CONTINUE
        DO 21 I = 1, 3
          DR(I) = R(I)-R0(I)
   21   CONTINUE
        PNEWDT = 1D36
        SED = 0
        SFD = 0
        CALL UINTER(S,C,DV,DS,FLUX,FT,ST,FR,STATEV,SED,SFD,SPD,SVD,SCD,
     1       PNEWDT,R,DR,T,DT,PRE,DPRE,TIME,1D0,0D0,CINAME,'SEC','MAIN',
     2       PROPS,COORDS,ALOCAL,DROT,1D0,1D0,1,3,NSTATV,1,1,3,1,1,KIT,
     3       0,LOPEN,LSTATE,LSDI,0)
C       Springs carry what the interface carries.
        SIZE = 0
        DO 30 I = 1, 3
          A(I,4) = SPRING(I)*(U(I)-R(I))-S(I)
          SIZE = SIZE+ABS(A(I,4))
          DO 30 J = 1, 3
            A(I,J) = C(I,J)
            IF (I.EQ.J) A(I,J) = A(I,J)+SPRING(I)
   30   CONTINUE
        IF (SIZE.LE.1D-10*(1D-3+ABS(S(1)))) GOTO 60
        DO 40 K = 1, 3
          DO 40 I = 1, 3
            IF (I.EQ.K) GOTO 40
            F = A(I,K)/A(K,K)
            DO 39 J = K, 4
              A(I,J) = A(I,J)-F*A(K,J)
   39       CONTINUE
   40   CONTINUE
        DO 41 I = 1, 3
          R(I) = R(I)+A(I,4)/A(I,I)
   41   CONTINUE
   50 CONTINUE
      STOP 1
   60 SUM = SUM+SFD
      WRITE(*,'(I3,10ES25.16)') KIT, R, S, FLUX(1), SED, SUM
      DO 70 I = 1, NSTATV
        OLD(I) = STATEV(I)
   70 CONTINUE
      DO 71 I = 1, 3
        R0(I) = R(I)
   71 CONTINUE
      GOTO 10
   90 DR(1) = 1D-7
      DR(2) = 2D-7
      DR(3) = -1D-7
      CALL UINTER(S,C,DV,DS,FLUX,FT,ST,FR,STATEV,SED,SFD,SPD,SVD,SCD,
     1     PNEWDT,DR,DR,T,DT,PRE,DPRE,TIME,1D0,0D0,CINAME,'SEC','MAIN',
     2     PROPS,COORDS,ALOCAL,DROT,1D0,1D0,1,3,NSTATV,1,1,3,1,1,1,1,
     3     LOPEN,LSTATE,LSDI,0)
      WRITE(*,'(3ES25.16)') S
      END
