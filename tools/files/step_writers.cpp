#include "files/step_writers.h"

#include <filesystem>

#include "formats/error.h"
#include "formats/numbers.h"
#include "platform/files.h"
#include "platform/libraries.h"
#include "platform/process.h"
#include "request/choices.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

// NetCDF's library brings dozens of others, which take some 40 ms to load: only a run that writes such files does.
StepWriter loaded(std::string_view format) {
  const fs::path folder = rc_platform::path_of(rc_platform::own_program()).parent_path() / RC_LIBRARY_FROM_BIN / "roughcontact";
  const std::string file = "write-netcdf" + std::string(rc_platform::library_suffix);
  const rc_platform::OpenedPlugin module = rc_platform::open_plugin((folder / file).string());
  void* const found = module.code ? rc_platform::symbol_of(module.code, "rc_write_step") : nullptr;
  if (!found) {
    throw Error("--write: ", format, " was not built in (", module.error,
                "): build with the library of NetCDF (Debian: libnetcdf-dev), or give vti");
  }
  return reinterpret_cast<StepWriter>(found);
}

}  // namespace

StepWriters find_step_writers(std::string_view formats) {
  StepWriters found;
  for (const std::string_view format : split(formats, ',')) {
    const std::size_t k = choice("--write", format, step_formats);
    found.push_back({step_extensions[k], format == "vti" ? write_vti : loaded(format)});
  }
  return found;
}

}  // namespace cli
