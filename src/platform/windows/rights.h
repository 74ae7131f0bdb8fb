// Whom Windows lets write to a file, and whether that is somebody to be trusted with a plugin.
#pragma once

#include <windows.h>

#include <string>

namespace rc_platform {

struct FileRights {
  PSID owner = nullptr;
  PACL list = nullptr;  // null: everybody may do everything
};

// Why nothing is loaded from `path`, as a whole sentence; "" if it belongs to `user`, the system or its administrators, and
// nobody else can write to it.
std::string distrust(const std::string& path, const FileRights& rights, PSID user);

}  // namespace rc_platform
