#include "platform/threads.h"

#include <pthread.h>
#include <signal.h>  // NOLINT: pthread_sigmask is of POSIX

#include <cstring>

namespace rc_platform {

namespace {

#ifdef __GNU_LIBRARY__  // this C library unwinds the stack of a cancelled thread
constexpr bool unwinds = true;
#else
constexpr bool unwinds = false;
#endif

thread_local bool cancellable = false;  // inside a call, of a host that may be cancelled

void allow(bool allowed) {
  int before = 0;
  pthread_setcancelstate(allowed ? PTHREAD_CANCEL_ENABLE : PTHREAD_CANCEL_DISABLE, &before);
}

}  // namespace

SignalsBlocked::SignalsBlocked() {
  static_assert(sizeof(sigset_t) <= sizeof before_);
  sigset_t all, before;
  sigfillset(&all);
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS, SIGPROF}) sigdelset(&all, own);
  sigemptyset(&before);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  std::memcpy(before_, &before, sizeof before);
}

SignalsBlocked::~SignalsBlocked() {
  sigset_t before;
  std::memcpy(&before, before_, sizeof before);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

HostsCall::HostsCall() : outer_(cancellable) {
  pthread_setcanceltype(PTHREAD_CANCEL_DEFERRED, &type_);
  pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &state_);
  cancellable = cancellable || state_ == PTHREAD_CANCEL_ENABLE;
}

HostsCall::~HostsCall() noexcept(false) {
  int before = 0;
  cancellable = outer_;
  pthread_setcancelstate(state_, &before);
  pthread_setcanceltype(type_, &before);
}

HostsTurn::HostsTurn() {
  if (unwinds && cancellable) allow(true);
}

HostsTurn::~HostsTurn() {
  if (unwinds && cancellable) allow(false);
}

void end_if_cancelled() {
  const HostsTurn turn;
  if (unwinds && cancellable) pthread_testcancel();
}

}  // namespace rc_platform
