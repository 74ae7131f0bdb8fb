#include "files/folder_lock.h"

#include <cerrno>
#include <cstring>
#include <string>

#include "error.h"
#include "text.h"

namespace cli {

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / name) {
  using State = rc_platform::LockFile::State;
  const char* const cause = std::strerror(errno);
  const std::string where = "--out: folder " + in_quotes(folder.string());
  if (file_.state() == State::failed) throw Error(where + " cannot be locked: " + cause);
  if (file_.state() == State::not_supported)
    report(format("%s cannot be locked (%s): see to it that no other run writes into it", where.c_str(), cause));
  if (file_.state() == State::held_by_another)
    throw Error(where + " is being written to by " + (file_.holder().empty() ? "another process" : "process " + file_.holder()) +
                ": wait for its end, or give another folder");
}

}  // namespace cli
