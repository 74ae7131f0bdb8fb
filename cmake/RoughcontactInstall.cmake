# The folders are variables of this directory only if another project builds this one: its cache is its own.
get_cmake_property(cached CACHE_VARIABLES)
include(GNUInstallDirs)
if(NOT PROJECT_IS_TOP_LEVEL)
  get_cmake_property(names CACHE_VARIABLES)
  list(REMOVE_ITEM names ${cached})
  foreach(name IN LISTS names)
    set(value "${${name}}")
    unset(${name} CACHE)
    set(${name} "${value}")
  endforeach()
endif()

# rc_install(...): install(...), unless another project that builds this one asks for its own files only.
macro(rc_install)
  if(RC_INSTALL)
    install(${ARGN})
  endif()
endmacro()

# rc_install_library(<target> <component> <package component>)
# Installs a library with the install component it belongs to, and with `development` the link to a shared one and the file by
# which find_package(roughcontact COMPONENTS <package component>) finds it. A project that builds this one finds the library under
# the name that find_package gives it.
function(rc_install_library target component export)
  get_target_property(name ${target} EXPORT_NAME)
  if(NOT name)
    set(name ${target})
  endif()
  add_library(roughcontact::${name} ALIAS ${target})
  rc_install(TARGETS ${target} EXPORT roughcontact-${export}
    LIBRARY DESTINATION ${RC_LIBRARY_DIR} COMPONENT ${component} NAMELINK_COMPONENT development
    RUNTIME DESTINATION ${RC_LIBRARY_DIR} COMPONENT ${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  rc_install(EXPORT roughcontact-${export} NAMESPACE roughcontact:: FILE roughcontact-${export}.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/roughcontact COMPONENT development)
endfunction()
