// Cores that control groups grant, from trees of files as the system shows them.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "platform/cores.h"
#include "support/cmocka.hpp"

namespace {

using Files = std::map<std::string, std::string>;

long granted(const Files& files) {
  char folder[] = "/tmp/rc_cores_XXXXXX";
  assert_non_null(mkdtemp(folder));
  for (const auto& [name, text] : files) {
    const std::filesystem::path file = folder + name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  const long cores = static_cast<long>(rc_platform::granted_cores(folder));
  std::filesystem::remove_all(folder);
  return cores;
}

constexpr char second[] = "30 23 0:26 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n";
constexpr char first[] =
    "31 23 0:27 / /sys/fs/cgroup/cpuset rw shared:5 - cgroup cgroup rw,cpuset\n"
    "32 23 0:28 / /sys/fs/cgroup/cpu,cpuacct rw shared:6 - cgroup cgroup rw,cpu,cpuacct\n";

void version_2_limits_time(void**) {
  Files files{{"/proc/self/cgroup", "0::/\n"}, {"/proc/self/mountinfo", second}};
  assert_int_equal(granted(files), 0);  // no file of a limit
  for (const auto& [text, cores] : {std::pair{"max 100000\n", 0L},
                                    {"200000 100000\n", 2L},
                                    {"150000 100000\n", 2L},
                                    {"5000 100000\n", 1L},
                                    {"400000 50000\n", 8L},
                                    {"", 0L},
                                    {"0 100000\n", 0L},
                                    {"100000 0\n", 0L},
                                    {"x y\n", 0L}}) {
    files["/sys/fs/cgroup/cpu.max"] = text;
    assert_int_equal(granted(files), cores);
  }
}

void groups_above_count(void**) {
  Files files{{"/proc/self/cgroup", "0::/user.slice/job/step\n"},
              {"/proc/self/mountinfo", second},
              {"/sys/fs/cgroup/user.slice/cpu.max", "300000 100000\n"},
              {"/sys/fs/cgroup/user.slice/job/cpu.max", "max 100000\n"},
              {"/sys/fs/cgroup/user.slice/job/step/cpu.max", "700000 100000\n"}};
  assert_int_equal(granted(files), 3);
  files["/sys/fs/cgroup/user.slice/job/step/cpu.max"] = "200000 100000\n";
  assert_int_equal(granted(files), 2);
}

void version_1_limits_time(void**) {
  Files files{{"/proc/self/cgroup", "5:cpuset:/a\n4:cpu,cpuacct:/a/b\n1:name=systemd:/\n"},
              {"/proc/self/mountinfo", first},
              {"/sys/fs/cgroup/cpu,cpuacct/a/b/cpu.cfs_quota_us", "-1\n"},
              {"/sys/fs/cgroup/cpu,cpuacct/a/b/cpu.cfs_period_us", "100000\n"}};
  assert_int_equal(granted(files), 0);
  files["/sys/fs/cgroup/cpu,cpuacct/a/b/cpu.cfs_quota_us"] = "350000\n";
  assert_int_equal(granted(files), 4);
  files["/sys/fs/cgroup/cpu,cpuacct/a/cpu.cfs_quota_us"] = "100000\n";
  files["/sys/fs/cgroup/cpu,cpuacct/a/cpu.cfs_period_us"] = "100000\n";
  assert_int_equal(granted(files), 1);
}

// The group's name is the host's, and its folder is mounted as the root.
void containers_see_a_part_of_the_tree(void**) {
  const Files files{{"/proc/self/cgroup", "4:cpu,cpuacct:/docker/abc/in\n"},
                    {"/proc/self/mountinfo", "32 23 0:28 /docker/abc /sys/fs/cgroup/cpu ro - cgroup cgroup rw,cpu,cpuacct\n"},
                    {"/sys/fs/cgroup/cpu/cpu.cfs_quota_us", "200000\n"},
                    {"/sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n"}};
  assert_int_equal(granted(files), 2);
}

void a_system_without_groups_grants_all(void**) {
  assert_int_equal(granted({}), 0);
  assert_int_equal(granted({{"/proc/self/cgroup", "rubbish\n0:\n\n"}, {"/proc/self/mountinfo", "rubbish\n"}}), 0);
  assert_int_equal(granted({{"/proc/self/cgroup", "0::nowhere\n4:cpu:/docker/abcd\n"}, {"/proc/self/mountinfo", second}}), 0);
  assert_true(rc_platform::allowed_cores() >= 1);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(version_2_limits_time),
      cmocka_unit_test(groups_above_count),
      cmocka_unit_test(version_1_limits_time),
      cmocka_unit_test(containers_see_a_part_of_the_tree),
      cmocka_unit_test(a_system_without_groups_grants_all),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
