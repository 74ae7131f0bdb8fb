C     The laws of a model, for UINTER and GAPCON. The file
C     roughcontact.laws in the job's folder has a line for each
C     surface interaction:
C       NAME FILE MU NU K1 K2 LENGTH FORCE
C     FILE: the table that "roughcontact law --export table=FILE" wrote,
C     in the job's folder; MU, NU: friction, see rc_law_slip; K1, K2:
C     conductivities of both bodies in units of the deck (0: none);
C     LENGTH, FORCE: one unit of the table in units of the deck.
C     Lines that begin with * are comments. To be linked with table.c,
C     compiled with -DROUGHCONTACT_LAW_FORTRAN.
C
C     Laws are read at the start of a job, by one thread.
      SUBROUTINE UEXTERNALDB(LOP,LRESTART,TIME,DTIME,KSTEP,KINC)
      INCLUDE 'ABA_PARAM.INC'
      DIMENSION TIME(2)
      IF (LOP.EQ.0 .OR. LOP.EQ.4) CALL RCREAD
      RETURN
      END
C
      SUBROUTINE RCREAD
      INCLUDE 'ABA_PARAM.INC'
      PARAMETER (MOST=64, MNUM=1000000)
      CHARACTER*80 NAMES(MOST)
      CHARACTER*256 FOLDER, FILE
      CHARACTER*512 LINE
      DOUBLE PRECISION TABLE(MNUM), FACTS(6,MOST)
      COMMON /RCTABS/ TABLE, FACTS, NUMBER, IBEGIN(MOST+1)
      COMMON /RCNAME/ NAMES
      NUMBER = 0
      IBEGIN(1) = 1
      CALL GETOUTDIR(FOLDER, LENGTH)
      OPEN(UNIT=105, FILE=FOLDER(1:LENGTH)//'/roughcontact.laws',
     1     STATUS='OLD', ERR=900)
   10 READ(105,'(A)',END=90,ERR=900) LINE
      IF (LINE.EQ.' ' .OR. LINE(1:1).EQ.'*') GOTO 10
      IF (NUMBER.EQ.MOST) CALL RCSTOP('more than 64 laws', ' ')
      READ(LINE,*,END=910,ERR=910) NAMES(NUMBER+1), FILE,
     1     (FACTS(I,NUMBER+1), I=1,6)
      IF (.NOT.(FACTS(1,NUMBER+1).GE.0 .AND. FACTS(2,NUMBER+1).GE.0
     1     .AND. FACTS(2,NUMBER+1).LE.0.5D0 .AND.
     2     MIN(FACTS(3,NUMBER+1),FACTS(4,NUMBER+1)).GE.0 .AND.
     3     MIN(FACTS(5,NUMBER+1),FACTS(6,NUMBER+1)).GT.0)) GOTO 910
      CALL RCUPPR(NAMES(NUMBER+1))
      OPEN(UNIT=106, FILE=FOLDER(1:LENGTH)//'/'//FILE, STATUS='OLD',
     1     ERR=920)
      J = IBEGIN(NUMBER+1)
      READ(106,*,END=920,ERR=920) N
      IF (N.LT.1 .OR. N.GT.MNUM-J+1) GOTO 920
      READ(106,*,END=920,ERR=920) (TABLE(I), I=J,J+N-1)
      CLOSE(106)
      IF (TABLE(J).NE.N) GOTO 920
      NUMBER = NUMBER+1
      IBEGIN(NUMBER+1) = J+N
      GOTO 10
   90 CLOSE(105)
      RETURN
  900 CALL RCSTOP('the file cannot be read:', 'roughcontact.laws')
  910 CALL RCSTOP('a line of roughcontact.laws is not'
     1     //' NAME FILE MU NU K1 K2 LENGTH FORCE:', LINE(1:80))
  920 CALL RCSTOP('the file is no table of a law:', FILE(1:80))
      END
C
      SUBROUTINE RCUPPR(NAME)
      CHARACTER*(*) NAME
      DO 10 I = 1, LEN(NAME)
        IF (NAME(I:I).GE.'a' .AND. NAME(I:I).LE.'z')
     1     NAME(I:I) = CHAR(ICHAR(NAME(I:I))-32)
   10 CONTINUE
      END
C
C     Ends the job with a message.
      SUBROUTINE RCSTOP(WHAT, WHICH)
      INCLUDE 'ABA_PARAM.INC'
      CHARACTER*(*) WHAT, WHICH
      CHARACTER*8 TEXTS(1)
      DIMENSION INTV(1), REALV(1)
      CALL STDB_ABQERR(-3, 'roughcontact: '//WHAT//' '//WHICH, INTV,
     1     REALV, TEXTS)
      CALL XIT
      END
C
C     Which law an interaction has.
      INTEGER FUNCTION LAWOF(CINAME)
      INCLUDE 'ABA_PARAM.INC'
      PARAMETER (MOST=64, MNUM=1000000)
      CHARACTER*80 NAMES(MOST), CINAME, NAME
      DOUBLE PRECISION TABLE(MNUM), FACTS(6,MOST)
      COMMON /RCTABS/ TABLE, FACTS, NUMBER, IBEGIN(MOST+1)
      COMMON /RCNAME/ NAMES
      NAME = CINAME
      CALL RCUPPR(NAME)
      DO 10 LAWOF = 1, NUMBER
        IF (NAMES(LAWOF).EQ.NAME) RETURN
   10 CONTINUE
      CALL RCSTOP('roughcontact.laws has no law of the interaction',
     1     CINAME)
      END
C
C     Conductance at a pressure, and its derivative by the pressure;
C     both 0 without conductivities.
      SUBROUTINE RCHEAT(LAW, P, H, DHDP)
      INCLUDE 'ABA_PARAM.INC'
      PARAMETER (MOST=64, MNUM=1000000)
      DOUBLE PRECISION TABLE(MNUM), FACTS(6,MOST), Q, X, SLOPE, MORE,
     1     PMORE, ENERGY, UNIT
      COMMON /RCTABS/ TABLE, FACTS, NUMBER, IBEGIN(MOST+1)
      H = 0
      DHDP = 0
      IF (MIN(FACTS(3,LAW),FACTS(4,LAW)).LE.0 .OR. P.LE.0) RETURN
      J = IBEGIN(LAW)
      UNIT = FACTS(6,LAW)/FACTS(5,LAW)**2
      Q = P/UNIT
      CALL RCLAWX(TABLE(J), Q, X, ISTAT)
      IF (ISTAT.GE.0) CALL RCLAWS(TABLE(J), Q, SLOPE, ISTAT)
      IF (ISTAT.GE.0) CALL RCLAWP(TABLE(J), X*(1+1D-6), PMORE, MORE,
     1     ENERGY, ISTAT)
      IF (ISTAT.LT.0) CALL RCSTOP('the contact pressure is NaN', ' ')
      H = TABLE(J+3)/FACTS(5,LAW)/(1/FACTS(3,LAW)+1/FACTS(4,LAW))
      IF (PMORE.GT.Q) DHDP = H*(MORE-SLOPE)/(PMORE-Q)/UNIT
      H = H*SLOPE
      END
C
C     What UINTER has to define. STATEV are the 64 numbers of table.c's
C     slip, in units of the table.
      SUBROUTINE RCINTR(STRESS,DDSDDR,FLUX,DDFDDT,DDFDDR,STATEV,SED,
     1     SFD,RDISP,DRDISP,TEMP,CINAME,DROT,NDIR,NSTATV,LINPER,
     2     LOPENCLOSE)
      INCLUDE 'ABA_PARAM.INC'
      PARAMETER (MOST=64, MNUM=1000000, NSTATE=64)
      CHARACTER*80 CINAME
      DIMENSION STRESS(NDIR), DDSDDR(NDIR,NDIR), FLUX(2), DDFDDT(2,2),
     1     DDFDDR(2,NDIR), STATEV(NSTATV), RDISP(NDIR), DRDISP(NDIR),
     2     TEMP(2), DROT(2,2)
      DOUBLE PRECISION TABLE(MNUM), FACTS(6,MOST), STATE(NSTATE),
     1     SLIP(2), FORCES(10), X, P, SLOPE, ENERGY, UNIT, D(2)
      COMMON /RCTABS/ TABLE, FACTS, NUMBER, IBEGIN(MOST+1)
      IF (NSTATV.LT.NSTATE) CALL RCSTOP('*SURFACE INTERACTION needs'
     1     //' DEPVAR=64:', CINAME)
      LAW = LAWOF(CINAME)
      J = IBEGIN(LAW)
      UNIT = FACTS(6,LAW)/FACTS(5,LAW)**2
C     Shares of the layers turn with the surface.
      DO 10 K = 1, NINT(STATEV(2))
        IF (NDIR.LT.3) GOTO 10
        I = 4+5*K
        D(1) = DROT(1,1)*STATEV(I-1)+DROT(1,2)*STATEV(I)
        D(2) = DROT(2,1)*STATEV(I-1)+DROT(2,2)*STATEV(I)
        STATEV(I-1) = D(1)
        STATEV(I) = D(2)
   10 CONTINUE
      DO 20 I = 1, NSTATE
        STATE(I) = STATEV(I)
   20 CONTINUE
      OLD = (RDISP(1)-DRDISP(1))/FACTS(5,LAW)
      IF (NINT(STATE(2)).EQ.0) STATE(1) = MIN(OLD,0D0)
C     A perturbation: the tangent at the base state.
      X = RDISP(1)/FACTS(5,LAW)
      IF (LINPER.EQ.1) X = STATEV(1)
      DO 30 I = 1, 2
        SLIP(I) = 0
        IF (I.LT.NDIR .AND. LINPER.NE.1)
     1     SLIP(I) = DRDISP(I+1)/FACTS(5,LAW)
   30 CONTINUE
      CALL RCLAWQ(TABLE(J), FACTS(1,LAW), FACTS(2,LAW), STATE, X, SLIP,
     1     STATE, FORCES, ISTAT)
      IF (ISTAT.LT.0) CALL RCSTOP('no slip follows from the law (has it'
     1     //' a hardness or a layer?), or a displacement is NaN:',
     2     CINAME)
      DO 50 I = 1, NDIR
        DDFDDR(1,I) = 0
        DDFDDR(2,I) = 0
        DO 40 K = 1, NDIR
          IF (I.EQ.1) THEN
            DDSDDR(I,K) = 0
            IF (K.EQ.1) DDSDDR(I,K) = FORCES(4)
          ELSE IF (K.EQ.1) THEN
            DDSDDR(I,K) = FORCES(I+3)
          ELSE
            DDSDDR(I,K) = FORCES(2*I+K+1)
          ENDIF
          DDSDDR(I,K) = DDSDDR(I,K)*UNIT/FACTS(5,LAW)
   40   CONTINUE
        STRESS(I) = FORCES(I)*UNIT
   50 CONTINUE
      IF (LINPER.EQ.1) THEN
        DO 70 I = 1, NDIR
          STRESS(I) = 0
          DO 60 K = 1, NDIR
            STRESS(I) = STRESS(I)+DDSDDR(I,K)*DRDISP(K)
   60     CONTINUE
   70   CONTINUE
        RETURN
      ENDIF
      CALL RCHEAT(LAW, STRESS(1), H, DHDP)
      FLUX(1) = H*(TEMP(2)-TEMP(1))
      FLUX(2) = -FLUX(1)
      DDFDDT(1,1) = H
      DDFDDT(1,2) = -H
      DDFDDT(2,1) = -H
      DDFDDT(2,2) = H
      DDFDDR(1,1) = DHDP*DDSDDR(1,1)*(TEMP(2)-TEMP(1))
      DDFDDR(2,1) = -DDFDDR(1,1)
      CALL RCLAWP(TABLE(J), X, P, SLOPE, ENERGY, ISTAT)
      SED = ENERGY*UNIT*FACTS(5,LAW)
      SFD = (STATE(3)-STATEV(3))*UNIT*FACTS(5,LAW)
      DO 80 I = 1, NSTATE
        STATEV(I) = STATE(I)
   80 CONTINUE
      LOPENCLOSE = 0
      IF (X.GT.0) LOPENCLOSE = 1
      END
