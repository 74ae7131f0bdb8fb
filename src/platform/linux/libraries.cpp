#include "platform/libraries.h"

#include <dirent.h>
#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <memory>

namespace rc_platform {

const std::string_view library_suffix = ".so", own_library = "libroughcontact.so";
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

// What others can write to is not loaded; "" if only its owner can.
std::string distrust(const struct stat& info, const std::string& path) {
  if (info.st_mode & S_IWOTH) return "plugin refused: " + path + " is world-writable; chmod o-w it";
  if (info.st_uid != 0 && info.st_uid != geteuid())
    return "plugin refused: " + path + " is owned by user " + std::to_string(info.st_uid) +
           ", neither root nor the current user " + std::to_string(geteuid());
  return {};
}

// The system's loader maps what the file header promises; touching a part that is missing would kill the process.
std::string flaw(int file, std::int64_t size, const std::string& path) {
  ElfW(Ehdr) header{};
  if (pread(file, &header, sizeof header, 0) != static_cast<ssize_t>(sizeof header) ||
      std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_phentsize != sizeof(ElfW(Phdr)))
    return "plugin refused: " + path + " is not a shared object of this machine";
  for (int i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) segment{};
    const auto at = static_cast<off_t>(header.e_phoff + static_cast<std::size_t>(i) * sizeof segment);
    const bool known = pread(file, &segment, sizeof segment, at) == static_cast<ssize_t>(sizeof segment);
    const auto available = static_cast<std::uint64_t>(size);
    if (!known || segment.p_offset > available ||
        (segment.p_type != PT_GNU_STACK && segment.p_filesz > available - segment.p_offset))
      return "plugin refused: " + path + " is incomplete, it has only " + std::to_string(size) + " bytes; copy it again";
  }
  return {};
}

// Such a program names no dynamic loader; one that dlopen brings in later finds a half-made process.
bool program_is_static() {
  bool has_loader = false;
  const auto look = [](dl_phdr_info* program, std::size_t, void* found) {
    for (int i = 0; i < program->dlpi_phnum; ++i)
      if (program->dlpi_phdr[i].p_type == PT_INTERP) *static_cast<bool*>(found) = true;
    return 1;  // the program itself comes first
  };
  dl_iterate_phdr(look, &has_loader);
  return !has_loader;
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
  if (program_is_static())
    return "plugin " + path +
           " is not loaded: this program is linked statically (-static), where libraries that plugins need cannot run; link the "
           "C "
           "library dynamically, or build the backend into the library (RC_BUILTIN_BACKENDS)";
  return {};
}

}  // namespace

bool is_absolute(std::string_view path) { return path.starts_with('/'); }

const char* trusted_environment(const char* name) { return secure_getenv(name); }

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
  opened.code = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!opened.code) opened.error = "plugin " + path + " cannot be loaded: " + dlerror();
  return opened;
}

void* symbol_of(void* code, const char* name) { return dlsym(code, name); }

}  // namespace rc_platform
