// SIGINT, SIGTERM and SIGHUP. While a contact is watched, the first one ends its running step through rc_contact_cancel, so that
// all that is complete stays whole. Otherwise, and at the second one, the process ends at once and removes the file it was
// writing.
#pragma once

#include <roughcontact/roughcontact.h>

namespace cli {

// Handles signals from here on. Those that the process was started to ignore stay ignored.
void handle_signals();

// Set to 1 by the first signal, as long as a contact is watched.
const std::int32_t* stop_flag();

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
