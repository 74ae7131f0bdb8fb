# The split into Debian packages, which packaging/build.sh makes. One rc_package() for each; those whose component this build does
# not install are left out.
set(CPACK_GENERATOR DEB)
set(CPACK_SOURCE_GENERATOR "")
set(CPACK_PACKAGE_NAME roughcontact)
# CPack's default, which it does not put before each package's own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${CMAKE_PROJECT_NAME} built using CMake")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
set(CPACK_DEBIAN_PACKAGE_SOURCE roughcontact)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish.cmake)
set(CPACK_RC_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_COMPONENTS_ALL "")

# Policy: a library's package says which package a program linked with it needs, and has the loader's cache renewed.
function(rc_shared_library package name)
  set(folder ${CMAKE_BINARY_DIR}/packaging/${package})
  file(WRITE ${folder}/shlibs "lib${name} ${RC_ABI} ${package} (>= ${PROJECT_VERSION})\n")
  file(WRITE ${folder}/triggers "activate-noawait ldconfig\n")
endfunction()

# rc_package(<package> COMPONENTS ... SUMMARY text DESCRIPTION line... [SECTION s] [ALL] [LIBRARY name] [NOTICES ...]
#            [DEPENDS ...] [RECOMMENDS ...] [SUGGESTS ...])
# ALL: the same on every architecture. LIBRARY: it has the shared library lib<name>, that others link. NOTICES: files of notices/, on
# what is inside or linked. DEPENDS: packages of this table are wanted in the same version; those of linked libraries are found.
include(CPackComponent)
get_cmake_property(rc_installed_components COMPONENTS)
macro(rc_package package)
  cmake_parse_arguments(RC "ALL" "SECTION;LIBRARY;SUMMARY" "COMPONENTS;NOTICES;DEPENDS;RECOMMENDS;SUGGESTS;DESCRIPTION" ${ARGN})
  set(rc_present TRUE)
  foreach(component IN LISTS RC_COMPONENTS)
    if(NOT component IN_LIST rc_installed_components)
      set(rc_present FALSE)
    endif()
  endforeach()
  if(rc_present)
    foreach(component IN LISTS RC_COMPONENTS)
      list(APPEND CPACK_COMPONENTS_ALL ${component})
      cpack_add_component(${component} GROUP ${package})
    endforeach()
    cpack_add_component_group(${package})
    string(TOUPPER ${package} key)
    list(TRANSFORM RC_DEPENDS REPLACE "^((lib)?roughcontact[^ ]*)$"
      "\\1 (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
    list(JOIN RC_DEPENDS ", " CPACK_DEBIAN_${key}_PACKAGE_DEPENDS)
    list(JOIN RC_RECOMMENDS ", " CPACK_DEBIAN_${key}_PACKAGE_RECOMMENDS)
    list(JOIN RC_SUGGESTS ", " CPACK_DEBIAN_${key}_PACKAGE_SUGGESTS)
    list(JOIN RC_DESCRIPTION "\n" text)
    set(CPACK_DEBIAN_${key}_DESCRIPTION "${RC_SUMMARY}\n${text}")
    set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package})
    set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${RC_SECTION})
    if(RC_ALL)
      set(CPACK_DEBIAN_${key}_PACKAGE_ARCHITECTURE all)
    endif()
    if(RC_LIBRARY)
      rc_shared_library(${package} ${RC_LIBRARY})
      set(CPACK_DEBIAN_${key}_PACKAGE_CONTROL_EXTRA
        "${CMAKE_BINARY_DIR}/packaging/${package}/shlibs;${CMAKE_BINARY_DIR}/packaging/${package}/triggers")
    endif()
    set(CPACK_RC_NOTICES_${package} ${RC_NOTICES})
  endif()
endmacro()

set(rc_about "roughcontact solves the normal contact of rough surfaces on an elastic"
  "half-space and checks answers by a product of its own.")

rc_package(libroughcontact0 COMPONENTS runtime SECTION libs LIBRARY roughcontact NOTICES eigen
  RECOMMENDS libroughcontact-backend-split
  SUMMARY "certified normal contact of rough surfaces - shared library"
  DESCRIPTION ${rc_about} "." "This package has the solver library, with the dense backend built in, and the plugin fft for large grids.")
rc_package(libroughcontact-surface0 COMPONENTS surface SECTION libs LIBRARY roughcontact-surface NOTICES gsl
  SUMMARY "makes and judges rough surfaces - shared library"
  DESCRIPTION ${rc_about} "." "This package has the library of generators, roughness parameters and spectra."
    "It links the GNU Scientific Library and is therefore under the GPL.")
rc_package(libroughcontact-formats0 COMPONENTS formats SECTION libs LIBRARY roughcontact-formats NOTICES eigen
  SUMMARY "reads surfaces from files of instruments - shared library"
  DESCRIPTION ${rc_about} "." "This package has the library that reads surface files: X3P, Digital Surf, SDF, PLu,"
    "Gwyddion's and NumPy's files, NetCDF and text.")
rc_package(libroughcontact-request0 COMPONENTS request SECTION libs LIBRARY roughcontact-request
  DEPENDS libroughcontact0 libroughcontact-formats0
  SUMMARY "turns words with units into contact problems - shared library"
  DESCRIPTION ${rc_about} "." "This package has the library that reads what users give: surfaces, materials and loads, as words with units.")
rc_package(libroughcontact-mpi0 COMPONENTS mpi SECTION libs LIBRARY roughcontact-mpi
  DEPENDS libroughcontact0
  SUMMARY "certified normal contact of rough surfaces - over MPI"
  DESCRIPTION ${rc_about} "." "This package has the library for contacts that the ranks of MPI share by rows.")
rc_package(roughcontact-mpi COMPONENTS mpi-tools SECTION science NOTICES gsl cli11 json
  DEPENDS libroughcontact0 libroughcontact-mpi0 RECOMMENDS mpi-default-bin
  SUMMARY "certified normal contact of rough surfaces - command over MPI"
  DESCRIPTION ${rc_about} "." "This package has the command roughcontact-mpi, which presses one surface on the ranks of MPI.")
rc_package(libroughcontact-flow0 COMPONENTS flow SECTION libs LIBRARY roughcontact-flow NOTICES suitesparse eigen
  DEPENDS libroughcontact0
  SUMMARY "leaks through the gaps of rough contacts - shared library"
  DESCRIPTION ${rc_about} "." "This package has the library that computes how much fluid leaks through a gap, with a"
    "proven interval. It links CHOLMOD and is therefore under the GPL.")
if(TARGET roughcontact_flow)
  set(flow libroughcontact-flow0)
endif()
rc_package(libroughcontact-dev COMPONENTS development fortran octave SECTION libdevel NOTICES eigen gsl
  DEPENDS libroughcontact0 libroughcontact-surface0 libroughcontact-formats0 libroughcontact-request0 ${flow}
  RECOMMENDS libgsl-dev libzip-dev libpugixml-dev zlib1g-dev SUGGESTS pkg-config gfortran octave-dev
  SUMMARY "certified normal contact of rough surfaces - development files"
  DESCRIPTION ${rc_about} "." "This package has headers, static libraries, pkg-config files, a CMake package"
    "and the sources of the Fortran modules and of rc_solve for Octave.")
rc_package(libroughcontact-backend-split COMPONENTS backend-split SECTION libs NOTICES fftw eigen
  DEPENDS libroughcontact0
  SUMMARY "certified normal contact of rough surfaces - split backend"
  DESCRIPTION ${rc_about} "." "This package has the plugin split, for sparse contact on large grids. It"
    "links FFTW and is therefore under the GPL.")
rc_package(libroughcontact-backend-cholmod COMPONENTS backend-cholmod SECTION libs NOTICES suitesparse eigen
  DEPENDS libroughcontact0
  SUMMARY "certified normal contact of rough surfaces - CHOLMOD backend"
  DESCRIPTION ${rc_about} "." "This package has the plugin cholmod, factorisations by SuiteSparse. It links"
    "CHOLMOD and is therefore under the GPL.")
rc_package(roughcontact-tools COMPONENTS tools SECTION science NOTICES gsl cli11 json
  DEPENDS libroughcontact0 libroughcontact-surface0 ${flow} RECOMMENDS libroughcontact-backend-split gnuplot-nox
  SUGGESTS libroughcontact-backend-cholmod python3-roughcontact
  SUMMARY "certified normal contact of rough surfaces - command"
  DESCRIPTION ${rc_about} "." "This package has the command roughcontact, which presses measured or generated"
    "surfaces, makes surfaces, and analyses them.")
rc_package(python3-roughcontact COMPONENTS python SECTION python ALL
  DEPENDS "libroughcontact0 (>= ${PROJECT_VERSION})" "libroughcontact-surface0 (>= ${PROJECT_VERSION})"
    "libroughcontact-formats0 (>= ${PROJECT_VERSION})" "libroughcontact-request0 (>= ${PROJECT_VERSION})" python3 python3-numpy
  RECOMMENDS libroughcontact-backend-split ${flow} SUGGESTS python3-matplotlib python3-pandas python3-xarray
  SUMMARY "certified normal contact of rough surfaces - Python module"
  DESCRIPTION ${rc_about} "." "This package has the Python module roughcontact.")

# Byte code is made when the package is configured, and goes with it.
set(CPACK_DEBIAN_PYTHON3-ROUGHCONTACT_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_LIST_DIR}/python/postinst;${CMAKE_CURRENT_LIST_DIR}/python/prerm")

include(CPack)
