# Windows x86-64 by MinGW-w64 with POSIX threads.
set(host x86_64-w64-mingw32)
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(wheel win_amd64)
set(CMAKE_C_COMPILER ${host}-gcc-posix)
set(CMAKE_CXX_COMPILER ${host}-g++-posix)
set(CMAKE_Fortran_COMPILER ${host}-gfortran-posix)
set(CMAKE_RC_COMPILER ${host}-windres)
set(CMAKE_DLLTOOL ${host}-dlltool)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
list(APPEND CMAKE_FIND_ROOT_PATH /usr/${host})
include(${CMAKE_CURRENT_LIST_DIR}/parts/search.cmake)
# Windows aligns stacks to 16 bytes, and the compiler does not align its 32-byte variables there: the assembler makes every move of a
# vector one that needs no alignment.
set(flags "-D_WIN32_WINNT=0x0A00 -Wa,-muse-unaligned-vector-move")
set(CMAKE_C_FLAGS_INIT ${flags})
set(CMAKE_CXX_FLAGS_INIT ${flags})
# The compiler's own libraries go into each file: a program and libraries by other compilers need none of them.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
set(CMAKE_MODULE_LINKER_FLAGS_INIT -static)
