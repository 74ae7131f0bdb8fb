# rc_add_backend(<name> SOURCES ... [LIBRARIES ...] [INCLUDES ...] [LINK ...])
# LINK: libraries that must be linked wherever the backend is (not those that are headers only).
# One source, two forms: linked into the library when <name> is in RC_BUILTIN_BACKENDS (object library rcb_<name>, used by src/),
# else a plugin rcb_<name>.so beside the library, in roughcontact/abi-<n>, found there in the build tree and after installation.
function(rc_add_backend name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;INCLUDES;LINK" ${ARGN})
  if(name IN_LIST RC_BUILTIN_BACKENDS)
    add_library(rcb_${name} OBJECT ${ARG_SOURCES})
    target_compile_definitions(rcb_${name} PRIVATE RC_PLUGIN_BUILTIN)
    set_target_properties(rcb_${name} PROPERTIES RC_LINK_LIBRARIES "${ARG_LINK}")
  else()
    add_library(rcb_${name} MODULE ${ARG_SOURCES})
    set_target_properties(rcb_${name} PROPERTIES PREFIX ""
      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/roughcontact/abi-${RC_PLUGIN_ABI})
    install(TARGETS rcb_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/roughcontact/abi-${RC_PLUGIN_ABI})
  endif()
  target_include_directories(rcb_${name} PRIVATE ${PROJECT_SOURCE_DIR}/include ${ARG_INCLUDES})
  target_compile_options(rcb_${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  target_link_libraries(rcb_${name} PRIVATE rc_compile ${ARG_LIBRARIES} ${ARG_LINK})
endfunction()
