/* Noise pressed on N x N cells by a backend and a solver. */
#ifndef PRESSED_H
#define PRESSED_H

#include <roughcontact/registry.h>
#include <stdint.h>
#include <stdlib.h>

static rc_system square(int n) {
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = n;
  system.hx = system.hy = system.modulus = 1;
  return system;
}

/* more: keys and values of further options, up to NULL. */
static rc_status press(const char* backend, const char* solver, int n, const char* const* more) {
  double* const gap = malloc((size_t)n * (size_t)n * sizeof *gap);
  unsigned random = 1;
  if (!gap) return RC_ERR_INTERNAL;
  for (int i = 0; i < n * n; ++i) gap[i] = (double)((random = random * 1664525u + 1013904223u) >> 8) / 16777216;
  const rc_system system = square(n);
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.undeformed_gap.data = gap;
  step.target = 0.5;
  rc_result result = RC_RESULT_INIT;
  rc_options* options = NULL;
  rc_status status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_BACKEND, backend);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_SOLVER, solver);
  for (; status == RC_OK && *more; more += 2) status = rc_options_set_text(options, more[0], more[1]);
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  rc_options_destroy(options);
  free(gap);
  return status;
}

#endif
