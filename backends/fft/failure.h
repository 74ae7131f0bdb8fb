// Failures inside the backend: thrown, and turned into a status and a message at the vtable.
#pragma once

#include <roughcontact/plugin.h>

#include <locale>
#include <sstream>
#include <string>

namespace rc_fft {

struct Failure {
  rc_status code;
  std::string message;  // empty: the host has set it already
};

// fail(RC_ERR_MEMORY, "cannot allocate ", n, " bytes"); the same text in every locale.
template <class... Parts> [[noreturn]] void fail(rc_status code, const Parts&... parts) {
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // else the text would end silently where memory ran out
  out.imbue(std::locale::classic());
  out << "fft: ";
  (out << ... << parts);
  throw Failure{code, out.str()};
}

}  // namespace rc_fft
