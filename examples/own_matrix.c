/* The caller's own influence matrix, here of a row of springs coupled through an elastic layer: H is symmetric positive
 * definite, n x n, and a parabolic punch is pressed in with a given force. */
#include <math.h>
#include <roughcontact/roughcontact.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 41 };

int main(void) {
  static double H[N * N], gap[N], pressure[N], deformed[N];
  for (int i = 0; i < N; ++i) {
    gap[i] = 0.5 * pow((i - N / 2) / 10.0, 2);
    for (int j = 0; j < N; ++j) H[i * N + j] = exp(-abs(i - j) / 3.0);
  }

  rc_system system = RC_SYSTEM_INIT;
  system.op = RC_OPERATOR_DENSE;
  system.nx = N;
  system.ny = 1;
  system.hx = system.hy = 1; /* of a cell */
  system.dense = H;
  system.dense_ld = N;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_LOAD;
  step.target = 2.0;
  step.undeformed_gap = RC_IN(gap);
  rc_result result = RC_RESULT_INIT;
  result.p = RC_OUT(pressure);
  result.gap = RC_OUT(deformed);

  const rc_status status = rc_solve(&system, &step, NULL, &result);
  if (status != RC_OK) {
    fprintf(stderr, "%s: %s\n", rc_status_name(status), rc_last_error());
    return 1;
  }
  puts("point  pressure       gap");
  for (int i = 0; i < N; i += 4) printf("%5d  %8.5f  %8.5f\n", i, pressure[i], deformed[i]);
  printf("load %.6f at approach %.6f, %lld of %d points in contact\n", result.load, result.approach, (long long)result.contacts,
         N);
  return 0;
}
