# What a toolchain file of this folder says, for the shell: cmake -DTOOLCHAIN=FILE -P describe.cmake
include(${TOOLCHAIN})
execute_process(COMMAND ${CMAKE_COMMAND} -E echo
  "system='${CMAKE_SYSTEM_NAME}' host='${host}' cc='${CMAKE_C_COMPILER}' emulator='${CMAKE_CROSSCOMPILING_EMULATOR}'")
