#include "platform/process.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

extern char** environ;

namespace rc_platform {

Ended run(const std::string& program, const std::vector<std::string>& arguments, std::FILE* input, std::FILE* output,
          std::FILE* errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  int error = 0;
  const auto connect = [&](std::FILE* file, int number) {
    if (error == 0) error = posix_spawn_file_actions_adddup2(&actions, fileno(file), number);
  };
  connect(input, STDIN_FILENO);
  connect(output, STDOUT_FILENO);
  connect(errors, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);

  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t child = -1;
  if (error == 0) error = posix_spawnp(&child, program.c_str(), &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return {-1, error == ENOENT, std::strerror(error)};

  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return {-1, false, std::strerror(errno)};
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, false, ""};
}

Ended become(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(program.c_str(), words.data());
  return {-1, errno == ENOENT, std::strerror(errno)};
}

}  // namespace rc_platform
