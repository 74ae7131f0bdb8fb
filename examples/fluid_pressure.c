/* A fluid between the bodies, whose pressure f falls from one side to the other: the bodies carry p = f + p' with p' >= 0. So p'
 * is the contact on the undeformed gap plus H f, under the load that the fluid leaves. */
#include <math.h>
#include <roughcontact/product.h>
#include <stdio.h>

enum { N = 64, POINTS = N * N };

static int failed(rc_status status) {
  if (status != RC_OK) fprintf(stderr, "%s: %s\n", rc_status_name(status), rc_last_error());
  return status != RC_OK;
}

int main(void) {
  static double gap[POINTS], lifted[POINTS], fluid[POINTS], pressure[POINTS], deformed[POINTS], all[POINTS];
  const double pi = 3.14159265358979, highest = 0.004, load = 20; /* of the fluid; the force on both together */
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_PERIODIC;
  system.nx = system.ny = N;
  system.hx = system.hy = 1;
  system.modulus = 1;
  double carried = 0; /* by the fluid */
  for (int i = 0; i < POINTS; ++i) {
    const double x = 2 * pi * (i % N) / N, y = 2 * pi * (i / N) / N;
    gap[i] = 0.2 * (2 - cos(2 * x) * cos(3 * y) - 0.5 * cos(5 * x + y));
    fluid[i] = highest * (1 - (i % N + 0.5) / N);
    carried += fluid[i];
  }

  rc_product* product = NULL;
  if (failed(rc_product_create(&system, NULL, &product))) return 1;
  rc_status status = rc_product_apply(product, RC_IN(fluid), RC_OUT(lifted));
  for (int i = 0; i < POINTS; ++i) lifted[i] += gap[i];

  rc_result dry = RC_RESULT_INIT, wet = RC_RESULT_INIT;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_LOAD;
  step.target = load;
  step.undeformed_gap = RC_IN(gap);
  if (status == RC_OK) status = rc_solve(&system, &step, NULL, &dry);
  step.target = load - carried;
  step.undeformed_gap = RC_IN(lifted);
  wet.p = RC_OUT(pressure);
  wet.gap = RC_OUT(deformed);
  if (status == RC_OK) status = rc_solve(&system, &step, NULL, &wet);

  /* The gap under all pressures is that of the step, and nowhere negative. */
  for (int i = 0; i < POINTS; ++i) all[i] = fluid[i] + pressure[i];
  if (status == RC_OK) status = rc_product_apply(product, RC_IN(all), RC_OUT(all));
  rc_product_destroy(product);
  if (failed(status)) return 1;
  double off = 0;
  for (int i = 0; i < POINTS; ++i) off = fmax(off, fabs(all[i] + gap[i] - wet.approach - deformed[i]));
  printf("dry: %.1f %% in contact, mean gap %.4f\n", 100 * dry.area_fraction, dry.mean_gap);
  printf("the fluid carries %.0f %%: %.1f %% in contact, mean gap %.4f, off by %.0e\n", 100 * carried / load,
         100 * wet.area_fraction, wet.mean_gap, off);
  return !(off < 1e-9 && wet.mean_gap > dry.mean_gap && wet.area_fraction < dry.area_fraction);
}
