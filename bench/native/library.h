// What of the C interface is timed from here, with ownership and exceptions.
#pragma once

#include <roughcontact/plugin.h>
#include <roughcontact/roughcontact.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace bench {

inline rc_status check(rc_status status) {
  if (status < 0) throw std::runtime_error(std::string(rc_status_name(status)) + ": " + rc_last_error());
  return status;
}

template <class Handle, void (*destroy)(Handle*)> struct Destroy {
  void operator()(Handle* handle) const { destroy(handle); }
};
using Context = std::unique_ptr<rc_context, Destroy<rc_context, rc_context_destroy>>;
using Options = std::unique_ptr<rc_options, Destroy<rc_options, rc_options_destroy>>;
using Contact = std::unique_ptr<rc_contact, Destroy<rc_contact, rc_contact_destroy>>;

}  // namespace bench
