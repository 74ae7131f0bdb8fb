// Whether others than root and the user can change what is loaded from a path.
#pragma once

#include <sys/stat.h>

#include <string>

namespace rc_platform {

// Why nothing is loaded from `path`, an absolute one, as a whole sentence; "" if nothing speaks against it. Checks every
// folder of the path from the root on, also through links, each before its entries: later only root or the user can change what
// was checked.
std::string distrust(const std::string& path);

// The same for the file itself, from its status once it is open.
std::string distrust(const std::string& path, const struct stat& file);

}  // namespace rc_platform
