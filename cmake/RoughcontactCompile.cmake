# Each target's files are compiled in batches, and a batch parses its headers once. Names of a file's own are therefore unique in
# their target. -DCMAKE_UNITY_BUILD=OFF compiles each file by itself.
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
endif()
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()

# rc_shared_sources(<variable> <file of src>...): sets the variable to the files' paths. src and the target of this folder both compile
# them. They stay outside of batches, so that a program which links both libraries statically takes one object of the two.
function(rc_shared_sources variable)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/src/)
  set_source_files_properties(${ARGN} DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${variable} ${ARGN} PARENT_SCOPE)
endfunction()

# One interface target with the warnings and sanitizers that all of our own code is compiled with.
add_library(rc_compile INTERFACE)
target_compile_definitions(rc_compile INTERFACE _FILE_OFFSET_BITS=64)  # files above 2 GiB on 32-bit systems, too
target_compile_options(rc_compile INTERFACE $<$<COMPILE_LANGUAGE:C,CXX>:-Wall;-Wextra;-Wpedantic;-Wshadow>
  $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow>  # by a neighbour file's constant
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:-Wno-subobject-linkage>  # GNU takes included files for headers
  $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Wno-missing-field-initializers>  # members that a designated initialiser leaves out are null
  # Wrong across inlined loops; for short strings and temporary arguments that are not kept.
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>
  $<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-dangling-reference;-Wno-stringop-overflow>
  $<$<AND:$<BOOL:${WIN32}>,$<COMPILE_LANGUAGE:C,CXX>>:-Wno-format>  # MinGW checks them as those of Microsoft's older functions, which it does not call
  $<$<AND:$<BOOL:${RC_WERROR}>,$<COMPILE_LANGUAGE:C,CXX>>:-Werror>)
# In another project's build without a build type and without flags of its own, our targets are optimised as in a release.
if(NOT PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  foreach(language IN ITEMS C CXX)
    if(NOT CMAKE_${language}_FLAGS MATCHES "(^| )-O")
      separate_arguments(release NATIVE_COMMAND "${CMAKE_${language}_FLAGS_RELEASE}")
      target_compile_options(rc_compile INTERFACE "$<$<COMPILE_LANGUAGE:${language}>:${release}>")
    endif()
  endforeach()
endif()
if(RC_SANITIZE)
  target_compile_options(rc_compile INTERFACE -fsanitize=${RC_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(rc_compile INTERFACE -fsanitize=${RC_SANITIZE})
  # Programs in C need the part of the runtime that the library in C++ calls.
  set(CMAKE_C_LINK_EXECUTABLE "${CMAKE_CXX_LINK_EXECUTABLE}")
endif()
if(RC_BUILD_FUZZERS)
  set(RC_FUZZING_ENGINE -fsanitize=fuzzer CACHE STRING "What links a fuzz target to its engine")
  if(RC_FUZZING_ENGINE STREQUAL -fsanitize=fuzzer)
    # Instrumentation that libFuzzer needs; other engines set theirs by the flags.
    target_compile_options(rc_compile INTERFACE -fsanitize=fuzzer-no-link)
  endif()
endif()
