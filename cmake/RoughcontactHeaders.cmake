# The standard library's headers are parsed four times for the whole project: with the flags of libraries and, if there are tests, of
# programs, each with this build's optimisation and, for what is not timed, with -O1. GCC takes no headers of other flags.
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON parses them in each file.
set(headers algorithm array atomic bit charconv chrono cmath cstdint cstdio cstdlib cstring exception filesystem functional limits map
  memory mutex new numbers numeric optional span sstream string string_view thread type_traits utility variant vector)
list(TRANSFORM headers REPLACE "(.+)" "$<$<COMPILE_LANGUAGE:CXX>:<\\1$<ANGLE-R>>")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers/library.cpp CONTENT "")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers/program.cpp CONTENT "int main() {}\n")
foreach(level IN ITEMS "" _O1)
  add_library(rc_library_headers${level} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/headers/library.cpp)
  add_executable(rc_program_headers${level} EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/headers/program.cpp)
  foreach(target IN ITEMS rc_library_headers${level} rc_program_headers${level})
    target_link_libraries(${target} PRIVATE rc_compile)
    target_precompile_headers(${target} PRIVATE ${headers})
    if(level)
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
  endforeach()
endforeach()

# rc_share_headers(<folder>): gives them to each target of this folder, and of the folders below it, whose sources are all C++ of the
# project's standard.
function(rc_share_headers folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    get_target_property(sources ${target} SOURCES)
    get_target_property(headers ${target} PRECOMPILE_HEADERS)
    get_target_property(standard ${target} CXX_STANDARD)
    get_target_property(options ${target} COMPILE_OPTIONS)
    set(from rc_library_headers)
    if(type STREQUAL EXECUTABLE)
      set(from rc_program_headers)
    endif()
    if("${options}" MATCHES "-O1")
      string(APPEND from _O1)
    endif()
    if(NOT headers AND standard STREQUAL CMAKE_CXX_STANDARD AND "${libraries}" MATCHES "rc_compile"
        AND "${sources}" MATCHES "\\.cpp" AND NOT "${sources}" MATCHES "\\.c(;|$)"
        AND (RC_BUILD_TESTS OR NOT type STREQUAL EXECUTABLE))
      set_target_properties(${target} PROPERTIES PRECOMPILE_HEADERS_REUSE_FROM ${from})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    rc_share_headers(${below})
  endforeach()
endfunction()
