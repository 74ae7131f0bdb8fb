// The contents of the opaque handles.
#pragma once

#include <roughcontact/plugin.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "abi/guard.h"
#include "contact/calls/shared_contact.h"
#include "registry/context.h"
#include "registry/options_handle.h"

struct rc_context {
  std::shared_ptr<rc::Context> shared;
};

namespace rc {

// Admits one thread at a time.
class Entrance {
 public:
  bool try_enter() {
    std::thread::id nobody;
    return user_.compare_exchange_strong(nobody, std::this_thread::get_id(), std::memory_order_acquire);
  }
  void leave() { user_.store({}, std::memory_order_release); }
  // Whether this thread has entered: it is in a callback of the handle's.
  bool inside() const { return user_.load(std::memory_order_relaxed) == std::this_thread::get_id(); }

 private:
  std::atomic<std::thread::id> user_;  // none: the handle is free
};

}  // namespace rc

struct rc_contact {
  template <class Of, class... Given>
  explicit rc_contact(std::in_place_type_t<Of> of, Given&&... given) : contact(of, std::forward<Given>(given)...) {}

  std::variant<rc::Contact, rc::SharedContact> contact;
  rc::Entrance entrance = {};
  std::string explanation = {};  // as rc_contact_explain returned it
};

namespace rc {

// One thread at a time: a second thread gets an error instead of a race.
template <class Handle, class Body> rc_status exclusively(const char* where, Handle* handle, const char* name, const Body& body) {
  return guard(where, [&] {
    if (!handle) fail(RC_ERR_ARGUMENT, name, " is null");
    Entrance& entrance = handle->entrance;
    if (!entrance.try_enter()) fail(RC_ERR_BUSY, "the ", name, " is in use by another thread; make one ", name, " per thread");
    struct Leave {
      Entrance& entered;
      ~Leave() { entered.leave(); }
    } leave{entrance};
    return body(*handle);
  });
}

inline rc_options options_or_defaults(const rc_options* options) {
  return options ? *options : rc_options{Context::standard(), {}};
}

inline const std::shared_ptr<Context>& context_of(rc_context* context) { return context ? context->shared : Context::standard(); }

}  // namespace rc
