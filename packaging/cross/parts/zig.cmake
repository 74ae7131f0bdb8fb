# The compilers for the system that zig calls `target`.
set(zig ${CMAKE_CURRENT_LIST_DIR}/../../../build-cross/zig)
cmake_path(NORMAL_PATH zig)
if(NOT EXISTS ${zig}/${target}-ranlib)
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/zig.sh ${zig} ${target} COMMAND_ERROR_IS_FATAL ANY)
endif()
set(CMAKE_C_COMPILER ${zig}/${target}-cc)
set(CMAKE_CXX_COMPILER ${zig}/${target}-c++)
set(CMAKE_AR ${zig}/${target}-ar)
set(CMAKE_RANLIB ${zig}/${target}-ranlib)
set(CMAKE_Fortran_COMPILER "")  # zig has none
include(${CMAKE_CURRENT_LIST_DIR}/search.cmake)
