/* Solves a small contact on backend fft, a plugin that both libraries must find. */
#include <roughcontact/roughcontact.h>
#include <stdio.h>

int main(void) {
  static double gap[256];
  rc_system system = RC_SYSTEM_INIT;
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  rc_options* options = NULL;
  rc_status status;
  for (int i = 0; i < 256; ++i) gap[i] = ((i % 16 - 7.5) * (i % 16 - 7.5) + (i / 16 - 7.5) * (i / 16 - 7.5)) / 100;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = 16;
  system.hx = system.hy = system.modulus = 1;
  step.control = RC_CONTROL_APPROACH;
  step.target = 0.1;
  step.undeformed_gap.data = gap;
  status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, "backend", "fft");
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  rc_options_destroy(options);
  printf("%d load %.6f %s\n", (int)status, result.load, rc_last_error());
  return status != RC_OK;
}
