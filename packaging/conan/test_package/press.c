/* Two points of which one touches. */
#include <roughcontact/roughcontact.h>
#include <stdio.h>

int main(void) {
  double gap[2] = {0, 1}, p[2];
  rc_system system = RC_SYSTEM_INIT;
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = 2, system.ny = 1;
  system.hx = system.hy = system.modulus = 1;
  step.control = RC_CONTROL_APPROACH;
  step.target = 0.5;
  step.undeformed_gap.data = gap;
  result.p.data = p;
  if (rc_solve(&system, &step, NULL, &result) != RC_OK) return fprintf(stderr, "%s\n", rc_last_error()), 1;
  return printf("load %g\n", result.load) < 0 || !(p[0] > 0 && p[1] == 0);
}
