C     Conductance of a rough interface in Abaqus/Standard against the
C     contact pressure, for *GAP CONDUCTANCE, USER beside pressures from
C     a table or from any other contact. roughcontact.laws says which
C     law an interaction has, see rough.f. Not to be combined with
C     uinter.f, which has the heat itself.
      INCLUDE 'rough.f'
C
      SUBROUTINE GAPCON(AK,D,FLOWM,TEMP,PREDEF,TIME,CINAME,SLNAME,
     1     MSNAME,COORDS,NOEL,NODE,NPRED,KSTEP,KINC)
      INCLUDE 'ABA_PARAM.INC'
      CHARACTER*80 CINAME, SLNAME, MSNAME
      DIMENSION AK(5), D(2), FLOWM(2), TEMP(2), PREDEF(2,*), TIME(2),
     1     COORDS(3)
      CALL RCHEAT(LAWOF(CINAME), D(2), AK(1), AK(3))
      RETURN
      END
