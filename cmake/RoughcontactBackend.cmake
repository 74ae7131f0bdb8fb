# rc_add_backend(<name> [COMMON] [FOR_TESTS] [COMPONENT component] SOURCES ... [LIBRARIES ...] [INCLUDES ...] [LINK ...])
# SOURCES: backend.cpp, which has the entry, and others.
# FOR_TESTS: a plugin that is installed only where its component is asked for, and built into RC_TEST_PLUGINS.
# COMMON: the backend uses backends/common. COMPONENT: its install component, backend-<name> by default. LINK: libraries that must
# be linked wherever the backend is (not those that are headers only).
# The sources are linked into the library if <name> is in RC_BUILTIN_BACKENDS (object library rcb_<name>, used by src/). Otherwise
# they become a plugin rcb_<name>.so beside the library, in roughcontact/abi-<n>, both in the build tree and after installation.
set(RC_TEST_PLUGINS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/test-plugins)
function(rc_add_backend name)
  cmake_parse_arguments(ARG "COMMON;FOR_TESTS" "COMPONENT" "SOURCES;LIBRARIES;INCLUDES;LINK" ${ARGN})
  if(NOT ARG_COMPONENT)
    set(ARG_COMPONENT backend-${name})
  endif()
  set_source_files_properties(backend.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(name IN_LIST RC_BUILTIN_BACKENDS)
    add_library(rcb_${name} OBJECT ${ARG_SOURCES})
    target_compile_definitions(rcb_${name} PRIVATE RC_PLUGIN_BUILTIN)
    set_target_properties(rcb_${name} PROPERTIES RC_LINK_LIBRARIES "${ARG_LINK}" RC_COMMON "${ARG_COMMON}")
  else()
    # All sources but the entry; tests link them, too.
    list(REMOVE_ITEM ARG_SOURCES backend.cpp)
    add_library(rcb_${name}_objects OBJECT ${ARG_SOURCES})
    target_include_directories(rcb_${name}_objects PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${ARG_INCLUDES}
      ${CMAKE_CURRENT_SOURCE_DIR})
    target_compile_options(rcb_${name}_objects PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)
    target_link_libraries(rcb_${name}_objects PRIVATE rc_compile PUBLIC ${ARG_LIBRARIES} ${ARG_LINK})
    add_library(rcb_${name} MODULE backend.cpp $<TARGET_OBJECTS:rcb_${name}_objects> $<TARGET_OBJECTS:rc_platform_memory>
      $<TARGET_OBJECTS:rc_platform_threads>)
    set(folder ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/roughcontact/abi-${RC_PLUGIN_ABI})
    set(unasked "")
    if(ARG_FOR_TESTS)
      set(folder ${RC_TEST_PLUGINS})
      set(unasked EXCLUDE_FROM_ALL)
    endif()
    set_target_properties(rcb_${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${folder})
    rc_install(TARGETS rcb_${name} LIBRARY DESTINATION ${RC_LIBRARY_DIR}/roughcontact/abi-${RC_PLUGIN_ABI}
      COMPONENT ${ARG_COMPONENT} ${unasked})
  endif()
  if(ARG_COMMON)
    if(NOT TARGET rc_backend_common)
      add_subdirectory(${PROJECT_SOURCE_DIR}/backends/common ${PROJECT_BINARY_DIR}/backends/common)
    endif()
    target_include_directories(rcb_${name} PRIVATE ${PROJECT_SOURCE_DIR}/backends)
    if(NOT name IN_LIST RC_BUILTIN_BACKENDS)
      target_include_directories(rcb_${name}_objects PUBLIC ${PROJECT_SOURCE_DIR}/backends)
      target_sources(rcb_${name} PRIVATE $<TARGET_OBJECTS:rc_backend_common>)
    endif()
  endif()
  target_include_directories(rcb_${name} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${ARG_INCLUDES})
  target_compile_options(rcb_${name} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)
  target_link_libraries(rcb_${name} PRIVATE rc_compile ${ARG_LIBRARIES} ${ARG_LINK})
endfunction()

# rc_link_backend(<target> <name>): the sources of a plugin, linked into a test that calls rc_builtin_<name>.
function(rc_link_backend target name)
  if(NOT TARGET rcb_${name}_objects)
    return()  # part of the library
  endif()
  if(NOT TARGET rcb_${name}_entry)
    add_library(rcb_${name}_entry OBJECT ${PROJECT_SOURCE_DIR}/backends/${name}/backend.cpp)
    target_compile_definitions(rcb_${name}_entry PRIVATE RC_PLUGIN_BUILTIN)
    target_link_libraries(rcb_${name}_entry PRIVATE rc_compile rcb_${name}_objects)
  endif()
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:rcb_${name}_entry> $<TARGET_OBJECTS:rcb_${name}_objects>)
  get_target_property(libraries rcb_${name} LINK_LIBRARIES)
  get_target_property(includes rcb_${name} INCLUDE_DIRECTORIES)
  target_link_libraries(${target} PRIVATE ${libraries})
  target_include_directories(${target} PRIVATE ${includes})
endfunction()
