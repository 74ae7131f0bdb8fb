#include "gnuplot.h"

#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "text.h"

extern char** environ;

namespace cli {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

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

// gnuplot gets a process group of its own, so that Ctrl-C does not kill the drawing of a step that is already solved.
pid_t spawn(int script, int picture, int complaints, int& error) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const auto connect = [&](int file, int number) {
    if (error == 0) error = posix_spawn_file_actions_adddup2(&actions, file, number);
  };
  connect(script, STDIN_FILENO);
  connect(picture, STDOUT_FILENO);
  connect(complaints, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);

  char name[] = "gnuplot", defaults[] = "-d";  // -d: without the user's start-up files
  char* arguments[] = {name, defaults, nullptr};
  pid_t child = -1;
  if (error == 0) error = posix_spawnp(&child, name, &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return child;
}

}  // namespace

Gnuplot run_gnuplot(const std::string& script, std::FILE* picture) {
  const File input{std::tmpfile(), std::fclose}, complaints{std::tmpfile(), std::fclose};
  if (!input || !complaints || std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0 || std::fseek(input.get(), 0, SEEK_SET) != 0)
    return {false, false, std::strerror(errno)};

  int error = 0;
  const pid_t child = spawn(fileno(input.get()), fileno(picture), fileno(complaints.get()), error);
  if (error != 0) return {false, error == ENOENT, std::strerror(error)};

  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return {false, false, std::strerror(errno)};
  }
  struct stat written {};
  const bool empty = fstat(fileno(picture), &written) != 0 || written.st_size == 0;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {!empty, false, empty ? "it wrote nothing" : ""};
  return {false, false, complaint(complaints.get())};
}

}  // namespace cli
