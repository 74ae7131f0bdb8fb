/* solve_once BACKEND SOLVER N BOUNDARY [HARDNESS]: presses noise on N x N points, once by approach and once by load. With a
   hardness, in units of the modulus, also the stiffness with its bounds and the derivatives by every height. Exit status 0:
   certified; 1: a failed call, whose status and text are printed; 2: anything else. */
#include <roughcontact/derivatives.h>
#include <stdio.h>
#include <stdlib.h>

static int refused(rc_status status) {
  if (status < 0) printf("%s: %s\n", rc_status_name(status), rc_last_error());
  return status < 0 ? rc_last_error()[0] != '\0' ? 1 : 2 : status == RC_OK ? 0 : 2;
}

static int differentiate(rc_contact* contact, const double* gap, double* change) {
  rc_gradient gradient = RC_GRADIENT_INIT;
  gradient.dJ_dgap = RC_IN(gap);
  gradient.dJ_dundeformed_gap = RC_OUT(change);
  return refused(rc_contact_gradient(contact, &gradient));
}

/* change: [n], or NULL where no derivatives are wanted */
static int solve(rc_contact* contact, const double* gap, double* change) {
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  int ended = 0;
  step.control = RC_CONTROL_APPROACH;
  step.undeformed_gap.data = gap;
  step.target = 2e-7;
  if ((ended = refused(rc_contact_solve(contact, &step, &result))) != 0) return ended;
  if (change && (ended = differentiate(contact, gap, change)) != 0) return ended;
  step.undeformed_gap.data = NULL;
  step.control = RC_CONTROL_LOAD;
  step.target = 0.7 * result.load;
  if ((ended = refused(rc_contact_solve(contact, &step, &result))) != 0) return ended;
  return change ? differentiate(contact, gap, change) : 0;
}

int main(int argc, char** argv) {
  if (argc != 5 && argc != 6) return 2;
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = atol(argv[3]);
  system.hx = system.hy = 1e-6;
  system.modulus = 1e11;
  system.boundary = atoi(argv[4]);
  if (argc == 6) system.hardness = atof(argv[5]) * system.modulus;
  const size_t n = (size_t)(system.nx * system.ny);
  double* const gap = malloc(n * sizeof *gap);
  double* const change = argc == 6 ? malloc(n * sizeof *change) : NULL;
  if (!gap || (argc == 6 && !change)) {
    puts("no memory for the gap");
    return 1;
  }
  uint32_t random = 1;
  for (size_t i = 0; i < n; ++i) gap[i] = 1e-6 / 4294967296.0 * (double)(random = random * 1664525u + 1013904223u);
  rc_options* options = NULL;
  rc_contact* contact = NULL;
  int ended = refused(rc_options_create(NULL, &options));
  if (!ended) ended = refused(rc_options_set_text(options, RC_OPT_BACKEND, argv[1]));
  if (!ended) ended = refused(rc_options_set_text(options, RC_OPT_SOLVER, argv[2]));
  if (!ended && change) ended = refused(rc_options_set_number(options, RC_OPT_STIFFNESS, 2));
  if (!ended) ended = refused(rc_contact_create(&system, options, &contact));
  if (!ended) ended = solve(contact, gap, change);
  rc_contact_destroy(contact);
  rc_options_destroy(options);
  free(change);
  free(gap);
  return ended;
}
