#include "provenance.h"

#include <fftw3.h>
#include <roughcontact/roughcontact.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#include "build_info.h"

namespace bench {

namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string utc_date() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

}  // namespace

Json provenance(std::int64_t threads) {
  int major = 0, minor = 0, patch = 0;
  rc_version(&major, &minor, &patch, nullptr);
  double load[1] = {-1};
  (void)getloadavg(load, 1);
  return {{"date", utc_date()},
          {"version", std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch)},
          {"commit", build_commit},
          {"compiler", build_compiler},
          {"build_type", build_type},
          {"flags", build_flags},
          {"fftw", std::string(fftw_version)},
          {"cpu", processor()},
          {"cpu_threads", std::thread::hardware_concurrency()},
          {"threads", threads},
          {"load_average_at_start", load[0]}};
}

}  // namespace bench
