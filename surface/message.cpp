#include <cstdio>

#include "guard.h"

namespace rc::surface {

namespace {
thread_local char message[1024] = "";
}

const char* last_message() { return message; }
void set_message(const char* where, const char* text) { std::snprintf(message, sizeof message, "%s: %s", where, text); }
void clear_message() { message[0] = '\0'; }

}  // namespace rc::surface
