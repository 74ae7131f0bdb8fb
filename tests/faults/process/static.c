/* In a program linked with -static: plugins are refused with the reason, what is linked in solves. */
#include <roughcontact/registry.h>
#include <stdio.h>
#include <string.h>

enum { N = 8 };

static rc_status solve(const char* backend) {
  static double gap[N * N];
  for (int i = 0; i < N * N; ++i) gap[i] = 0.01 * ((i % N - 3) * (i % N - 3) + (i / N - 3) * (i / N - 3));
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = N;
  system.hx = system.hy = system.modulus = 1;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.undeformed_gap.data = gap;
  step.target = 0.1;
  rc_result result = RC_RESULT_INIT;
  rc_options* options = NULL;
  rc_status status = rc_options_create(NULL, &options);
  if (status == RC_OK) status = rc_options_set_text(options, RC_OPT_BACKEND, backend);
  if (status == RC_OK) status = rc_solve(&system, &step, options, &result);
  rc_options_destroy(options);
  return status;
}

int main(void) {
  if (rc_component_count(NULL, RC_COMPONENT_BACKEND) < 1 || solve("dense") != RC_OK || solve("auto") != RC_OK) {
    puts(rc_last_error());
    return 1;
  }
  const rc_status found = solve("fft");
  printf("%s: %s\n", rc_status_name(found), rc_last_error());
  if (found != RC_ERR_PLUGIN || !strstr(rc_last_error(), "-static")) return 1;
  rc_context* context = NULL; /* one without a folder */
  rc_options* options = NULL;
  rc_contact* contact = NULL;
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = N;
  system.hx = system.hy = system.modulus = 1;
  if (rc_context_create(RC_CONTEXT_NO_ENVIRONMENT, NULL, NULL, NULL, &context) != RC_OK ||
      rc_options_create(context, &options) != RC_OK || rc_options_set_text(options, RC_OPT_BACKEND, "cholmod") != RC_OK)
    return 1;
  const rc_status absent = rc_contact_create(&system, options, &contact);
  printf("%s: %s\n", rc_status_name(absent), rc_last_error());
  rc_options_destroy(options);
  rc_context_destroy(context);
  return absent != RC_ERR_NO_BACKEND || !strstr(rc_last_error(), "loads no plugins");
}
