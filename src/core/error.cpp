#include "core/error.h"

#include <cstdio>
#include <cstring>

namespace rc {

namespace {
thread_local char message[1024] = "";
}

const char* last_message() { return message; }
void set_message(const char* text) { std::snprintf(message, sizeof message, "%s", text); }
void set_message(const char* where, const char* text) {
  char both[sizeof message];
  std::snprintf(both, sizeof both, "%s: %s", where, text);
  std::memcpy(message, both, sizeof message);
}
void clear_message() { message[0] = '\0'; }

bool is_status(rc_status status) {
  switch (status) {
#define RC_STATUS(name, value, text) case name:
#include "core/status.def"
#undef RC_STATUS
    return true;
    default:
      return false;
  }
}

void raise_if_failed(rc_status status, const char* what, const AtFault& at_fault) {
  if (!is_status(status) || status == RC_WITHIN_GOAL)
    throw Error(RC_ERR_INTERNAL, join(what, " returned ", status, ", which is not a status"));
  if (status >= 0) return;
  if (message[0] != '\0') throw Error(status, message, at_fault);
  throw Error(status, join(what, " failed with ", rc_status_name(status)), at_fault);
}

}  // namespace rc
