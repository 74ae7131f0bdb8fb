#include "registry/loader.h"

#include <dirent.h>
#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "registry/context.h"

namespace rc {

namespace {

constexpr std::string_view prefix = "rcb_", suffix = ".so";

// Beside the shared library that holds this code, so that an installed tree can be moved; for a program that links the static
// library, the configured installation.
std::string installed_directory() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&is_component_name), &info) != 0 && info.dli_fname) {
    const std::string_view file = info.dli_fname;
    const std::size_t name = file.rfind('/') + 1;  // 0 if there is no directory
    char current[PATH_MAX] = "";
    const bool absolute = file.starts_with('/');
    if (file.substr(name).starts_with("libroughcontact.so") && (absolute || getcwd(current, sizeof current)))
      return join(current, absolute ? "" : "/", file.substr(0, name), RC_PLUGIN_SUBDIRECTORY);
  }
  return RC_INSTALLED_PLUGIN_DIRECTORY;
}

void append(std::vector<std::string>& directories, std::string_view path, const char* source, const Context& context) {
  for (const std::string& directory : split(path, ':')) {
    if (directory.starts_with('/'))
      directories.push_back(directory);
    else if (!directory.empty())
      context.log(RC_LOG_WARNING, join("plugin directory \"", directory, "\" from ", source, " ignored: it is not absolute"));
  }
}

// Not std::filesystem, whose iterators end the program when memory runs out.
struct Close {
  void operator()(DIR* directory) const { closedir(directory); }
};

// Code that others can write to is not loaded.
void check_owner(const struct stat& info, const std::string& path) {
  if (info.st_mode & S_IWOTH) fail(RC_ERR_PLUGIN, "plugin refused: ", path, " is world-writable; chmod o-w it");
  if (info.st_uid != 0 && info.st_uid != geteuid())
    fail(RC_ERR_PLUGIN, "plugin refused: ", path, " is owned by user ", info.st_uid, ", neither root nor the current user ",
         geteuid());
}

// The system's loader maps what the file header promises; touching a part that is missing would kill the process.
void check_complete(int file, std::int64_t size, const std::string& path) {
  ElfW(Ehdr) header{};
  if (pread(file, &header, sizeof header, 0) != static_cast<ssize_t>(sizeof header) ||
      std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_phentsize != sizeof(ElfW(Phdr)))
    fail(RC_ERR_PLUGIN, "plugin refused: ", path, " is not a shared object of this machine");
  for (int i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) segment{};
    const auto at = static_cast<off_t>(header.e_phoff + static_cast<std::size_t>(i) * sizeof segment);
    const bool known = pread(file, &segment, sizeof segment, at) == static_cast<ssize_t>(sizeof segment);
    const auto available = static_cast<std::uint64_t>(size);
    if (!known || segment.p_offset > available ||
        (segment.p_type != PT_GNU_STACK && segment.p_filesz > available - segment.p_offset))
      fail(RC_ERR_PLUGIN, "plugin refused: ", path, " is incomplete, it has only ", size, " bytes; copy it again");
  }
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

}  // namespace

bool is_component_name(std::string_view name) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && name.size() <= 31 && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

std::vector<std::string> plugin_directories(const ContextConfig& config, const Context& context) {
  std::vector<std::string> directories;
  append(directories, config.plugin_path, "the context's plugin_path", context);
  if (!(config.flags & RC_CONTEXT_NO_ENVIRONMENT))
    if (const char* path = secure_getenv("RC_PLUGIN_PATH")) append(directories, path, "RC_PLUGIN_PATH", context);
  append(directories, installed_directory(), "the installation", context);
  return directories;
}

std::string find_plugin(const std::vector<std::string>& directories, std::string_view name) {
  for (const std::string& directory : directories) {
    std::string path = join(directory, "/", prefix, name, suffix);
    if (access(path.c_str(), F_OK) == 0) return path;
  }
  return {};
}

std::vector<std::string> plugin_names(const std::vector<std::string>& directories) {
  std::vector<std::string> names;
  for (const std::string& directory : directories) {
    const std::unique_ptr<DIR, Close> entries(opendir(directory.c_str()));
    if (!entries) continue;
    while (const dirent* entry = readdir(entries.get())) {
      const std::string_view file = entry->d_name;
      if (!file.starts_with(prefix) || !file.ends_with(suffix) || file.size() <= prefix.size() + suffix.size()) continue;
      const std::string_view name = file.substr(prefix.size(), file.size() - prefix.size() - suffix.size());
      if (is_component_name(name)) names.emplace_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

const rc_plugin* load_plugin(const std::string& path, const std::string& name, const rc_host& host) {
  struct stat info {};
  const std::string directory = path.substr(0, path.rfind('/'));
  if (stat(directory.c_str(), &info) != 0) fail(RC_ERR_PLUGIN, "plugin directory ", directory, ": ", std::strerror(errno));
  check_owner(info, directory);
  const struct File {
    int number;
    ~File() {
      if (number >= 0) close(number);
    }
  } file{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};  // a pipe of that name must not block
  if (file.number < 0) fail(RC_ERR_PLUGIN, "plugin ", path, " cannot be opened: ", std::strerror(errno));
  if (fstat(file.number, &info) != 0 || !S_ISREG(info.st_mode))
    fail(RC_ERR_PLUGIN, "plugin refused: ", path, " is not a regular file");
  check_owner(info, path);
  check_complete(file.number, info.st_size, path);

  if (program_is_static())
    fail(RC_ERR_PLUGIN, "plugin ", path,
         " is not loaded: this program is linked statically (-static), where libraries that plugins ",
         "need cannot run; link the C library dynamically, or build the backend into the library (RC_BUILTIN_BACKENDS)");
  void* const code = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!code) fail(RC_ERR_PLUGIN, "plugin ", path, " cannot be loaded: ", dlerror());
  const auto query = reinterpret_cast<rc_plugin_query_fn>(dlsym(code, "rc_plugin_query"));
  if (!query) fail(RC_ERR_PLUGIN, "plugin refused: ", path, " does not export rc_plugin_query");
  const rc_plugin* plugin = nullptr;
  clear_message();
  if (const rc_status status = query(&host, &plugin); status < 0)
    fail(RC_ERR_PLUGIN, "plugin ", path,
         " refuses to be used: ", last_message()[0] != '\0' ? last_message() : rc_status_text(status));
  if (!plugin) fail(RC_ERR_PLUGIN, "plugin refused: ", path, " describes nothing");
  if (!plugin->name || name != plugin->name)
    fail(RC_ERR_PLUGIN, "plugin refused: ", path, " calls itself \"", plugin->name ? plugin->name : "", "\", not \"", name, "\"");
  return plugin;
}

}  // namespace rc
