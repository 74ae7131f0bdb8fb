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

// The reason to refuse a file that others can write to; "" if only its owner can.
std::string distrust(const struct stat& info, const std::string& path) {
  if (info.st_mode & S_IWOTH) return "plugin refused: " + path + " is world-writable; chmod o-w it";
  if (info.st_uid != 0 && info.st_uid != geteuid())
    return "plugin refused: " + path + " is owned by user " + std::to_string(info.st_uid) +
           ", neither root nor the current user " + std::to_string(geteuid());
  return {};
}

// Why a plugin's file is not opened; "" if nothing speaks against it.
std::string obstacle(const std::string& path) {
  struct stat info {};
  const std::string directory = path.substr(0, path.rfind('/'));
  if (stat(directory.c_str(), &info) != 0) return "plugin directory " + directory + ": " + std::strerror(errno);
  if (std::string reason = distrust(info, directory); !reason.empty()) return reason;
  const File file{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};  // a pipe of that name must not block
  if (file.number < 0) return "plugin " + path + " cannot be opened: " + std::strerror(errno);
  if (fstat(file.number, &info) != 0 || !S_ISREG(info.st_mode)) return "plugin refused: " + path + " is not a regular file";
  if (std::string reason = distrust(info, path); !reason.empty()) return reason;
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

OpenedPlugin open_plugin(const std::string& path) {
  OpenedPlugin opened{nullptr, obstacle(path)};
  if (!opened.error.empty()) return opened;
  // Never closed. RTLD_NODELETE would also keep what dlopen began and gave up for lack of memory, where exceptions end the
  // program.
  opened.code = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!opened.code) opened.error = "plugin " + path + " cannot be loaded: " + dlerror();
  return opened;
}

void* symbol_of(void* code, const char* name) { return dlsym(code, name); }

}  // namespace rc_platform
