#include "files/outputs.h"

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "formats/error.h"
#include "platform/output.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

void refuse_if(const std::string& failure, const fs::path& path, const std::string& option = "") {
  if (!failure.empty()) throw Error(option, option.empty() ? "" : ": ", "cannot write ", in_quotes(path.string()), ": ", failure);
}

}  // namespace

void write_output(const fs::path& path, const std::function<bool(std::FILE*)>& fill) {
  std::fflush(stdout);  // if the output is the same stream, what was printed before comes first
  refuse_if(rc_platform::write_output(path, fill), path);
}

void write_output(const fs::path& path, const std::string& text) {
  write_output(path, [&](std::FILE* file) {
    std::fwrite(text.data(), 1, text.size(), file);
    return true;
  });
}

void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::pair<std::string, std::string>>& outputs) {
  std::error_code none;
  const auto whole_path = [&](const fs::path& file) { return fs::weakly_canonical(fs::absolute(file, none), none); };
  std::vector<fs::path> known;
  for (const std::string& name : inputs) known.push_back(whole_path(rc_platform::path_of(name)));
  for (const auto& [option, name] : outputs) {
    const rc_platform::Target target = rc_platform::target_of(rc_platform::path_of(name));
    refuse_if(target.refusal, rc_platform::path_of(name), option);
    if (target.streamed) continue;
    const fs::path whole = whole_path(target.file);
    if (std::ranges::count(known, whole) > 0)
      throw Error(option, ": ", in_quotes(name), " is read or written as another file as well, give another name");
    known.push_back(whole);
  }
}

}  // namespace cli
