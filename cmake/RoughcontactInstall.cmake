# rc_install_library(<target> <component> <package component>)
# Installs a library with the install component it belongs to, and with `development` the link to a shared one and the file by
# which find_package(roughcontact COMPONENTS <package component>) finds it.
function(rc_install_library target component export)
  install(TARGETS ${target} EXPORT roughcontact-${export}
    LIBRARY DESTINATION ${RC_LIBRARY_DIR} COMPONENT ${component} NAMELINK_COMPONENT development
    RUNTIME DESTINATION ${RC_LIBRARY_DIR} COMPONENT ${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT roughcontact-${export} NAMESPACE roughcontact:: FILE roughcontact-${export}.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/roughcontact COMPONENT development)
endfunction()
