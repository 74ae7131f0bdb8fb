# FFTW in both precisions for a backend: RC_FFTW_LIBRARIES, RC_FFTW_INCLUDES.
find_package(PkgConfig REQUIRED)
pkg_check_modules(FFTW3 REQUIRED fftw3)
pkg_check_modules(FFTW3F REQUIRED fftw3f)
# These libraries hold the planners' locks and thread counts.
find_library(FFTW3_THREADS_LIBRARY fftw3_threads HINTS ${FFTW3_LIBRARY_DIRS} REQUIRED)
find_library(FFTW3F_THREADS_LIBRARY fftw3f_threads HINTS ${FFTW3F_LIBRARY_DIRS} REQUIRED)
set(RC_FFTW_LIBRARIES ${FFTW3_THREADS_LIBRARY} ${FFTW3F_THREADS_LIBRARY} ${FFTW3_LINK_LIBRARIES} ${FFTW3F_LINK_LIBRARIES})
set(RC_FFTW_INCLUDES ${FFTW3_INCLUDE_DIRS} ${FFTW3F_INCLUDE_DIRS})
