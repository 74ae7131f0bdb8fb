/* Makes a rough surface, asks what it is like, presses it with cascade multi-resolution, and prints what is proven of the answer.
 * Needs libroughcontact-surface beside libroughcontact. */
#include <roughcontact/roughcontact.h>
#include <roughcontact/surface.h>
#include <stdio.h>

enum { LEVELS = 7, N = 1 << LEVELS };

static int failed(const char* what, rc_status status, const char* message) {
  fprintf(stderr, "%s: %s: %s\n", what, rc_status_name(status), message);
  return 1;
}

int main(void) {
  static double z[N * N], gap[N * N];
  const double h = 1e-6;
  rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  rc_surface_cmr advice = RC_SURFACE_CMR_INIT;
  spec.levels = LEVELS;
  spec.hurst = 0.8;
  spec.rms_height = 0.5e-6;
  rc_status status = rc_surface_rmd(&spec, LEVELS, 1, z);
  map.nx = map.ny = N;
  map.hx = map.hy = h;
  map.heights = z;
  if (status == RC_OK) status = rc_surface_cmr_advice(&map, 2, 0, &advice);
  if (status != RC_OK) return failed("surface", status, rc_surface_last_error());
  printf("two halvings of the grid are %strustworthy: %s\n", advice.trustworthy ? "" : "not ", advice.reason);

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  rc_result result = RC_RESULT_INIT;
  rc_options* options = NULL;
  system.nx = system.ny = N;
  system.hx = system.hy = h;
  system.modulus = 100e9;
  rc_gap_from_heights(N * N, RC_IN(z), RC_IN(NULL), RC_OUT(gap));
  step.undeformed_gap = RC_IN(gap);
  step.target = advice.approach;
  status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_SOLVER, "cmr");
  if (status == RC_OK) status = rc_options_set_number(options, "cmr.levels", 3);
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  rc_options_destroy(options);
  if (status != RC_OK) return failed("contact", status, rc_last_error());
  printf("load %.9g N, proven to lie in [%.9g, %.9g]\n", result.load, result.load_lower, result.load_upper);
  printf("%lld points in contact, %lld proven so, %lld undecided; %lld coarse solutions kept; %s\n", (long long)result.contacts,
         (long long)result.proven_contacts, (long long)result.undecided, (long long)result.levels, result.note);
  return 0;
}
