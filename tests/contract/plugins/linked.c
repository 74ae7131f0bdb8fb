/* The same source as the plugin, linked into the host program. */
#define RC_PLUGIN_BUILTIN
#define FIXTURE "linked"
#include "fixture.c"
