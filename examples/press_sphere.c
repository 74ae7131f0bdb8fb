/* Presses a rigid sphere of radius 10 mm into steel by 1 micrometre. press_sphere [BACKEND]: any name that
 * `roughcontact backends` lists; "auto" if none is given. */
#include <roughcontact/roughcontact.h>
#include <stdio.h>

enum { N = 64 };

int main(int argc, char** argv) {
  static double gap[N * N];
  const double h = 4e-6, radius = 10e-3;
  for (int i = 0; i < N * N; ++i) {
    const double x = (i % N - (N - 1) / 2.0) * h, y = (i / N - (N - 1) / 2.0) * h;
    gap[i] = (x * x + y * y) / (2 * radius);
  }

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = N;
  system.hx = system.hy = h;
  system.modulus = 230e9;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = 1e-6;
  step.undeformed_gap = RC_IN(gap);
  rc_result result = RC_RESULT_INIT;

  rc_options* options = NULL;
  rc_status status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_BACKEND, argc > 1 ? argv[1] : "auto");
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  rc_options_destroy(options);
  if (status != RC_OK) {
    fprintf(stderr, "%s: %s\n", rc_status_name(status), rc_last_error());
    return 1;
  }
  printf("%s on %s: load %.6f N, area %.6e m^2, %s, residuals %.1e %.1e %.1e\n", result.solver, result.backend, result.load,
         result.contact_area, rc_status_name(status), result.kkt_primal, result.kkt_dual, result.kkt_complementarity);
  return 0;
}
