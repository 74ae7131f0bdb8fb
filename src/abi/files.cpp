// rc_file_write

#include "core/files.h"

#include <roughcontact/roughcontact.h>

#include "abi/guard.h"

using namespace rc;  // NOLINT: this file is the bridge

rc_status rc_file_write(const char* path, const void* data, size_t size) {
  return guard("rc_file_write", [&] {
    if (!path) fail(RC_ERR_ARGUMENT, "path is null");
    if (!data && size > 0) fail(RC_ERR_ARGUMENT, "data is null");
    write_file(path, {static_cast<const char*>(data), size});
    return RC_OK;
  });
}
