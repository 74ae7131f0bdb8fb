#include "platform/libraries.h"

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstring>
#include <memory>
#include <utility>

#include "platform/posix/rights.h"
#include "platform/posix/system.h"

namespace rc_platform {

const char path_separator = ':';

namespace {

// Not std::filesystem, whose iterators end the program when memory runs out.
struct Close {
  void operator()(DIR* directory) const { closedir(directory); }
};

struct File {
  int number;
  ~File() {
    if (number >= 0) close(number);
  }
};

// Why a plugin's file is not loaded; "" if nothing speaks against it. Opens it.
std::string obstacle(const std::string& path, File& file, struct stat& info) {
  if (std::string reason = distrust(path); !reason.empty()) return reason;
  file.number = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe of that name must not block
  if (file.number < 0) return "plugin " + path + " cannot be opened: " + std::strerror(errno);
  if (fstat(file.number, &info) != 0 || !S_ISREG(info.st_mode)) return "plugin refused: " + path + " is not a regular file";
  if (std::string reason = distrust(path, info); !reason.empty()) return reason;
  if (std::string reason = flaw(file.number, info.st_size, path); !reason.empty()) return reason;
  if (!loads_plugins())
    return "plugin " + path +
           " is not loaded: this program is linked statically (-static), where libraries that plugins need cannot run; link the "
           "C "
           "library dynamically, or build the backend into the library (RC_BUILTIN_BACKENDS)";
  return {};
}

}  // namespace

bool is_absolute(std::string_view path) { return path.starts_with('/'); }

std::string file_of(const void* code) {
  Dl_info info{};
  if (dladdr(code, &info) == 0 || !info.dli_fname) return {};
  if (is_absolute(info.dli_fname)) return info.dli_fname;
  char current[PATH_MAX] = "";
  return getcwd(current, sizeof current) ? std::string(current) + "/" + info.dli_fname : std::string();
}

bool exists(const std::string& path) { return access(path.c_str(), F_OK) == 0; }

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  const std::unique_ptr<DIR, Close> entries(opendir(folder.c_str()));
  if (!entries) return names;
  while (const dirent* entry = readdir(entries.get())) names.emplace_back(entry->d_name);
  return names;
}

// By its path: under the name of an open file (/proc/self/fd), $ORIGIN would lead elsewhere, and the loader would take the next
// plugin with that number for this one. The file stays open, so that another one cannot have its number.
OpenedPlugin open_plugin(const std::string& path) {
  File file{-1};
  struct stat checked {
  }, loaded{};
  OpenedPlugin opened{nullptr, obstacle(path, file, checked)};
  if (!opened.error.empty()) return opened;
  // Never closed. RTLD_NODELETE would also keep what dlopen began and gave up for lack of memory, where exceptions end
  // the program.
  opened.code = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!opened.code) {
    opened.error = "plugin " + path + " cannot be loaded: " + dlerror();
  } else if (stat(path.c_str(), &loaded) != 0 || !same_file(checked, loaded)) {
    dlclose(std::exchange(opened.code, nullptr));  // else the next attempt would find it loaded under this name
    opened.error = "plugin refused: " + path + " was replaced while it was loaded; try again";
  }
  return opened;
}

void* symbol_of(void* code, const char* name) { return dlsym(code, name); }

}  // namespace rc_platform
