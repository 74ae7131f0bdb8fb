// HDF5 with a data set "surface". The reader ends as the others do, and libhdf5 is set as before.
#include <hdf5.h>

#include "formats/readers.h"
#include "reader.h"
#include "require.h"

// Over damaged headers libhdf5 itself leaks some bytes, and asks for memory that no machine has.
extern "C" [[gnu::used, gnu::visibility("default")]] const char* __asan_default_options() {
  return "detect_leaks=0:allocator_may_return_null=1";
}  // NOLINT

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  H5E_auto2_t handler = nullptr, left = nullptr;
  void *of_handler = nullptr, *of_left = nullptr;
  unsigned int loading = 0, loading_left = 0;
  H5PLset_loading_state(H5PL_ALL_PLUGIN);
  H5PLget_loading_state(&loading);
  H5Eget_auto2(H5E_DEFAULT, &handler, &of_handler);
  fuzz::check_reader(rc::formats::read_hdf5, fuzz::text(data, size));
  H5Eget_auto2(H5E_DEFAULT, &left, &of_left);
  H5PLget_loading_state(&loading_left);
  fuzz::require(left == handler && of_left == of_handler, "errors go to the host's handler");
  fuzz::require(loading_left == loading, "the host may load plugins as before");
  return 0;
}
