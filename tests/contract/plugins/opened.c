/* Which plugins a process opens: none where a built-in backend does as well, those that may serve where not, and the others by
   name. The dynamic loader's map of the process tells. No thread is started that was not asked for. */
#include <dirent.h>
#include <roughcontact/roughcontact.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int opened(const char* file) {
  char line[4096];
  int found = 0;
  FILE* const maps = fopen("/proc/self/maps", "r");
  while (maps && fgets(line, sizeof line, maps)) found |= strstr(line, file) != NULL;
  if (maps) fclose(maps);
  return found;
}

static int threads(void) {
  int found = 0;
  DIR* const tasks = opendir("/proc/self/task");
  while (tasks && readdir(tasks)) ++found;
  if (tasks) closedir(tasks);
  return found - 2; /* "." and ".." */
}

struct solve {
  int64_t n;
  double approach; /* or load */
  const char* backend;
  int32_t control, boundary;
  double tol;
};

static rc_status run(struct solve wanted) {
  const int64_t n = wanted.n;
  rc_system system = RC_SYSTEM_INIT;
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  rc_options* options = NULL;
  double* const gap = malloc((size_t)(n * n) * sizeof *gap);
  uint32_t random = 1;
  for (int64_t i = 0; gap && i < n * n; ++i) gap[i] = 1 / 4294967296.0 * (double)(random = random * 1664525u + 1013904223u);
  system.boundary = wanted.boundary;
  system.nx = system.ny = n;
  system.hx = system.hy = system.modulus = 1;
  step.control = wanted.control;
  step.undeformed_gap.data = gap;
  step.target = wanted.approach;
  rc_status status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_BACKEND, wanted.backend);
  if (status == RC_OK) status = rc_options_set_number(options, RC_OPT_TOL, wanted.tol);
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  rc_options_destroy(options);
  free(gap);
  return status;
}

static rc_status solve(int64_t n, double approach, const char* backend) {
  const struct solve wanted = {n, approach, backend, RC_CONTROL_APPROACH, RC_BOUNDARY_FREE, 1e-8};
  return run(wanted);
}

/* BLAS libraries of several makers start threads of their own when they are opened. */
static int opened_blas(void) { return opened("blas") || opened("lapack") || opened("libmkl"); }

/* Whether a default solve of some size, control, boundary or tolerance fails or opens one. */
static int defaults_open_blas(void) {
  const int64_t sides[] = {16, 128, 512};
  const double tolerances[] = {1e-4, 1e-8, 1e-12};
  for (int k = 0; k < 3 * 3 * 4; ++k) {
    const int64_t n = sides[k % 3];
    const double load = 1e-3 * (double)(n * n);
    const int by_load = k / 9 % 2;
    const struct solve wanted = {n,
                                 by_load ? load : 0.2,
                                 "auto",
                                 by_load ? RC_CONTROL_LOAD : RC_CONTROL_APPROACH,
                                 k / 18 ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE,
                                 tolerances[k / 3 % 3]};
    if (run(wanted) < 0 || opened_blas()) return printf("%d x %d, case %d: ", (int)n, (int)n, k), 1;
  }
  return 0;
}

static int failed(const char* what) {
  printf("%s; %s\n", what, rc_last_error());
  return 1;
}

int main(void) {
  if (solve(16, 0.1, "auto") != RC_OK) return failed("a small contact is not solved");
  if (opened("/rcb_")) return failed("a small contact opened a plugin");
  if (solve(128, 0.9, "auto") != RC_OK) return failed("a larger contact is not solved");
  if (!opened("/rcb_fft.so")) return failed("a larger contact did not open fft");
  if (opened("/rcb_split.so")) return failed("a grid of a few points opened split");
  if (opened("/rcb_cholmod.so")) return failed("cholmod was opened unasked");
  if (solve(512, 0.9, "auto") != RC_OK) return failed("a large contact is not solved");
  if (!opened("/rcb_split.so")) return failed("a large contact did not open split");
  if (defaults_open_blas()) return failed("a default solve fails or opens a BLAS");
  if (threads() != 1) return failed("a library has started threads");
  if (solve(16, 0.1, "cholmod") != RC_OK) return failed("cholmod does not solve");
  if (!opened("/rcb_cholmod.so")) return failed("cholmod was not opened when it was named");
  return 0;
}
