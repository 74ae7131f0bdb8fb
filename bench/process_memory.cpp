#include "process_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <string>

namespace bench {

namespace {

struct Pages {
  double size = 0, resident = 0;
};

Pages pages() {
  Pages found;
  std::ifstream("/proc/self/statm") >> found.size >> found.resident;
  return found;
}

double page_bytes() { return static_cast<double>(sysconf(_SC_PAGESIZE)); }

}  // namespace

double resident_memory() { return page_bytes() * pages().resident; }

double available_memory() {
  std::ifstream info("/proc/meminfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("MemAvailable:")) return 1024 * std::stod(line.substr(line.find(':') + 1));
  return std::numeric_limits<double>::infinity();
}

void limit_growth(double bytes) {
  rlimit limit{};
  if (!(bytes < 1e18) || getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = static_cast<rlim_t>(page_bytes() * pages().size + bytes);
  setrlimit(RLIMIT_AS, &limit);
}

}  // namespace bench
