// Laws by name, one list for the process.
#pragma once

#include <roughcontact/law.h>

#include <functional>

namespace rc {

// The law of that name. The first call for a name makes it; if make throws, the name stays unknown. Laws live until the process
// ends.
const rc_law* named_law(const char* name, const std::function<rc_law*()>& make);

}  // namespace rc
