/* After a solve, a child solves again: every backend with every solver. A child that hangs is ended by its alarm. */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pressed.h"

static rc_status solve(const char* backend, const char* solver) {
  const char* const none = NULL;
  return press(backend, solver, 20, &none);
}

static int threads(void) {
  DIR* const tasks = opendir("/proc/self/task");
  int count = -2; /* "." and ".." */
  while (tasks && readdir(tasks)) ++count;
  if (tasks) closedir(tasks);
  return count;
}

static rc_component described(int32_t kind, int64_t i) {
  rc_component component;
  memset(&component, 0, sizeof component);
  component.struct_size = sizeof component;
  if (rc_component_describe(NULL, kind, i, &component) != RC_OK) exit(3);
  return component;
}

int main(void) {
  int pairs = 0, failures = 0;
  const int64_t backends = rc_component_count(NULL, RC_COMPONENT_BACKEND),
                solvers = rc_component_count(NULL, RC_COMPONENT_SOLVER);
  for (int64_t b = 0; b < backends; ++b)
    for (int64_t s = 0; s < solvers; ++s) {
      const rc_component backend = described(RC_COMPONENT_BACKEND, b), solver = described(RC_COMPONENT_SOLVER, s);
      const rc_status expected = solve(backend.name, solver.name);
      if (expected < 0) continue; /* a pair that does not go together */
      ++pairs;
      const pid_t child = fork();
      if (child == 0) {
        alarm(30);
        _exit(solve(backend.name, solver.name) == expected ? 0 : 1);
      }
      int end = -1;
      if (child < 0 || waitpid(child, &end, 0) != child) return 3;
      if (end != 0) {
        printf("%s with %s: the child %s\n", solver.name, backend.name, WIFSIGNALED(end) ? "hangs" : "fails");
        ++failures;
      }
    }
  printf("%d pairs, %d threads\n", pairs, threads());
  if (threads() > 1) puts("a thread has stayed");
  return failures > 0 || pairs < 10 || threads() > 1;
}
