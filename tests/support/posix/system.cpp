#include "support/system.h"

#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

namespace support {

const char* const device = "/dev/null";
const char* const device_refused = "is a device";
const long machine_in_library = 18;  // ELF
const char* const needed_by_all = "libc.so";
const char* const folder_separator = ":";
const char* const writable_to_all = " is world-writable; chmod o-w it";
const char* const owned_by_another = " is owned by user 12345, neither root nor the current user 0";

// Relative to a folder beside it, and to its parent.
std::vector<std::string> other_names(const std::string& path) {
  const std::string name = path.substr(path.rfind('/') + 1);
  return {name, "./" + name, name + "/../" + name, "~/" + name};
}

void let_everybody_write(const std::string& path) { chmod(path.c_str(), 0777); }

void let_owner_alone_write(const std::string& path) { chmod(path.c_str(), 0755); }

bool give_away(const std::string& path) { return geteuid() == 0 && chown(path.c_str(), 12345, 0) == 0; }

bool make_pipe(const std::string& path) { return mkfifo(path.c_str(), 0600) == 0; }

void set_variable(const char* name, const char* value) { value ? setenv(name, value, 1) : unsetenv(name); }

void* aligned_memory(std::size_t alignment, std::size_t bytes) { return aligned_alloc(alignment, bytes); }

void free_aligned(void* memory) { free(memory); }

void limit_process(std::size_t bytes, unsigned seconds) {
  const rlimit memory{bytes, bytes};
  if (bytes > 0) setrlimit(RLIMIT_AS, &memory);
  alarm(seconds);
}

void limit_processor_time(unsigned seconds) {
  const itimerval limit{{0, 0}, {static_cast<time_t>(seconds), 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

}  // namespace support
