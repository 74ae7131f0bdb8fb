/* A near field wider than the grid is the whole matrix and takes no more memory; where that is above the limit, it is refused. */
#include <roughcontact/roughcontact.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static rc_status solve(int n, const char* memory_limit) {
  double* const gap = malloc((size_t)n * (size_t)n * sizeof *gap);
  unsigned random = 1;
  if (!gap) return RC_ERR_INTERNAL;
  for (int i = 0; i < n * n; ++i) gap[i] = (double)((random = random * 1664525u + 1013904223u) >> 8) / 16777216;
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = n;
  system.hx = system.hy = system.modulus = 1;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.undeformed_gap.data = gap;
  step.target = 0.5;
  rc_result result = RC_RESULT_INIT;
  rc_options* options = NULL;
  rc_status status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_BACKEND, "cholmod");
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_SOLVER, "nnls");
  if (status == RC_OK) status = rc_options_set_text(options, "cholmod.near_field", "20000");
  if (status == RC_OK) status = rc_options_set_text(options, "cholmod.memory_limit", memory_limit);
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  printf("%d x %d, %s MiB: %s: %s\n", n, n, memory_limit, rc_status_name(status), status < 0 ? rc_last_error() : "");
  rc_options_destroy(options);
  free(gap);
  return status;
}

int main(void) {
  if (solve(32, "64") != RC_OK) return 1;
  return solve(64, "1") != RC_ERR_MEMORY || !strstr(rc_last_error(), "the near field") ||
         !strstr(rc_last_error(), "cholmod.memory_limit");
}
