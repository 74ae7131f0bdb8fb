// Damaged plugins: the bytes become rcb_x.so in a folder of their own, and a context looks for it there by name and by listing.
// Files with the header of a loadable object are cut first, because the system's loader, which trusts what it maps, is not under
// test. So every file must be refused, with its name in the message, and the context must stay usable.
#include <elf.h>
#include <roughcontact/registry.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "require.h"

namespace {

namespace fs = std::filesystem;
using fuzz::require;

// In memory where there is such a folder; removed when the process ends.
struct Folder {
  std::string path;
  Folder() {
    path = fs::exists("/dev/shm") ? "/dev/shm/rc-fuzz-XXXXXX" : (fs::temp_directory_path() / "rc-fuzz-XXXXXX").string();
    require(mkdtemp(path.data()) != nullptr, "a folder can be made");
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

// An object that could be loaded loses its end, so that a segment lies outside of the file; or, without segments, its magic.
void make_harmless(std::string& file) {
  Elf64_Ehdr header{};
  if (file.size() < sizeof header) return;
  std::memcpy(&header, file.data(), sizeof header);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return;
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    const std::uint64_t at = header.e_phoff + i * sizeof segment;
    if (at > file.size() || file.size() - at < sizeof segment) return;
    std::memcpy(&segment, file.data() + at, sizeof segment);
    if (segment.p_offset > file.size() || (segment.p_type != PT_GNU_STACK && segment.p_filesz > file.size() - segment.p_offset))
      return;
  }
  file[0] = '\0';
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string path = folder.path + "/rcb_x.so";
  std::string file(reinterpret_cast<const char*>(data), size);
  make_harmless(file);
  std::ofstream(path, std::ios::binary).write(file.data(), static_cast<std::streamsize>(file.size()));
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read);

  rc_context* context = nullptr;
  require(rc_context_create(RC_CONTEXT_NO_ENVIRONMENT, folder.path.c_str(), nullptr, nullptr, &context) == RC_OK,
          "a context can be made");
  rc_options* options = nullptr;
  require(rc_options_create(context, &options) == RC_OK, "options can be made");
  require(rc_options_set_text(options, RC_OPT_BACKEND, "x") == RC_OK, "a name is taken");

  const double gap[] = {0, 1};
  double p[] = {7, 7};
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = 2;
  system.ny = 1;
  system.hx = system.hy = system.modulus = 1;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.undeformed_gap.data = gap;
  step.target = 0.5;
  rc_result result = RC_RESULT_INIT;
  result.p.data = p;
  require(rc_solve(&system, &step, options, &result) == RC_ERR_PLUGIN, "a damaged plugin is refused");
  require(std::strstr(rc_last_error(), "rcb_x.so") != nullptr, "the message names the file");
  require(p[0] == 7, "a failed call writes no pressure");
  require(rc_options_set_number(options, "x.key", 1) < 0, "a damaged plugin has no options");

  const std::int64_t count = rc_component_count(context, RC_COMPONENT_BACKEND);
  for (std::int64_t i = 0; i < count; ++i) {
    rc_component component{};
    component.struct_size = sizeof component;
    require(rc_component_describe(context, RC_COMPONENT_BACKEND, i, &component) == RC_OK && std::strcmp(component.name, "x") != 0,
            "it is not listed");
  }
  require(rc_options_set_text(options, RC_OPT_BACKEND, "dense") == RC_OK, "another name is taken");
  require(rc_solve(&system, &step, options, &result) == RC_OK, "the context stays usable");
  rc_options_destroy(options);
  rc_context_destroy(context);
  return 0;
}
