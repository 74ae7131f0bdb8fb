#include "planning.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>
#include <type_traits>

#include "common/fftw.h"
#include "failure.h"

namespace rc_fft {

using rc_common::Fftw;

namespace {

constexpr const char* advice = "; name a file that can be read and written, or leave fft.wisdom empty";

std::string reason(int error) { return std::generic_category().message(error); }

// False if there is no such file.
bool read(const std::string& path, std::string& contents) {
  struct stat about;
  if (stat(path.c_str(), &about) != 0) {
    if (errno == ENOENT) return false;
    const int error = errno;
    fail(RC_ERR_OPTION, "wisdom file \"", path, "\": ", reason(error), advice);
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (S_ISREG(about.st_mode) && in) contents.assign(std::istreambuf_iterator<char>(in), {});
  if (!S_ISREG(about.st_mode)) fail(RC_ERR_OPTION, "wisdom file \"", path, "\" is not a regular file", advice);
  if (!in) fail(RC_ERR_OPTION, "wisdom file \"", path, "\" cannot be read: ", reason(errno), advice);
  return true;
}

// Replaces the file whole or not at all: writes beside it under another name first.
void replace(const std::string& path, const std::string& contents) {
  std::string temporary = path + ".XXXXXX";
  const int descriptor = mkstemp(temporary.data());
  int error = descriptor < 0 ? errno : 0;
  if (error == 0) {
    close(descriptor);
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    out << contents;
    out.close();
    if (!out || std::rename(temporary.c_str(), path.c_str()) != 0) error = errno != 0 ? errno : EIO;
    if (error != 0) unlink(temporary.c_str());
  }
  if (error != 0) fail(RC_ERR_OPTION, "wisdom file \"", path, "\" cannot be written: ", reason(error), advice);
}

}  // namespace

Planning::Planning(const rc_host* host, const rc_options* options) {
  const std::string planning = roughcontact::option_text(host, options, "fft.planning");
  const bool deterministic = roughcontact::option_int(host, options, "deterministic") != 0;
  if (planning == "measure" && deterministic)
    fail(RC_ERR_OPTION, "fft.planning=measure takes plans by their time, so that the last bits differ from run to run, but ",
         "deterministic = 1; set deterministic=0 or fft.planning=estimate");
  effort_ = planning == "estimate" || deterministic ? FFTW_ESTIMATE : FFTW_MEASURE;
  const std::string path = roughcontact::option_text(host, options, "fft.wisdom");
  if (path.empty()) return;
  in_double_.path = path;
  in_float_.path = path + ".float";
}

template <class Real> Planning::File& Planning::file() {
  if constexpr (std::is_same_v<Real, double>)
    return in_double_;
  else
    return in_float_;
}

template <class Real> void Planning::recall() {
  File& kept = file<Real>();
  if (kept.path.empty() || kept.read) return;
  if (read(kept.path, kept.contents) && !Fftw<Real>::import_wisdom(kept.contents.c_str()))
    fail(RC_ERR_OPTION, "wisdom file \"", kept.path, "\" holds no wisdom of ", Fftw<Real>::version(), "; remove it",
         ", or name another one");
  kept.read = true;
}

template <class Real> void Planning::remember() {
  File& kept = file<Real>();
  if (kept.path.empty() || effort_ == FFTW_ESTIMATE) return;
  const std::unique_ptr<char, void (*)(void*)> wisdom(Fftw<Real>::export_wisdom(), std::free);
  if (!wisdom) throw std::bad_alloc();
  if (kept.contents == wisdom.get()) return;
  std::string contents = wisdom.get();
  replace(kept.path, contents);
  kept.contents = std::move(contents);
}

template void Planning::recall<double>();
template void Planning::recall<float>();
template void Planning::remember<double>();
template void Planning::remember<float>();

}  // namespace rc_fft
