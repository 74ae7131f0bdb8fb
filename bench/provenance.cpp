#include "provenance.h"

#include <dlfcn.h>
#include <fftw3.h>
#include <roughcontact/roughcontact.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

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

// Fowler, Noll & Vo's hash of 64 bits.
std::string library_hash() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&rc_version), &info) == 0) return "unknown";
  const std::filesystem::path library = std::filesystem::canonical(info.dli_fname),
                              plugins = library.parent_path() / "roughcontact";
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(plugins))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(plugins))
      if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  files.push_back(library);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

Json provenance(std::int64_t threads) {
  int major = 0, minor = 0, patch = 0;
  rc_version(&major, &minor, &patch, nullptr);
  double load[1] = {-1};
  (void)getloadavg(load, 1);
  return {{"date", utc_date()},
          {"version", std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch)},
          {"commit", build_commit},
          {"library", library_hash()},
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
