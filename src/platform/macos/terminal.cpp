#include "platform/terminal.h"

#include <thread>

// Processes are not bound to cores here.
int rc_platform::usable_cores() { return static_cast<int>(std::thread::hardware_concurrency()); }
