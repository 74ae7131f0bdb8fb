#include "interrupt.h"

#include <atomic>
#include <csignal>

#include "whole_file.h"

namespace cli {

namespace {

std::atomic<rc_contact*> watched{nullptr};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<rc_contact*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void on_signal(int number) {
  rc_contact* const contact = watched;
  if (contact && !interrupted.exchange(true)) {
    rc_contact_cancel(contact);
    return;
  }
  remove_unfinished_file();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

void handle_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigaction(number, &action, nullptr);
  }
}

Interrupt::Interrupt(rc_contact* contact) { watched = contact; }

Interrupt::~Interrupt() { watched = nullptr; }

bool Interrupt::requested() const { return interrupted; }

}  // namespace cli
