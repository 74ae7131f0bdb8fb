#include "core/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "core/error.h"
#include "platform/files.h"
#include "platform/output.h"

namespace rc {

namespace fs = std::filesystem;

std::string read_file(const char* path, std::string_view begins, std::uint64_t most) {
  const fs::path source = rc_platform::path_of(path);
  std::error_code error;
  const fs::file_status status = fs::status(source, error);
  if (status.type() == fs::file_type::none) fail(RC_ERR_ARGUMENT, path, ": cannot be read: ", error.message());
  if (!fs::exists(status)) fail(RC_ERR_ARGUMENT, path, ": cannot be read: there is no such file");
  if (!fs::is_regular_file(status))
    fail(RC_ERR_ARGUMENT, path, ": cannot be read: it is ", rc_platform::special_kind(status.type()), ", give a file");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{rc_platform::open_to_read(source), std::fclose};
  if (!file) fail(RC_ERR_ARGUMENT, path, ": cannot be read: ", std::strerror(errno));
  std::string bytes(begins.size(), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (bytes.empty()) fail(RC_ERR_ARGUMENT, path, ": cannot be read, or is empty");
  const std::uint64_t size = rc_platform::size_of(file.get());
  if (bytes != begins || size <= begins.size()) return bytes;
  if (size > most) fail(RC_ERR_ARGUMENT, path, ": has ", size, " bytes, more than the ", most, " that are read");
  bytes.resize(static_cast<std::size_t>(size));
  const std::size_t rest = bytes.size() - begins.size();
  if (std::fread(bytes.data() + begins.size(), 1, rest, file.get()) != rest)
    fail(RC_ERR_ARGUMENT, path, ": the file ended while it was read");
  return bytes;
}

void write_file(const char* path, std::string_view contents) {
  const std::string failure = rc_platform::write_output(rc_platform::path_of(path), contents);
  if (!failure.empty()) fail(RC_ERR_ARGUMENT, path, ": cannot be written: ", failure);
}

}  // namespace rc
