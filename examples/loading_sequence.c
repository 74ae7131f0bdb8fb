/* Ten steps of load on one contact: plans, tables and the last pressures are kept, so each step starts near its answer. */
#include <math.h>
#include <roughcontact/roughcontact.h>
#include <stdio.h>

enum { N = 128 };

int main(void) {
  static double gap[N * N], pressure[N * N];
  const double h = 1e-6, wave = 6.283185307179586 / (32 * h);
  for (int i = 0; i < N * N; ++i) gap[i] = 0.1e-6 * (2 - cos(wave * (i % N) * h) - cos(wave * (i / N) * h));

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_PERIODIC;
  system.nx = system.ny = N;
  system.hx = system.hy = h;
  system.modulus = 70e9;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_LOAD;
  rc_result result = RC_RESULT_INIT;
  result.p = RC_OUT(pressure);

  rc_contact* contact = NULL;
  rc_status status = rc_contact_create(&system, NULL, &contact);
  if (status == RC_OK) puts("  load [N]  approach [m]  area [%]  max p [Pa]  products with H");
  for (int k = 1; status == RC_OK && k <= 10; ++k) {
    step.undeformed_gap = RC_IN(k == 1 ? gap : NULL); /* NULL: as before */
    step.target = 0.3 * k;
    status = rc_contact_solve(contact, &step, &result);
    if (status != RC_OK) break;
    double largest = 0;
    for (int i = 0; i < N * N; ++i) largest = fmax(largest, pressure[i]);
    printf("%10.4f  %12.4e  %8.2f  %10.3e  %15lld\n", result.load, result.approach, 100.0 * (double)result.contacts / (N * N),
           largest, (long long)result.products);
  }
  if (status != RC_OK) fprintf(stderr, "%s: %s\n", rc_status_name(status), rc_last_error());
  rc_contact_destroy(contact);
  return status != RC_OK;
}
