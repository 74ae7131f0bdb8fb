#include "solve/interrupt.h"

#include <atomic>

#include "platform/output.h"
#include "platform/terminal.h"

namespace cli {

namespace {

std::atomic<rc_contact*> watched{nullptr};
std::atomic<bool> interrupted{false};
std::int32_t stop = 0;
static_assert(std::atomic<rc_contact*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void on_signal(int number) {
  rc_contact* const contact = watched;
  if (contact && !interrupted.exchange(true)) {
    std::atomic_ref(stop).store(1);
    rc_contact_cancel(contact);
    return;
  }
  rc_platform::remove_unfinished_outputs();
  rc_platform::end_by(number);
}

}  // namespace

void handle_signals() { rc_platform::when_asked_to_end(on_signal); }

Interrupt::Interrupt(rc_contact* contact) { watched = contact; }

Interrupt::~Interrupt() { watched = nullptr; }

const std::int32_t* stop_flag() { return &stop; }

bool Interrupt::requested() const { return interrupted; }

}  // namespace cli
