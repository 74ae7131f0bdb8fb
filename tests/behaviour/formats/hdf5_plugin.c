/* A filter that libhdf5 finds in HDF5_PLUGIN_PATH. Its code leaves a mark in the environment when it is loaded. */
#define _POSIX_C_SOURCE 200112L
#include <H5PLextern.h>
#include <stdlib.h>

__attribute__((constructor)) static void mark(void) { setenv("RC_HDF5_PLUGIN_RAN", "1", 1); }

static size_t same(unsigned flags, size_t count, const unsigned* values, size_t bytes, size_t* size, void** buffer) {
  (void)flags, (void)count, (void)values, (void)size, (void)buffer;
  return bytes;
}

static const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, 300, 1, 1, "probe", NULL, NULL, same};

__attribute__((visibility("default"))) H5PL_type_t H5PLget_plugin_type(void) { return H5PL_TYPE_FILTER; }
__attribute__((visibility("default"))) const void* H5PLget_plugin_info(void) { return &filter; }
