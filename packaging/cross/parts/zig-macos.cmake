# zig makes no bundles; the loader takes a library as well.
set(CMAKE_SHARED_MODULE_CREATE_C_FLAGS -dynamiclib)
set(CMAKE_SHARED_MODULE_CREATE_CXX_FLAGS -dynamiclib)
