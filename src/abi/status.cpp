#include <roughcontact/roughcontact.h>

extern "C" const char* rc_status_name(rc_status status) {
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

extern "C" const char* rc_status_text(rc_status status) {
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
