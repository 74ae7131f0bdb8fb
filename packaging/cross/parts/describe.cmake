# Prints the settings of a toolchain file of this folder for the shell: cmake -DTOOLCHAIN=FILE -P describe.cmake
include(${TOOLCHAIN})
foreach(tool AR RANLIB)
  if(NOT CMAKE_${tool})
    string(TOLOWER ${tool} name)
    set(CMAKE_${tool} ${host}-${name})
  endif()
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -E echo
  "system='${CMAKE_SYSTEM_NAME}' host='${host}' cc='${CMAKE_C_COMPILER}' ar='${CMAKE_AR}' ranlib='${CMAKE_RANLIB}' fc='${CMAKE_Fortran_COMPILER}' wheel='${wheel}' emulator='${CMAKE_CROSSCOMPILING_EMULATOR}'")
