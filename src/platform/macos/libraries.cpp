#include "platform/libraries.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "platform/posix/system.h"

namespace rc_platform {

// CMake's name for what is opened while the program runs, and the number that its name of a library ends with.
const std::string_view library_suffix = ".so", own_library = "libroughcontact.";

const char* trusted_environment(const char* name) { return issetugid() ? nullptr : getenv(name); }

bool administers(gid_t group) { return group == 80; }  // admin, to which Homebrew's folders belong

bool has_access_list(const std::string&) { return false; }  // those of macOS stand apart from the mode

// dyld compares the segments with the size of the file itself, and refuses other machines' files with a sentence.
std::string flaw(int, std::int64_t, const std::string&) { return {}; }

bool loads_plugins() { return true; }  // every program has dyld

}  // namespace rc_platform
