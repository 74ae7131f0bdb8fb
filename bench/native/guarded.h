// Exceptions of C functions.
#pragma once

#include <exception>
#include <string>

namespace bench {

// Null, or why work failed, valid until the thread's next call.
template <class Work> const char* guarded(const Work& work) {
  thread_local std::string message;
  try {
    work();
    return nullptr;
  } catch (const std::exception& error) {
    message = error.what();
    return message.c_str();
  }
}

}  // namespace bench
