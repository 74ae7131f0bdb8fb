/* A program of the first release: compiled against its header, frozen here, and run with today's library. Later headers may add
 * functions, and members at the end of structs; what is used here stays. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frozen/roughcontact-0.1.h"

enum { N = 24, POINTS = N * N, STEPS = 3 };
static double gap[POINTS], p[POINTS], deformed[POINTS];
static int checks, failures;

static void check(int holds, const char* what) {
  ++checks;
  if (holds) return;
  ++failures;
  fprintf(stderr, "FAILED: %s (last error: %s)\n", what, rc_last_error());
}

/* A function writes the struct_size bytes that it is told of and leaves what is behind them: for the size in the frozen header,
 * for that of an even older one, and for a newer one, whose end must be zero. */
#define CHECK_INIT(type, first)                                                                                     \
  do {                                                                                                              \
    static const size_t sizes[] = {first, sizeof(type), sizeof(type) + 40};                                         \
    union {                                                                                                         \
      type value;                                                                                                   \
      unsigned char bytes[sizeof(type) + 128];                                                                      \
    } u;                                                                                                            \
    size_t i, k, end;                                                                                               \
    for (i = 0; i < 3; ++i) {                                                                                       \
      memset(&u, 0xa5, sizeof u);                                                                                   \
      (type##_init)(&u.value, sizes[i]);                                                                            \
      check(u.value.struct_size == sizes[i], #type "_init says the size it was given");                             \
      for (end = sizeof u; end > 0 && u.bytes[end - 1] == 0xa5; --end) {                                            \
      }                                                                                                             \
      check(end <= sizes[i], #type "_init writes no more than the caller's struct");                                \
      check(end + 8 > sizes[i], #type "_init writes all of the caller's struct");                                   \
      for (k = sizeof(type); k < end; ++k) check(u.bytes[k] == 0, #type "_init leaves what it does not know zero"); \
    }                                                                                                               \
  } while (0)

static void check_initial_values(void) {
  CHECK_INIT(rc_system, 88);
  CHECK_INIT(rc_step, 48);
  CHECK_INIT(rc_result, 432);
  CHECK_INIT(rc_context_config, 40);
  CHECK_INIT(rc_path, 120);
  CHECK_INIT(rc_batch, 200);
  CHECK_INIT(rc_level, 88);
  CHECK_INIT(rc_direct, 248);
  CHECK_INIT(rc_area, 40);
  CHECK_INIT(rc_patches, 96);
  CHECK_INIT(rc_histogram, 80);
}

static rc_system make_system(void) {
  rc_system system = RC_SYSTEM_INIT;
  int i;
  system.nx = system.ny = N;
  system.hx = system.hy = 1e-6;
  system.modulus = 100e9;
  for (i = 0; i < POINTS; ++i) gap[i] = (pow((i % N - 11.5) * 1e-6, 2) + pow((i / N - 11.5) * 1e-6, 2)) / (2 * 1e-4);
  return system;
}

static int32_t count_progress(const rc_progress* progress, void* user) {
  check(progress->struct_size >= sizeof *progress && progress->iteration >= 0, "the progress callback gets its struct");
  ++*(int*)user;
  return 0;
}

/* A result of this header, with guards behind it, filled by a library that may know a longer one. */
static void check_solving(const rc_system* system, double* load) {
  struct {
    rc_result result;
    unsigned char guard[64];
  } answer;
  rc_step step = RC_STEP_INIT;
  rc_options* options = NULL;
  rc_contact* contact = NULL;
  const char* text = NULL;
  int calls = 0;
  size_t i;
  memset(&answer, 0xa5, sizeof answer);
  rc_result_init(&answer.result);
  answer.result.p = p;
  answer.result.gap = deformed;
  step.target = 3e-7;
  step.gap = gap;
  check(rc_options_create(NULL, &options) == RC_OK, "rc_options_create");
  check(rc_options_set_text(options, RC_OPT_BACKEND, "dense") == RC_OK, "rc_options_set_text");
  check(rc_options_set_real(options, RC_OPT_TOL, 1e-9) == RC_OK, "rc_options_set_real");
  check(rc_options_set_int(options, RC_OPT_STIFFNESS, 1) == RC_OK, "rc_options_set_int");
  check(rc_options_parse(options, RC_OPT_MAX_ITER, "500") == RC_OK, "rc_options_parse");
  check(rc_options_get_text(options, RC_OPT_BACKEND, &text) == RC_OK && strcmp(text, "dense") == 0, "rc_options_get_text");
  check(rc_contact_create(system, options, &contact) == RC_OK, "rc_contact_create");
  check(rc_contact_on_progress(contact, count_progress, &calls, 1) == RC_OK, "rc_contact_on_progress");
  check(rc_contact_solve(contact, &step, &answer.result) == RC_OK, "rc_contact_solve");
  *load = answer.result.load;
  check(fabs(*load / (4.0 / 3 * 100e9 * sqrt(1e-4) * pow(3e-7, 1.5)) - 1) < 0.05, "the load is Hertz's");
  check(answer.result.struct_size == sizeof(rc_result), "struct_size stays the caller's");
  check(answer.result.contacts > 0 && answer.result.stiffness > 0, "results are where the frozen header has them");
  check(strcmp(answer.result.backend, "dense") == 0 && answer.result.left_out == 0, "so are the last ones");
  check(calls > 0, "progress was reported");
  for (i = 0; i < sizeof answer.guard; ++i) check(answer.guard[i] == 0xa5, "nothing is written behind the caller's struct");
  check(rc_contact_certify(contact, &step, &answer.result) == RC_OK, "rc_contact_certify");
  check(rc_contact_reset(contact) == RC_OK, "rc_contact_reset");
  rc_contact_destroy(contact);
  rc_options_destroy(options);
}

static void check_histories(const rc_system* system, double load) {
  static const double targets[STEPS] = {1e-7, 2e-7, 3e-7};
  double loads[STEPS], batch_loads[2 * STEPS];
  rc_contact* contact = NULL;
  rc_path path = RC_PATH_INIT;
  rc_batch batch = RC_BATCH_INIT;
  path.n = batch.steps = STEPS;
  path.targets = batch.targets = targets;
  path.gap = batch.gap = gap;
  path.load = loads;
  check(rc_contact_create(system, NULL, &contact) == RC_OK, "rc_contact_create without options");
  check(rc_contact_solve_path(contact, &path) == RC_OK && path.completed == STEPS, "rc_contact_solve_path");
  check(fabs(loads[2] / load - 1) < 1e-6, "a path ends where one step does");
  rc_contact_destroy(contact);
  batch.n = 2;
  batch.target_stride = batch.gap_stride = RC_BATCH_SHARED;
  batch.load = batch_loads;
  check(rc_batch_solve(system, NULL, &batch) == RC_OK && batch.certified == 2, "rc_batch_solve");
  check(fabs(batch_loads[5] / load - 1) < 1e-6, "a batch ends where one step does");
}

static void check_the_rest(const rc_system* system) {
  static const double H[4] = {2, 1, 1, 2}, u[2] = {1, -1};
  double x[2] = {0, 0};
  rc_direct direct;
  rc_area area;
  rc_component component = {sizeof component, NULL, NULL, NULL, NULL};
  rc_option_spec option = {sizeof option, NULL, NULL, NULL, NULL, 0, 0, 0, 0};
  int32_t abi = -1;
  rc_version(NULL, NULL, NULL, &abi);
  check(abi == RC_ABI, "the library has the number of the frozen header");
  rc_direct_init(&direct);
  check(rc_nnls(2, H, 2, u, x, NULL, 1e-12, 100, &direct) == RC_OK && fabs(x[0] - 0.5) < 1e-12, "rc_nnls");
  rc_area_init(&area);
  check(rc_area_measure(system, p, NULL, &area) == RC_OK && area.area > 0, "rc_area_measure");
  check(rc_backend_count(NULL) > 0, "rc_backend_count");
  check(rc_backend_describe(NULL, 0, &component) == RC_OK && component.name, "rc_backend_describe");
  check(rc_options_count(NULL) > 0 && rc_options_describe(NULL, 0, &option) == RC_OK && option.key, "rc_options_describe");
  check(strcmp(rc_status_name(RC_ERR_SHAPE), "RC_ERR_SHAPE") == 0, "rc_status_name");
}

int main(void) {
  const rc_system system = make_system();
  double load = 0;
  check_initial_values();
  check_solving(&system, &load);
  check_histories(&system, load);
  check_the_rest(&system);
  printf("%d checks, %d failed\n", checks, failures);
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
