/* A near field wider than the grid is the whole matrix and takes no more memory; where that is above the limit, it is refused. */
#include <stdio.h>
#include <string.h>

#include "pressed.h"

static rc_status solve(int n, const char* memory_limit) {
  const char* const more[] = {"cholmod.near_field", "20000", "cholmod.memory_limit", memory_limit, NULL};
  const rc_status status = press("cholmod", "nnls", n, more);
  printf("%d x %d, %s MiB: %s: %s\n", n, n, memory_limit, rc_status_name(status), status < 0 ? rc_last_error() : "");
  return status;
}

int main(void) {
  if (solve(32, "64") != RC_OK) return 1;
  return solve(64, "1") != RC_ERR_MEMORY || !strstr(rc_last_error(), "the near field") ||
         !strstr(rc_last_error(), "cholmod.memory_limit");
}
