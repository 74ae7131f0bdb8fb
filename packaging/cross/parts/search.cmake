# Libraries are looked for below CMAKE_FIND_ROOT_PATH alone, but for Eigen, which is headers.
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(Eigen3_DIR /usr/share/eigen3/cmake)
