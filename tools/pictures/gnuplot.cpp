#include "pictures/gnuplot.h"

#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>

#include "formats/error.h"
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

// gnuplot does not notice a disk that fills up: what begins as a PNG must have its end.
bool cut_off(std::FILE* picture) {
  constexpr std::string_view begins = "\x89PNG", ends = "IEND\xae\x42\x60\x82";
  const auto has = [picture](std::string_view bytes, long offset, int from) {
    std::string found(bytes.size(), '\0');
    return std::fseek(picture, offset, from) == 0 && std::fread(found.data(), 1, found.size(), picture) == found.size() &&
           found == bytes;
  };
  const bool cut = has(begins, 0, SEEK_SET) && !has(ends, -static_cast<long>(ends.size()), SEEK_END);
  std::fseek(picture, 0, SEEK_END);
  return cut;
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
  if (ended.code == 0 && cut_off(picture)) throw Error("cannot write what gnuplot drew: it is cut off, the disk may be full");
  if (ended.code == 0) return {!empty, false, empty ? "it wrote nothing" : ""};
  return {false, false, complaint(complaints.get())};
}

}  // namespace cli
