#include "files/output_folder.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "files/outputs.h"
#include "formats/error.h"
#include "platform/files.h"
#include "platform/libraries.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* lock_name = ".roughcontact.lock";

}  // namespace

OutputFolder::OutputFolder(const fs::path& path) : path_(fs::absolute(path).lexically_normal()) {
  std::error_code error;
  for (fs::path missing = path_; !missing.empty() && !fs::exists(missing, error); missing = missing.parent_path()) {
    created_.push_back(missing);
  }
  fs::create_directories(path_, error);
  if (error) throw Error("--out: cannot create folder ", in_quotes(path.string()), ": ", error.message());
  if (!fs::is_directory(path_)) throw Error("--out: ", in_quotes(path.string()), " is not a folder");
  if (!rc_platform::may_write_into(path_)) {
    throw Error("--out: folder ", in_quotes(path.string()), " is not writable: ", std::strerror(errno));
  }
  refuse_special(lock_name);
  lock();
}

// If the file system has no locks, that is reported.
void OutputFolder::lock() {
  using State = rc_platform::LockFile::State;
  lock_.emplace(path_ / lock_name);
  const char* const cause = std::strerror(errno);
  const std::string where = "--out: folder " + in_quotes(path_.string());
  if (lock_->state() == State::failed) throw Error(where, " cannot be locked: ", cause);
  if (lock_->state() == State::not_supported)
    report(where + " cannot be locked (" + cause + "): see to it that no other run writes into it");
  if (lock_->state() == State::held_by_another)
    throw Error(where, " is being written to by ", lock_->holder().empty() ? "another process" : "process " + lock_->holder(),
                ": wait for its end, or give another folder");
}

OutputFolder::~OutputFolder() {
  lock_.reset();
  std::error_code ignored;  // a folder that is not empty stays
  for (const auto& folder : created_) fs::remove(folder, ignored);
}

void OutputFolder::write(const std::string& name, const std::function<bool(std::FILE*)>& fill) {
  write_output(path_ / name, fill);
}

void OutputFolder::refuse_special(const std::string& name) const {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_ / name, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status)) return;
  throw Error("--out: ", in_quotes((path_ / name).string()), " is no regular file: move it away, or give another folder");
}

std::string OutputFolder::read(const std::string& name) const {
  refuse_special(name);
  std::ifstream stream{path_ / name, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

std::vector<std::string> OutputFolder::names() const {
  // std::filesystem::directory_iterator ends the process where memory runs out.
  const std::u8string path = path_.u8string();
  std::vector<std::string> found = rc_platform::names_in({path.begin(), path.end()});  // "." and ".." at least
  if (found.empty()) throw Error("--out: cannot list folder ", in_quotes(path_.string()), ": ", std::strerror(errno));
  return found;
}

void OutputFolder::remove(const std::string& name) {
  std::error_code ignored;  // only tidies up
  fs::remove(path_ / name, ignored);
}

}  // namespace cli
