// Errors inside the library: an exception that carries a status, turned into status and message at the ABI.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "core/text.h"

namespace rc {

// The components whose failure an error is, by name.
struct AtFault {
  std::string backend = {};  // that was at work; empty: no component has failed
  std::string solver = {};   // that has failed on this backend; empty: the backend has
};

class Error : public std::exception {
 public:
  Error(rc_status code, std::string message, AtFault at_fault = {})
      : code_(code), message_(std::move(message)), at_fault_(std::move(at_fault)) {}
  rc_status code() const { return code_; }
  const AtFault& at_fault() const { return at_fault_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  rc_status code_;
  std::string message_;
  AtFault at_fault_;
};

// An array that the system does not provide. Its message is formatted without memory.
class OutOfMemory : public std::bad_alloc {
 public:
  explicit OutOfMemory(std::size_t bytes) {
    std::snprintf(message_, sizeof message_, "out of memory: %zu bytes were asked for", bytes);
  }
  const char* what() const noexcept override { return message_; }

 private:
  char message_[64];
};

// fail(RC_ERR_SHAPE, "nx = ", nx, " must be >= 1")
[[noreturn]] inline void fail_with(rc_status code, std::initializer_list<TextPart> message) {
  throw Error(code, joined(message));
}
[[noreturn]] void fail(rc_status code, const auto&... parts) { fail_with(code, {TextPart(parts)...}); }

// The calling thread's message. Fixed storage, so that it works when memory has run out.
const char* last_message();
void set_message(const char* text);
void set_message(const char* where, const char* text);  // "where: text"; text may be last_message()
void clear_message();

// Whether the number is one of RC_OK, RC_STOP_*, RC_ERR_*.
bool is_status(rc_status status);

// Throws for a status < 0, with the message of the component's rc_host::fail, or else one that names the operation `what`.
void raise_if_failed(rc_status status, const char* what, const AtFault& at_fault = {});

}  // namespace rc
