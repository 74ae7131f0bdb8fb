#include "platform/libraries.h"

#include <elf.h>
#include <link.h>
#include <stdlib.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cstring>

#include "platform/posix/system.h"

// The linker's name for the header of the file that this code is in.
extern "C" [[gnu::visibility("hidden")]] const ElfW(Ehdr) __ehdr_start;

namespace rc_platform {

const std::string_view library_suffix = ".so", own_library = "libroughcontact.so";

const char* trusted_environment(const char* name) { return secure_getenv(name); }

bool administers(gid_t) { return false; }

bool has_access_list(const std::string& path) { return getxattr(path.c_str(), "system.posix_acl_access", nullptr, 0) > 0; }

// The system's loader maps what the file header promises; touching a part that is missing would kill the process. That of musl
// takes files of other processors as well.
std::string flaw(int file, std::int64_t size, const std::string& path) {
  ElfW(Ehdr) header{};
  if (pread(file, &header, sizeof header, 0) != static_cast<ssize_t>(sizeof header) ||
      std::memcmp(header.e_ident, __ehdr_start.e_ident, EI_VERSION) != 0 || header.e_machine != __ehdr_start.e_machine ||
      header.e_type != ET_DYN || header.e_phentsize != sizeof(ElfW(Phdr)))
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
bool loads_plugins() {
  bool has_loader = false;
  const auto look = [](dl_phdr_info* program, std::size_t, void* found) {
    for (int i = 0; i < program->dlpi_phnum; ++i)
      if (program->dlpi_phdr[i].p_type == PT_INTERP) *static_cast<bool*>(found) = true;
    return 1;  // the program itself comes first
  };
  dl_iterate_phdr(look, &has_loader);
  return has_loader;
}

}  // namespace rc_platform
