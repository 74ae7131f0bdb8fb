// The threads of the library beside those of its host: signals and cancellation (pthread_cancel).
#pragma once

#include <cstdint>

namespace rc_platform {

// While it lives, all signals are blocked on the calling thread, and so they are on every thread that is started meanwhile, for
// that thread's life: the host's signals arrive on the host's threads. Signals that an instruction raises on its own thread, as
// SIGSEGV and SIGFPE, are not blocked.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  std::uint64_t before_[16] = {};  // the system's set of signals
};

// Guards a call of the host: while it lives, the calling thread is cancelled only in a HostsTurn and at end_if_cancelled(). The
// host's next cancellation point acts upon a cancellation that came meanwhile.
class HostsCall {
 public:
  HostsCall();
  ~HostsCall() noexcept(false);  // a host that allows cancellation at any time is cancelled here
  HostsCall(const HostsCall&) = delete;
  HostsCall& operator=(const HostsCall&) = delete;

 private:
  int state_ = 0, type_ = 0;
  bool outer_ = false;
};

// While it lives, a function of the host's runs inside such a call, and may be cancelled if the host allowed that before the
// call. A C library that ends a thread without its destructors would leave a contact in use for ever; with it nothing is
// cancelled here.
class HostsTurn {
 public:
  HostsTurn();
  ~HostsTurn();
  HostsTurn(const HostsTurn&) = delete;
  HostsTurn& operator=(const HostsTurn&) = delete;
};

// Ends the thread here if the host has cancelled it: its stack is unwound.
void end_if_cancelled();

}  // namespace rc_platform
