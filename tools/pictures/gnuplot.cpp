#include "pictures/gnuplot.h"

#include <cerrno>
#include <cstring>
#include <memory>

#include "platform/files.h"
#include "platform/process.h"
#include "text.h"

namespace cli {

namespace {

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// gnuplot's message: the first line that is neither the echo of a command nor the mark under its fault.
std::string complaint(std::FILE* output) {
  std::rewind(output);
  char line[512];
  while (std::fgets(line, sizeof line, output)) {
    const auto text = trimmed(line);
    if (text.size() > 1 && !text.starts_with("gnuplot>")) return std::string(text);
  }
  return "no message";
}

}  // namespace

Gnuplot run_gnuplot(const std::string& script, std::FILE* picture) {
  const OpenFile input{rc_platform::create_unnamed(), std::fclose}, complaints{rc_platform::create_unnamed(), std::fclose};
  if (!input || !complaints || std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0 || std::fseek(input.get(), 0, SEEK_SET) != 0)
    return {false, false, std::strerror(errno)};

  // -d: without the user's start-up files.
  const rc_platform::Ended ended = rc_platform::run("gnuplot", {"-d"}, input.get(), picture, complaints.get());
  if (!ended.error.empty()) return {false, ended.missing, ended.error};
  const bool empty = rc_platform::size_of(picture) == 0;
  if (ended.code == 0) return {!empty, false, empty ? "it wrote nothing" : ""};
  return {false, false, complaint(complaints.get())};
}

}  // namespace cli
