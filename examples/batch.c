/* Twenty rough surfaces, as of a Monte Carlo study, each pressed by a load that grows in five steps: one call, two threads. */
#include <math.h>
#include <roughcontact/history.h>
#include <stdint.h>
#include <stdio.h>

enum { N = 48, SURFACES = 20, STEPS = 5 };

static double gap[SURFACES][N * N], targets[STEPS], approach[SURFACES][STEPS], area[SURFACES][STEPS];
static rc_status status[SURFACES][STEPS];

/* A few waves of random phase. */
static void make_surface(uint32_t seed, double* out) {
  double lowest = 0;
  for (int i = 0; i < N * N; ++i) out[i] = 0;
  for (int k = 1; k <= 5; ++k) {
    seed = seed * 1664525u + 1013904223u;
    const double phase_x = 1e-9 * seed, phase_y = 3e-9 * seed;
    for (int i = 0; i < N * N; ++i)
      out[i] += 1e-6 / k * cos(6.2832 * k * (i % N) / N + phase_x) * cos(6.2832 * k * (i / N) / N + phase_y);
  }
  for (int i = 0; i < N * N; ++i) lowest = fmin(lowest, out[i]);
  for (int i = 0; i < N * N; ++i) out[i] -= lowest;
}

int main(void) {
  for (int i = 0; i < SURFACES; ++i) make_surface((uint32_t)i + 1, gap[i]);
  for (int k = 0; k < STEPS; ++k) targets[k] = 0.5 * (k + 1);

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = N;
  system.hx = system.hy = 1e-6;
  system.modulus = 70e9;
  rc_batch batch = RC_BATCH_INIT;
  batch.control = RC_CONTROL_LOAD;
  batch.n = SURFACES;
  batch.steps = STEPS;
  batch.targets = RC_IN(targets);
  batch.target_stride = RC_BATCH_SHARED; /* the same loads for all; surfaces follow one another */
  batch.undeformed_gap = RC_IN(gap[0]);
  batch.columns.approach = RC_OUT(approach[0]);
  batch.columns.contact_area = RC_OUT(area[0]);
  batch.columns.status = RC_OUT(status[0]);

  rc_options* options = NULL;
  rc_status result = rc_options_create(NULL, &options);
  if (result == RC_OK) result = rc_options_set_number(options, RC_OPT_THREADS, 2);
  if (result == RC_OK) result = rc_batch_solve(&system, options, &batch);
  rc_options_destroy(options);
  if (result != RC_OK) fprintf(stderr, "%s: %s\n", rc_status_name(result), rc_last_error());

  for (int k = 0; k < STEPS && batch.written > 0; ++k) {
    double mean = 0, square = 0;
    int good = 0;
    for (int i = 0; i < SURFACES; ++i) {
      if (status[i][k] != RC_OK) continue;
      const double share = area[i][k] / (N * N * system.hx * system.hy);
      ++good;
      mean += share;
      square += share * share;
    }
    if (good == 0) continue;
    mean /= good;
    printf("%.1f N: %d surfaces, contact area %.2f %% +- %.2f %%, first approach %.3f um\n", targets[k], good, 100 * mean,
           100 * sqrt(fmax(0, square / good - mean * mean)), 1e6 * approach[0][k]);
  }
  return result != RC_OK;
}
