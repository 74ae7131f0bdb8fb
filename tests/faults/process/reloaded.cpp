// reloaded LIBRARY: opens the library, lists what its plugins bring, makes and destroys a context of its own and closes the
// library, a thousand times: the process must not grow.
#include <dlfcn.h>
#include <roughcontact/registry.h>

#include <cstdint>
#include <cstdio>

namespace {

long resident_kib() {
  long size = 0, resident = -1;
  std::FILE* const file = std::fopen("/proc/self/statm", "r");
  if (file && std::fscanf(file, "%ld %ld", &size, &resident) != 2) resident = -1;
  if (file) std::fclose(file);
  return 4 * resident;
}

bool once(const char* path) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!library) return false;
  const auto create = reinterpret_cast<decltype(&rc_context_create)>(dlsym(library, "rc_context_create"));
  const auto destroy = reinterpret_cast<decltype(&rc_context_destroy)>(dlsym(library, "rc_context_destroy"));
  const auto count = reinterpret_cast<decltype(&rc_component_count)>(dlsym(library, "rc_component_count"));
  rc_context* context = nullptr;
  if (!create || !destroy || !count || create(0, nullptr, nullptr, nullptr, &context) != RC_OK) return false;
  const std::int64_t found = count(context, RC_COMPONENT_BACKEND);
  destroy(context);
  return count(nullptr, RC_COMPONENT_BACKEND) == found && dlclose(library) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  long before = 0;
  for (int i = 0; i < 1000; ++i) {
    if (i == 100) before = resident_kib();
    if (argc != 2 || !once(argv[1])) return 2;
  }
  const long growth = resident_kib() - before;
  std::printf("%ld KiB more after 900 times\n", growth);
  return growth > 1024;
}
