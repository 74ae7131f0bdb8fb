# The compilers for the system that zig calls `target`.
# Outside of the tree: zig builds its C++ library, a minute's work, once for each folder that it lies in.
if(DEFINED ENV{XDG_CACHE_HOME})
  set(zig $ENV{XDG_CACHE_HOME}/roughcontact/zig)
else()
  set(zig $ENV{HOME}/.cache/roughcontact/zig)
endif()
if(NOT EXISTS ${zig}/${target}-ranlib)
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/zig.sh ${zig} ${target} COMMAND_ERROR_IS_FATAL ANY)
endif()
set(CMAKE_C_COMPILER ${zig}/${target}-cc)
set(CMAKE_CXX_COMPILER ${zig}/${target}-c++)
set(CMAKE_AR ${zig}/${target}-ar)
set(CMAKE_RANLIB ${zig}/${target}-ranlib)
set(CMAKE_Fortran_COMPILER "")  # zig has none
include(${CMAKE_CURRENT_LIST_DIR}/search.cmake)
