// read_surfaces [--heights FILE] [--unit U] [--format NAME] [--remove FORM] [--fill] SURFACE...: reads surface files as the
// command does and prints one line for each, "ok FORMAT NX NY HX HY MISSING RMS" or "error MESSAGE". --heights writes those of
// the last as raw doubles. A crash ends it, so that many damaged files can be tried in one process.
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/surface.h"
#include "units.h"

namespace {

struct Settings {
  double unit = 1;
  std::optional<std::string> format, heights;
  cli::Form form = cli::Form::none;
  bool fill = false;
};

double rms(const cli::Surface& surface) {
  double sum = 0, squares = 0, count = 0, first = NAN;
  for (const double z : surface.heights) {
    if (std::isnan(z)) continue;
    if (std::isnan(first)) first = z;
    sum += z - first;
    squares += (z - first) * (z - first);
    ++count;
  }
  return std::sqrt(squares / count - sum / count * (sum / count));
}

void try_file(const std::string& path, const Settings& settings) {
  try {
    cli::Surface surface = cli::read_surface(path, settings.unit, settings.format);
    if (static_cast<std::size_t>(surface.nx * surface.ny) != surface.heights.size()) throw std::logic_error("wrong size");
    const auto missing = cli::count_missing(surface);
    cli::remove_form(settings.form, surface);
    if (settings.fill) {
      surface.hx = surface.hx.value_or(1);
      surface.hy = surface.hy.value_or(1);
      cli::fill_missing(surface);
    }
    std::printf("ok %s %lld %lld %.17g %.17g %lld %.17g %s\n", surface.format.c_str(), static_cast<long long>(surface.nx),
                static_cast<long long>(surface.ny), surface.hx.value_or(NAN), surface.hy.value_or(NAN),
                static_cast<long long>(missing), rms(surface), surface.note.c_str());
    if (!settings.heights) return;
    std::FILE* const file = std::fopen(settings.heights->c_str(), "wb");
    if (!file) throw std::logic_error("cannot write " + *settings.heights);
    std::fwrite(surface.heights.data(), sizeof(double), surface.heights.size(), file);
    std::fclose(file);
  } catch (const cli::Error& error) {
    std::printf("error %s\n", error.what());
  }
}

}  // namespace

// Whatever is not an Error, bad_alloc too, ends the program: a file's size must justify what is allocated for it.
int main(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--unit") {
      settings.unit = cli::metres_per(argv[++i]).value();
    } else if (word == "--format") {
      settings.format = argv[++i];
    } else if (word == "--heights") {
      settings.heights = argv[++i];
    } else if (word == "--remove") {
      settings.form = cli::parse_form(argv[++i]);
    } else if (word == "--fill") {
      settings.fill = true;
    } else {
      try_file(word, settings);
    }
  }
}
