/* One source for every plugin of the loader's test: complete, unless a definition spoils it. The least that a backend can be:
 * naive products with a table of coefficients. */
#include <roughcontact/plugin.h>
#include <stdlib.h>

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

typedef struct toy {
  const rc_host* host;
  const rc_system* system;
  double* table;        /* coefficients at the offsets 0 .. nx-1, 0 .. ny-1 */
  const int64_t* index; /* the domain's; it stays valid until the next bind */
  int64_t n;
  double mean; /* periodic: what the zero mode adds to every coefficient */
} toy;

static rc_status toy_create(const rc_host* host, const rc_operator_spec* spec, void** self) {
  const int64_t nx = spec->system->nx, ny = spec->system->ny;
  toy* made = calloc(1, sizeof *made);
  rc_status status = RC_OK;
  if (!made) return host->fail(host, RC_ERR_MEMORY, "toy: out of memory");
  made->host = host;
  made->system = spec->system;
  made->table = malloc((size_t)(nx * ny) * sizeof *made->table);
  status = made->table ? host->coefficients(host, spec->system, spec->kernel, nx, ny, made->table)
                       : host->fail(host, RC_ERR_MEMORY, "toy: out of memory");
  if (status != RC_OK) {
    free(made->table);
    free(made);
    return status;
  }
  *self = made;
  return RC_OK;
}

static void toy_destroy(void* self) {
  free(((toy*)self)->table);
  free(self);
}

static rc_status toy_bind(void* handle, const rc_domain* domain) {
  toy* self = handle;
  self->n = domain->n;
  self->index = domain->index;
  self->mean = domain->zero_mode / (double)(self->system->nx * self->system->ny);
  return RC_OK;
}

static int64_t toy_point(const toy* self, int64_t i) { return self->index ? self->index[i] : i; }

/* y at `point` of the grid. */
static double toy_sum(const toy* self, int64_t point, const double* x) {
  const int64_t nx = self->system->nx;
  double sum = 0;
  int64_t j;
  for (j = 0; j < self->n; ++j) {
    const int64_t other = toy_point(self, j);
    const int64_t dx = llabs(point % nx - other % nx), dy = llabs(point / nx - other / nx);
    sum += (self->table[dy * nx + dx] + self->mean) * x[j];
  }
  return sum;
}

static rc_status toy_apply(void* handle, const double* x, double* y) {
  const toy* self = handle;
  int64_t i;
  for (i = 0; i < self->n; ++i) y[i] = toy_sum(self, toy_point(self, i), x);
  return RC_OK;
}

static rc_status toy_field(void* handle, const double* x, double* y) {
  const toy* self = handle;
  int64_t point;
  for (point = 0; point < self->system->nx * self->system->ny; ++point) y[point] = toy_sum(self, point, x);
  return RC_OK;
}

/* It is slow, and says so. */
static inline rc_status toy_score(const rc_facts* facts, rc_estimate* estimate) {
  estimate->product = estimate->field = 2e-9 * (double)facts->n * (double)facts->n;
  return RC_OK;
}

static int64_t toy_modelled(void* self) { return ((toy*)self)->n; }

static const rc_component order = {.struct_size = sizeof(rc_component),
                                   .name = FIXTURE ".order",
                                   .summary = "order of the sum",
                                   .default_value = "rows",
                                   .choices = "rows|columns",
                                   .type = RC_TYPE_TEXT};
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
