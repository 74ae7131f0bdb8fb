if(VCPKG_LIBRARY_LINKAGE STREQUAL "static") # so are libzip and what it needs
  set(dependencies -DPKG_CONFIG_ARGN=--static)
endif()
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY) # backends are plugins
vcpkg_download_distfile(ARCHIVE
  URLS "@ARCHIVE@"
  FILENAME "roughcontact-${VERSION}.tar.gz"
  SHA512 @SHA512@
)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")
vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES formats RC_BUILD_FORMATS)
vcpkg_find_acquire_program(PKGCONFIG)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${FEATURE_OPTIONS}
    ${dependencies}
    "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}"
    -DRC_MODULE_BACKENDS=fft # without those under the GPL
    -DRC_BUILD_TESTS=OFF
    -DRC_BUILD_BENCH=OFF
    -DRC_BUILD_EXAMPLES=OFF
    -DRC_BUILD_TOOLS=OFF
    -DRC_BUILD_SURFACE=OFF
    -DRC_BUILD_MPI=OFF
    -DRC_BUILD_FLOW=OFF
    -DRC_CUDA=OFF
  MAYBE_UNUSED_VARIABLES PKG_CONFIG_ARGN PKG_CONFIG_EXECUTABLE
)
vcpkg_cmake_install()
file(GLOB static "${CURRENT_PACKAGES_DIR}/lib/*.a" "${CURRENT_PACKAGES_DIR}/debug/lib/*.a" "${CURRENT_PACKAGES_DIR}/lib/cmake/*/*static*"
  "${CURRENT_PACKAGES_DIR}/debug/lib/cmake/*/*static*")
list(FILTER static EXCLUDE REGEX "\\.dll\\.a$")
file(REMOVE ${static})
vcpkg_cmake_config_fixup(PACKAGE_NAME roughcontact CONFIG_PATH lib/cmake/roughcontact)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/lib/python3" "${CURRENT_PACKAGES_DIR}/debug/lib/python3")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
