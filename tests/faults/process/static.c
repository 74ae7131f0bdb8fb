/* In a program linked with -static: plugins are refused with the reason, what is linked in solves. */
#include <stdio.h>
#include <string.h>

#include "pressed.h"

static rc_status solve(const char* backend) {
  const char* const none = NULL;
  return press(backend, "auto", 8, &none);
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
  const rc_system system = square(8);
  if (rc_context_create(RC_CONTEXT_NO_ENVIRONMENT, NULL, NULL, NULL, &context) != RC_OK ||
      rc_options_create(context, &options) != RC_OK || rc_options_set_text(options, RC_OPT_BACKEND, "cholmod") != RC_OK)
    return 1;
  const rc_status absent = rc_contact_create(&system, options, &contact);
  printf("%s: %s\n", rc_status_name(absent), rc_last_error());
  rc_options_destroy(options);
  rc_context_destroy(context);
  return absent != RC_ERR_NO_BACKEND || !strstr(rc_last_error(), "loads no plugins");
}
