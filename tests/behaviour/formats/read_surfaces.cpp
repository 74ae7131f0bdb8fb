// read_surfaces [--heights FILE] [--unit U] [--height-range H] [--format NAME] [--remove FORM] [--fill] SURFACE...: reads surface
// files by the library, from their path and from memory, and prints one line for each, "ok FORMAT NX NY HX HY MISSING ASSUMED" or
// "error MESSAGE". --heights writes those of the last as raw doubles. A crash ends it, so that many damaged files can be tried in
// one process.
#ifdef RC_READ_HDF5
#include <hdf5.h>
#endif
#include <roughcontact/formats.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace {

struct Settings {
  rc_surface_read_spec spec = RC_SURFACE_READ_SPEC_INIT;
  const char* heights = nullptr;
  std::int32_t form = 0;
  bool fill = false;
};

[[noreturn]] void stop(const char* what) {
  std::fprintf(stderr, "%s: %s\n", what, rc_surface_read_last_error());
  std::exit(1);
}

// Whatever is not the file's fault, lack of memory too, ends the program: a file's size must justify what is allocated for it.
void require_ok(rc_status status) {
  if (status != RC_OK) stop("failed");
}

std::size_t bytes_of(const rc_surface_file& file) { return static_cast<std::size_t>(file.nx * file.ny) * sizeof(double); }

std::string last_message() {
  const std::string_view message = rc_surface_read_last_error();
  return std::string(message.substr(message.find(": ") + 2));
}

// From memory the same comes out as from the path.
void require_same(const char* path, const Settings& settings, rc_status status, const rc_surface_file& file) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return;
  const std::string contents{std::istreambuf_iterator<char>(stream), {}}, message = status == RC_OK ? "" : last_message();
  rc_surface_file other = RC_SURFACE_FILE_INIT;
  if (rc_surface_read_memory(contents.data(), contents.size(), path, &settings.spec, &other) != status) stop("another status");
  if (status != RC_OK && last_message() != message) stop("another message");
  if (status == RC_OK) {
    const bool same = other.nx == file.nx && other.ny == file.ny && other.hx == file.hx && other.hy == file.hy &&
                      other.missing == file.missing && std::strcmp(other.format, file.format) == 0 &&
                      std::strcmp(other.assumed, file.assumed) == 0 &&
                      std::memcmp(other.heights, file.heights, bytes_of(file)) == 0;
    if (!same) stop("another surface");
  }
  rc_surface_file_free(&other);
}

void try_file(const char* path, const Settings& settings) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  const rc_status status = rc_surface_read(path, &settings.spec, &file);
  if (status != RC_OK && status != RC_ERR_ARGUMENT) require_ok(status);
  if (status != RC_OK) std::printf("error %s\n", last_message().c_str());
  require_same(path, settings, status, file);
  if (status != RC_OK) return;
  if (settings.form > 0) require_ok(rc_surface_remove_form(file.nx, file.ny, settings.form, file.heights));
  if (settings.fill)
    require_ok(rc_surface_fill(file.nx, file.ny, file.hx > 0 ? file.hx : 1, file.hy > 0 ? file.hy : 1, file.heights));
  const auto pitch = [](double h) { return h > 0 ? h : NAN; };
  std::printf("ok %s %lld %lld %.17g %.17g %lld %s%s\n", file.format, static_cast<long long>(file.nx),
              static_cast<long long>(file.ny), pitch(file.hx), pitch(file.hy), static_cast<long long>(file.missing), file.assumed,
              file.periodic < 0   ? ""
              : file.periodic > 0 ? " periodic"
                                  : " does not repeat");
  if (settings.heights) {
    std::FILE* const out = std::fopen(settings.heights, "wb");
    if (!out || std::fwrite(file.heights, 1, bytes_of(file), out) != bytes_of(file) || std::fclose(out) != 0)
      stop(settings.heights);
  }
  rc_surface_file_free(&file);
}

std::int32_t form_named(std::string_view name) {
  if (name == "none") return 0;
  return name == "mean" ? RC_SURFACE_FORM_MEAN : name == "plane" ? RC_SURFACE_FORM_PLANE : RC_SURFACE_FORM_QUADRIC;
}

}  // namespace

int main(int argc, char** argv) {
#ifdef RC_READ_HDF5
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // else libhdf5 prints at the end of a program that has read some damaged files
#endif
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--unit") {
      settings.spec.unit = argv[++i];
    } else if (word == "--height-range") {
      settings.spec.height_range = std::atof(argv[++i]);
    } else if (word == "--format") {
      settings.spec.format = argv[++i];
    } else if (word == "--heights") {
      settings.heights = argv[++i];
    } else if (word == "--remove") {
      settings.form = form_named(argv[++i]);
    } else if (word == "--fill") {
      settings.fill = true;
    } else {
      try_file(argv[i], settings);
    }
  }
}
