# rc_install_library(<target> <component> <package component>)
# Installs a library with the install component it belongs to, and with `development` the link to a shared one and the file by
# which find_package(roughcontact COMPONENTS <package component>) finds it.
function(rc_install_library target component export)
  install(TARGETS ${target} EXPORT roughcontact-${export}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component} NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
  install(EXPORT roughcontact-${export} NAMESPACE roughcontact:: FILE roughcontact-${export}.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/roughcontact COMPONENT development)
endfunction()
