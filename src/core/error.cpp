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

void raise_if_failed(rc_status status, const char* what) {
  if (status >= 0) return;
  if (message[0] != '\0') throw Error(status, message);
  throw Error(status, join(what, " failed with ", rc_status_name(status)));
}

}  // namespace rc
