// SIGINT and SIGTERM end the running step through rc_contact_cancel, so that whatever is finished stays whole.
#pragma once

#include <roughcontact/roughcontact.h>

namespace cli {

// Handles both signals while it lives; at most one at a time. The contact must outlive it.
class Interrupt {
 public:
  explicit Interrupt(rc_contact* contact);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;
};

}  // namespace cli
