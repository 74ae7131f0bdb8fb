/* pressures HEIGHTS NX NY PITCH MODULUS APPROACH PRESSURES: reads raw doubles, presses, writes raw doubles. */
#include <roughcontact/roughcontact.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** arguments) {
  if (count != 8) return 2;
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = atoll(arguments[2]);
  system.ny = atoll(arguments[3]);
  system.hx = system.hy = strtod(arguments[4], NULL);
  system.modulus = strtod(arguments[5], NULL);
  const size_t n = (size_t)(system.nx * system.ny);
  double *z = malloc(n * sizeof *z), *p = malloc(n * sizeof *p);
  FILE* file = fopen(arguments[1], "rb");
  if (!z || !p || !file || fread(z, sizeof *z, n, file) != n) return 2;
  fclose(file);

  double highest = z[0];
  for (size_t i = 1; i < n; ++i) highest = z[i] > highest ? z[i] : highest;
  for (size_t i = 0; i < n; ++i) z[i] = highest - z[i];
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = strtod(arguments[6], NULL);
  step.undeformed_gap.data = z;
  rc_result result = RC_RESULT_INIT;
  result.p.data = p;
  if (rc_solve(&system, &step, NULL, &result) != RC_OK) return fprintf(stderr, "%s\n", rc_last_error()), 1;

  file = fopen(arguments[7], "wb");
  if (!file || fwrite(p, sizeof *p, n, file) != n || fclose(file)) return 2;
  free(z);
  free(p);
  return 0;
}
