#include "platform/threads.h"

// This system sends no signals to threads, and its threads are not cancelled.
namespace rc_platform {

SignalsBlocked::SignalsBlocked() {}
SignalsBlocked::~SignalsBlocked() {}

HostsCall::HostsCall() {}
HostsCall::~HostsCall() noexcept(false) {}

HostsTurn::HostsTurn() {}
HostsTurn::~HostsTurn() {}

void end_if_cancelled() {}

}  // namespace rc_platform
