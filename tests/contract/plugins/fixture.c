/* One source for every plugin of the loader's test: complete, unless a definition spoils it. */
#include "toy_backend.h"

#ifndef FIXTURE_INSIDE
#define FIXTURE_INSIDE FIXTURE
#endif
#ifndef FIXTURE_MAJOR
#define FIXTURE_MAJOR RC_PLUGIN_ABI_MAJOR
#endif
#ifndef FIXTURE_MINOR
#define FIXTURE_MINOR RC_PLUGIN_ABI_MINOR
#endif
#ifndef FIXTURE_SCORE
#define FIXTURE_SCORE NULL
#endif
#ifndef FIXTURE_SECOND
#define FIXTURE_SECOND "second-of-" FIXTURE
#endif
#ifndef FIXTURE_ANSWER
#define FIXTURE_ANSWER ((void)host, *out = &plugin, RC_OK)
#endif

static const rc_component order = {
    sizeof(rc_component), FIXTURE ".order", "order of the sum", NULL, NULL, "rows", "rows|columns", RC_TYPE_TEXT, 0, 0.0, 0.0};
static const rc_component* const options[] = {&order};

#define BACKEND(known, count, list)                                                                                           \
  {                                                                                                                           \
    .struct_size = sizeof(rc_backend), .name = known, .summary = "naive products", .license = "BSD-3-Clause",                 \
    .caps = RC_CAP_FREE | RC_CAP_PERIODIC, .n_options = count, .options = list, .create = toy_create, .destroy = toy_destroy, \
    .bind = toy_bind, .apply = toy_apply, .field = toy_field, .modelled = toy_modelled, .score = FIXTURE_SCORE                \
  }
static const rc_backend first = BACKEND(FIXTURE, 1, options), second = BACKEND(FIXTURE_SECOND, 0, NULL);
static const rc_backend* const backends[] = {&first, &second};
static const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                                 .abi_major = FIXTURE_MAJOR,
                                 .abi_minor = FIXTURE_MINOR,
                                 .name = FIXTURE_INSIDE,
                                 .version = "1.0",
                                 .n_backends = 2,
                                 .backends = backends};

#ifdef FIXTURE_NO_SYMBOL
RC_API const rc_plugin* rc_plugin_by_another_name(void);
const rc_plugin* rc_plugin_by_another_name(void) { return &plugin; }
#else
RC_PLUGIN_ENTRY(linked, host, out) { return FIXTURE_ANSWER; }
#endif
