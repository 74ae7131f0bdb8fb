# Linux on 32-bit x86. Programs run on x86-64.
set(CMAKE_SYSTEM_PROCESSOR i686)
set(CMAKE_CROSSCOMPILING_EMULATOR env)
include(${CMAKE_CURRENT_LIST_DIR}/parts/debian.cmake)
# Arithmetic in double precision as elsewhere, not in that of the x87.
foreach(language C CXX Fortran)
  set(CMAKE_${language}_FLAGS_INIT "-msse2 -mfpmath=sse")
endforeach()
