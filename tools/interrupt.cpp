#include "interrupt.h"

#include <atomic>
#include <csignal>

namespace cli {

namespace {

std::atomic<rc_contact*> watched{nullptr};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<rc_contact*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void on_signal(int) {
  interrupted = true;
  rc_contact_cancel(watched);
}

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt(rc_contact* contact) {
  watched = contact;
  set_handler(on_signal);
}

Interrupt::~Interrupt() {
  set_handler(SIG_DFL);
  watched = nullptr;
}

bool Interrupt::requested() const { return interrupted; }

}  // namespace cli
