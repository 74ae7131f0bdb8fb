# Linux on the processor CMAKE_SYSTEM_PROCESSOR, by Debian's cross compilers.
set(CMAKE_SYSTEM_NAME Linux)
set(host ${CMAKE_SYSTEM_PROCESSOR}-linux-gnu)
set(CMAKE_C_COMPILER ${host}-gcc)
set(CMAKE_CXX_COMPILER ${host}-g++)
set(CMAKE_Fortran_COMPILER ${host}-gfortran)
list(APPEND CMAKE_FIND_ROOT_PATH /usr/${host})
include(${CMAKE_CURRENT_LIST_DIR}/search.cmake)
# Each file carries the compiler's own libraries.
foreach(kind EXE SHARED MODULE)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "-static-libgcc -static-libstdc++")
endforeach()
