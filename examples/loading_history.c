/* Presses a rough surface and lets it go again in one call, then solves a small matrix with a direct routine. */
#include <math.h>
#include <roughcontact/direct.h>
#include <roughcontact/history.h>
#include <stdio.h>

enum { N = 64, STEPS = 9 };

static int32_t report(int64_t step, const rc_result* result, void* user) {
  (void)user;
  printf("step %d: approach %.2f um, load %.4f N, %lld points touch\n", (int)step, 1e6 * result->approach, result->load,
         (long long)result->contacts);
  return 0; /* anything else ends the history */
}

static rc_status press_and_release(void) {
  static double gap[N * N];
  double targets[STEPS], load[STEPS], stiffness[STEPS];
  for (int i = 0; i < N * N; ++i) gap[i] = 0.5e-6 * (2 - cos(0.6 * (i % N)) - cos(0.35 * (i / N)));
  for (int k = 0; k < STEPS; ++k) targets[k] = 0.1e-6 * (k < 5 ? k + 1 : STEPS - k);

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = N;
  system.hx = system.hy = 1e-6;
  system.modulus = 70e9;
  rc_history history = RC_HISTORY_INIT;
  history.control = RC_CONTROL_APPROACH;
  history.n = STEPS;
  history.targets = RC_IN(targets);
  history.undeformed_gap = RC_IN(gap);
  history.columns.load = RC_OUT(load);
  history.columns.stiffness = RC_OUT(stiffness);
  history.fn = report;

  rc_contact* contact = NULL;
  rc_status status = rc_contact_create(&system, NULL, &contact);
  if (status == RC_OK) status = rc_contact_solve_history(contact, &history);
  rc_contact_destroy(contact);
  if (status == RC_OK) printf("stiffness at the top: %.4e N/m\n", stiffness[4]);
  return status;
}

static rc_status three_springs(void) {
  const double H[9] = {2, 1, 0.5, 1, 2, 1, 0.5, 1, 2}, u[3] = {1, 0.2, 1};
  double p[3] = {0}, w[3];
  const rc_status status = rc_nnls(3, H, 3, u, p, w, 1e-12, 100, NULL);
  if (status == RC_OK) printf("forces %.3f %.3f %.3f, gap of the second %.3f\n", p[0], p[1], p[2], w[1]);
  return status;
}

int main(void) {
  rc_status status = press_and_release();
  if (status == RC_OK) status = three_springs();
  if (status != RC_OK) fprintf(stderr, "%s: %s\n", rc_status_name(status), rc_last_error());
  return status != RC_OK;
}
