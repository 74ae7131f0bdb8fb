// SIGINT, SIGTERM and SIGHUP. The first while a contact is watched ends its running step through rc_contact_cancel, so that
// whatever is finished stays whole; otherwise, and at the second, the process ends at once, without the file it was writing.
#pragma once

#include <roughcontact/roughcontact.h>

namespace cli {

// From here on. Signals that the process was started to ignore stay ignored.
void handle_signals();

// Watches a contact while it lives; at most one at a time. The contact must outlive it.
class Interrupt {
 public:
  explicit Interrupt(rc_contact* contact);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;
};

}  // namespace cli
