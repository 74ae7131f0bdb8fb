// rc_status_*, rc_last_error, rc_stop_when, rc_version
#include "core/error.h"
#include "core/host_call.h"

namespace {

void give(std::int32_t* to, std::int32_t value) {
  if (to) *to = value;
}

}  // namespace

extern "C" {

const char* rc_status_name(rc_status status) {
  switch (status) {
#define RC_STATUS(name, value, text)                                    \
  static_assert(name == value, "status.def disagrees with the header"); \
  case name:                                                            \
    return #name;
#include "core/status.def"
#undef RC_STATUS
    default:
      return "RC_STATUS_UNKNOWN";
  }
}

const char* rc_status_text(rc_status status) {
  switch (status) {
#define RC_STATUS(name, value, text) \
  case name:                         \
    return text;
#include "core/status.def"
#undef RC_STATUS
    default:
      return "not a status of this library";
  }
}

const char* rc_last_error(void) { return rc::last_message(); }

void rc_stop_when(const int32_t* flag) { rc::stop_flag<rc::ContactLibrary> = flag; }

void rc_version(int32_t* major, int32_t* minor, int32_t* patch, int32_t* abi) {
  give(major, RC_VERSION_MAJOR);
  give(minor, RC_VERSION_MINOR);
  give(patch, RC_VERSION_PATCH);
  give(abi, RC_ABI);
}

}  // extern "C"
