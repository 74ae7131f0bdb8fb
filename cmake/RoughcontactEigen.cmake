# rc_find_eigen(): Eigen 3.4 or later. No version is asked for: the files of Eigen 5 refuse a request for 3.4, those of 3.4.0 a range
# that reaches 5.
macro(rc_find_eigen)
  find_package(Eigen3 REQUIRED NO_MODULE)
  if(Eigen3_VERSION VERSION_LESS 3.4)
    message(FATAL_ERROR "Eigen ${Eigen3_VERSION} in ${Eigen3_DIR} is too old: 3.4 or later is needed (Debian: libeigen3-dev)")
  endif()
endmacro()
