// Whether others than root and the user can change what is loaded from a path.
#pragma once

#include <sys/stat.h>

#include <string>

namespace rc_platform {

// Why nothing is loaded from `path`, an absolute one, as a whole sentence; "" if nothing speaks against it. Every folder on the
// way is looked at, from the root on and through links, before what it holds: what has been found stays so, unless root or the
// user change it.
std::string distrust(const std::string& path);

// The same for the file itself, from what is known of it when it is open.
std::string distrust(const std::string& path, const struct stat& file);

}  // namespace rc_platform
