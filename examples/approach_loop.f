C     A loop over load steps as an old code has it: fixed form, arrays of
C     a fixed size that are only partly used, statement labels, COMMON.
C     Heights z, lengths in mm, modulus in MPa, forces in N.
      PROGRAM DISLOOP
      USE ROUGHCONTACT
      IMPLICIT NONE
      INTEGER NMAX, NSTEP
      PARAMETER (NMAX = 200, NSTEP = 5)
      DOUBLE PRECISION Z(NMAX,NMAX), P(NMAX,NMAX), H, E, D
      COMMON /SURF/ Z, P
      INTEGER NX, NY, I, J, K, ISTAT
      CHARACTER*200 MESSAG
      TYPE(RCF_CONTACT) CNTCT
      TYPE(RC_RESULT) RES

      NX = 60
      NY = 50
      H = 1.0D-3
      E = 115.0D3
      DO 20 J = 1, NY
        DO 10 I = 1, NX
          Z(I,J) = 5.0D-5 * (COS(0.4D0 * I) + COS(0.7D0 * J))
   10   CONTINUE
   20 CONTINUE

C     The contact keeps tables and the last pressures from step to step.
      CALL RCF_CONTACT_CREATE(CNTCT, RC_SYSTEM(NX=NX, NY=NY, HX=H,
     &  HY=H, MODULUS=E, BOUNDARY=RC_BOUNDARY_FREE))
      WRITE (*, '(A)') ' approach mm      load N  points   max p MPa'
      DO 30 K = 1, NSTEP
        D = 2.0D-5 * K
        CALL RCF_CONTACT_SOLVE(CNTCT, APPROACH=D,
     &    UNDEFORMED_GAP=RCF_GAP_FROM_HEIGHTS(Z(1:NX,1:NY)),
     &    P=P(1:NX,1:NY), RESULT=RES,
     &    STAT=ISTAT, ERRMSG=MESSAG)
        IF (ISTAT .NE. 0) GO TO 90
        WRITE (*, '(F12.5,F12.4,I8,F12.1)') D, RES%LOAD, RES%CONTACTS,
     &    MAXVAL(P(1:NX,1:NY))
   30 CONTINUE
      CALL RCF_CONTACT_DESTROY(CNTCT)
      GO TO 99
   90 WRITE (*, *) 'step ', K, ' failed: ', TRIM(MESSAG)
      STOP 1
   99 END
