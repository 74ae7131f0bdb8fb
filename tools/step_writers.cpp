#include "step_writers.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "choices.h"
#include "error.h"
#include "numbers.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

// Modules that have the writers; null: the command itself.
constexpr const char* modules[] = {nullptr, "write-netcdf.so", "write-hdf5.so"};

// The libraries of NetCDF and HDF5 bring dozens of others, which take some 40 ms to load: only a run that writes such files does.
StepWriter loaded(const char* name, std::string_view format) {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path() / RC_LIBRARY_FROM_BIN / "roughcontact";
  void* const module = dlopen((folder / name).c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const found = module ? dlsym(module, "rc_write_step") : nullptr;
  if (!found) {
    throw Error("--write: " + std::string(format) + " was not built in (" + dlerror() + "): build with its library (Debian: lib" +
                std::string(format) + "-dev), or give vti");
  }
  return reinterpret_cast<StepWriter>(found);
}

}  // namespace

StepWriters find_step_writers(std::string_view formats) {
  StepWriters found;
  for (const std::string_view format : split(formats, ',')) {
    const std::size_t k = choice("--write", format, step_formats);
    found.push_back({step_extensions[k], modules[k] ? loaded(modules[k], format) : write_vti});
  }
  return found;
}

}  // namespace cli
