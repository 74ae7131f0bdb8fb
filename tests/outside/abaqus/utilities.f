C     What Abaqus offers to user subroutines.
      SUBROUTINE GETOUTDIR(FOLDER, LENGTH)
      CHARACTER*256 FOLDER
      FOLDER = '.'
      LENGTH = 1
      END
C
      SUBROUTINE STDB_ABQERR(LOP, TEXT, INTV, REALV, CHARV)
      CHARACTER*(*) TEXT, CHARV(*)
      REAL*8 REALV(*)
      DIMENSION INTV(*)
      WRITE(*,'(2A)') '***ERROR: ', TEXT
      END
C
      SUBROUTINE XIT
      STOP 3
      END
