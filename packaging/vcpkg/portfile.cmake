vcpkg_download_distfile(ARCHIVE
  URLS "@ARCHIVE@"
  FILENAME "roughcontact-${VERSION}.tar.gz"
  SHA512 @SHA512@
)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")
vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES formats RC_BUILD_FORMATS)

# Without plugins under the GPL; a static library has its backends built in.
if(VCPKG_LIBRARY_LINKAGE STREQUAL "static")
  set(backends "-DRC_BUILTIN_BACKENDS=dense;fft" "-DRC_MODULE_BACKENDS=")
else()
  set(backends -DRC_BUILTIN_BACKENDS=dense -DRC_MODULE_BACKENDS=fft)
endif()
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${FEATURE_OPTIONS}
    ${backends}
    -DRC_BUILD_TESTS=OFF
    -DRC_BUILD_BENCH=OFF
    -DRC_BUILD_EXAMPLES=OFF
    -DRC_BUILD_TOOLS=OFF
    -DRC_BUILD_SURFACE=OFF
    -DRC_BUILD_MPI=OFF
    -DRC_BUILD_FLOW=OFF
    -DRC_CUDA=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME roughcontact CONFIG_PATH lib/cmake/roughcontact)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
