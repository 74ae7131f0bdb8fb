// What the opaque handles hold.
#pragma once

#include <roughcontact/plugin.h>

#include <memory>

#include "contact/calls/contact.h"
#include "registry/context.h"
#include "registry/options_handle.h"

struct rc_context {
  std::shared_ptr<rc::Context> shared;
};

struct rc_contact {
  rc::Contact contact;
};

namespace rc {

inline const std::shared_ptr<Context>& context_of(rc_context* context) { return context ? context->shared : Context::standard(); }

}  // namespace rc
