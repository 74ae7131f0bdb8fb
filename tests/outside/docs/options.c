/* Prints every option of the library and of the solvers and backends of this source tree, as the tables of docs/options.md.
 * Exit code 77 where one of those backends is not built. */
#include <roughcontact/registry.h>
#include <stdio.h>
#include <string.h>

#define RC_BACKEND(name, points, how) name,
static const char* const backends[] = {
#include "backends/known.def"
    NULL};
#undef RC_BACKEND

static int is_of(const char* key, const char* component) {
  const size_t length = strlen(component);
  return strncmp(key, component, length) == 0 && key[length] == '.';
}

/* The component of this key; NULL: it is the core's. */
static const char* owner(rc_context* context, const char* key, int32_t kind) {
  int64_t i;
  for (i = 0; i < rc_component_count(context, kind); ++i) {
    rc_component component = RC_COMPONENT_INIT;
    if (rc_component_describe(context, kind, i, &component) == RC_OK && is_of(key, component.name)) return component.name;
  }
  return NULL;
}

static void print_choices(const char* choices) {
  for (;;) {
    const size_t length = strcspn(choices, "|");
    printf("`%.*s`", (int)length, choices);
    if (choices[length] == '\0') return;
    printf(", ");
    choices += length + 1;
  }
}

static void print_row(const rc_component* option) {
  static const char* const types[] = {"", "integer", "real", "text"};
  printf("| `%s` | %s | ", option->name, types[option->type]);
  if (option->default_value[0])
    printf("`%s` | ", option->default_value);
  else
    printf("empty | ");
  if (option->type != RC_TYPE_TEXT)
    printf("%g .. %g", option->minimum, option->maximum);
  else if (option->choices)
    print_choices(option->choices);
  else
    printf("any");
  printf(" | %s%s |\n", option->summary, option->fixed ? " (fixed)" : "");
}

/* One table for each component that has options; component NULL: the core's. */
static void print_table(rc_context* context, const char* title, const char* component) {
  int64_t i, rows = 0;
  for (i = 0; i < rc_component_count(context, RC_COMPONENT_OPTION); ++i) {
    rc_component option = RC_COMPONENT_INIT;
    const char* name;
    if (rc_component_describe(context, RC_COMPONENT_OPTION, i, &option) != RC_OK) continue;
    name = owner(context, option.name, RC_COMPONENT_SOLVER);
    if (!name) name = owner(context, option.name, RC_COMPONENT_BACKEND);
    if (component ? !name || strcmp(name, component) != 0 : name != NULL) continue;
    if (rows++ == 0) printf("\n%s\n\n| key | type | default | values | meaning |\n|---|---|---|---|---|\n", title);
    print_row(&option);
  }
}

static void print_tables(rc_context* context, const char* heading, int32_t kind) {
  int64_t i;
  for (i = 0; i < rc_component_count(context, kind); ++i) {
    rc_component component = RC_COMPONENT_INIT;
    char title[128];
    if (rc_component_describe(context, kind, i, &component) != RC_OK) continue;
    snprintf(title, sizeof title, "## %s `%s`", heading, component.name);
    print_table(context, title, component.name);
  }
}

static int has_backend(rc_context* context, const char* name) {
  int64_t i;
  for (i = 0; i < rc_component_count(context, RC_COMPONENT_BACKEND); ++i) {
    rc_component component = RC_COMPONENT_INIT;
    if (rc_component_describe(context, RC_COMPONENT_BACKEND, i, &component) == RC_OK && strcmp(component.name, name) == 0)
      return 1;
  }
  return 0;
}

int main(void) {
  rc_context* context = NULL;
  int i;
  if (rc_context_create(RC_CONTEXT_NO_ENVIRONMENT, NULL, NULL, NULL, &context) != RC_OK)
    return fprintf(stderr, "%s\n", rc_last_error()), 1;
  for (i = 0; backends[i]; ++i) {
    /* cuda is only where there is a device; docs/device.md has its options. */
    if (strcmp(backends[i], "cuda") == 0 || has_backend(context, backends[i])) continue;
    printf("skipped: the backend %s is not built\n", backends[i]);
    rc_context_destroy(context);
    return 77;
  }
  print_table(context, "## Core", NULL);
  print_tables(context, "Solver", RC_COMPONENT_SOLVER);
  print_tables(context, "Backend", RC_COMPONENT_BACKEND);
  rc_context_destroy(context);
  return 0;
}
