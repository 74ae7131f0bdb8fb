// Control groups of both versions: /proc/self/cgroup names this process's groups, /proc/self/mountinfo where the trees of groups
// are mounted. A limit holds for a group and all below it, so the groups above count as well.
#include "platform/cores.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

namespace rc_platform {

namespace {

struct Mount {
  std::string root, place;  // the group that is mounted, and where
};

bool lists(const std::string& words, const std::string& word) {
  return (',' + words + ',').find(',' + word + ',') != std::string::npos;
}

// Finds the mount of the tree of groups that has the limits of processor time: the only tree of version 2, or that of the
// controller "cpu" of version 1.
bool find_mount(const std::string& root, bool second, Mount& mount) {
  std::ifstream file(root + "/proc/self/mountinfo");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string skipped, kind, source, options;
    words >> skipped >> skipped >> skipped >> mount.root >> mount.place;
    while (words >> skipped && skipped != "-") {
    }
    words >> kind >> source >> options;
    if (second ? kind == "cgroup2" : kind == "cgroup" && lists(options, "cpu")) return true;
  }
  return false;
}

// Cores' worth of time in the files of one group; 0: no limit.
double limit_of(const std::string& group, bool second) {
  std::string quota, period = "100000";
  if (second) {
    std::ifstream(group + "/cpu.max") >> quota >> period;
  } else {
    std::ifstream(group + "/cpu.cfs_quota_us") >> quota;
    std::ifstream(group + "/cpu.cfs_period_us") >> period;
  }
  double used = 0, of = 0;
  if (!(std::istringstream(quota) >> used) || !(std::istringstream(period) >> of)) return 0;  // "max", or no such file
  return used > 0 && of > 0 ? used / of : 0;
}

double least_limit(const std::string& root, std::string group, bool second) {
  Mount mount;
  if (!find_mount(root, second, mount)) return 0;
  // Only the part of the tree below the mounted group is seen here.
  if (mount.root != "/" && (group + '/').starts_with(mount.root + '/')) group.erase(0, mount.root.size());
  double least = 0;
  for (;;) {
    const double limit = limit_of(root + mount.place + group, second);
    if (limit > 0 && (least == 0 || limit < least)) least = limit;
    if (group.empty() || group == "/") return least;
    group.erase(std::min(group.find_last_of('/'), group.size() - 1));
  }
}

}  // namespace

std::int64_t allowed_cores() {
  for (std::size_t cores = 1024; cores <= 1048576; cores *= 4) {  // the system refuses a set that is smaller than its own
    std::vector<cpu_set_t> set(cores / (8 * sizeof(cpu_set_t)));
    const std::size_t bytes = set.size() * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, set.data()) == 0) return std::max(1, CPU_COUNT_S(bytes, set.data()));
  }
  return std::max<std::int64_t>(1, std::thread::hardware_concurrency());
}

std::int64_t granted_cores(const std::string& root) {
  std::ifstream file(root + "/proc/self/cgroup");
  double least = 0;
  for (std::string line; std::getline(file, line);) {  // "4:cpu,cpuacct:/group", or "0::/group" of version 2
    const auto first = line.find(':'), last = first == std::string::npos ? first : line.find(':', first + 1);
    if (last == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, last - first - 1);
    const bool second = controllers.empty();
    if (!second && !lists(controllers, "cpu")) continue;
    const double limit = least_limit(root, line.substr(last + 1), second);
    if (limit > 0 && (least == 0 || limit < least)) least = limit;
  }
  return static_cast<std::int64_t>(std::ceil(std::min(least, 1e9)));
}

}  // namespace rc_platform
