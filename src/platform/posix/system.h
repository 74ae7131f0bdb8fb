// Functions that each system's folder defines for the files of this folder.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <string>

namespace rc_platform {

bool reach_disk(int descriptor);  // false with the cause in errno

// Takes a signal that this thread blocks if it is pending, so that it is not delivered. Does not wait for one.
void take_pending(int signal);

inline bool same_file(const struct stat& a, const struct stat& b) { return a.st_ino == b.st_ino && a.st_dev == b.st_dev; }

bool administers(gid_t group);                  // whether its members may become root
bool has_access_list(const std::string& path);  // beside the mode, in a form that the mode's bits for the group bound

// Why the system's loader should not see a plugin's file, as a whole sentence; "" if nothing speaks against it.
std::string flaw(int file, std::int64_t size, const std::string& path);

}  // namespace rc_platform
