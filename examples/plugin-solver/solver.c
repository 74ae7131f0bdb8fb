/* The solver "spg": spectral projected gradients with an exact search along the projected direction. Birgin, Martinez & Raydan,
 * SIAM Journal on Optimization 10 (2000) 1196; step lengths by Barzilai & Borwein (1988). One product an iteration, no estimate
 * of eigenvalues. It minimises f(p) = 1/2 p'Hp - u'p over p >= 0; load control is the core's. */
#include <math.h>
#include <roughcontact/plugin.h>
#include <stdlib.h>
#include <string.h>

typedef struct vectors {
  double *gradient, *direction, *product; /* Hp - u; P(p - step gradient) - p; H direction */
} vectors;

static double dot(int64_t n, const double* a, const double* b) {
  double sum = 0;
  int64_t i;
  for (i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

/* gradient = H p - u, anew. */
static rc_status evaluate(const rc_problem* problem, const double* p, double* gradient) {
  const rc_status status = problem->apply(problem, p, gradient);
  int64_t i;
  if (status != RC_OK) return status;
  for (i = 0; i < problem->n; ++i) gradient[i] -= problem->u[i];
  return RC_OK;
}

/* How far p is from p >= 0, gradient >= 0, p gradient = 0: the gap where there is pressure, the overlap elsewhere. */
static double residual(int64_t n, const double* p, const double* gradient) {
  double worst = 0;
  int64_t i;
  for (i = 0; i < n; ++i) worst = fmax(worst, p[i] > 0 ? fabs(gradient[i]) : -gradient[i]);
  return worst;
}

static rc_status iterate(const rc_problem* problem, int long_steps, double* p, const vectors* v) {
  const int64_t n = problem->n;
  double step = 1;
  int fresh = 1; /* the gradient comes from a product of its own, not from updates */
  int64_t i, k;
  rc_status status = evaluate(problem, p, v->gradient);
  for (k = 0; status == RC_OK; ++k) {
    double curvature, slope, length;
    const double worst = residual(n, p, v->gradient);
    if ((status = problem->poll(problem, k, worst)) != RC_OK) return status;
    if (worst <= problem->tol) {
      if (fresh) return RC_OK;
      status = evaluate(problem, p, v->gradient);
      fresh = 1;
      continue;
    }
    for (i = 0; i < n; ++i) v->direction[i] = fmax(p[i] - step * v->gradient[i], 0) - p[i];
    slope = dot(n, v->gradient, v->direction);
    if (!(slope < 0)) return RC_STOP_STALLED; /* no descent is left in double precision */
    if ((status = problem->apply(problem, v->direction, v->product)) != RC_OK) return status;
    curvature = dot(n, v->direction, v->product);
    if (!(curvature > 0)) return RC_ERR_NUMERIC;
    length = fmin(1, -slope / curvature);
    for (i = 0; i < n; ++i) {
      p[i] = fmax(0, p[i] + length * v->direction[i]);
      v->gradient[i] += length * v->product[i];
    }
    fresh = 0;
    /* s = length direction and y = H s, of which length cancels. */
    step = long_steps ? dot(n, v->direction, v->direction) / curvature : curvature / dot(n, v->product, v->product);
  }
  return status;
}

static rc_status solve(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  const size_t n = (size_t)problem->n;
  const char* steps = NULL;
  double* work;
  vectors v;
  rc_status status = host->option_text(host, options, "spg.steps", &steps);
  (void)d; /* load control: found by the core */
  if (status != RC_OK) return status;
  work = malloc(3 * n * sizeof *work);
  if (!work) return host->fail(host, RC_ERR_MEMORY, "spg: out of memory; use a smaller grid");
  v.gradient = work;
  v.direction = work + n;
  v.product = work + 2 * n;
  status = iterate(problem, strcmp(steps, "long") == 0, p, &v);
  free(work);
  if (status == RC_ERR_NUMERIC) return host->fail(host, status, "spg: the operator is not positive definite");
  return status;
}

/* The estimate that `auto` compares: about 30 products for each digit, so spg suits rough answers. */
static rc_status score(const rc_facts* facts, rc_estimate* estimate) {
  const double products = 30 * -log10(facts->tol);
  if (facts->tol < 1e-6) return facts->host->fail(facts->host, RC_ERR_INCOMPATIBLE, "for tol of 1e-6 and above");
  estimate->seconds = facts->backend->seconds + products * facts->backend->product + facts->backend->field;
  estimate->bytes = 3 * 8.0 * (double)facts->n;
  return RC_OK;
}

static const rc_component step_option = {.struct_size = sizeof(rc_component),
                                         .name = "spg.steps",
                                         .summary = "which of Barzilai and Borwein's two step lengths",
                                         .default_value = "long",
                                         .choices = "long|short",
                                         .type = RC_TYPE_TEXT};
static const rc_component* const all_options[] = {&step_option};

static const rc_solver solver = {.struct_size = sizeof(rc_solver),
                                 .name = "spg",
                                 .summary = "spectral projected gradients",
                                 .license = "BSD-3-Clause",
                                 .controls = RC_CONTROL_APPROACH,
                                 .n_options = 1,
                                 .options = all_options,
                                 .solve = solve,
                                 .score = score};
static const rc_solver* const solvers[] = {&solver};

static const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                                 .abi_major = RC_PLUGIN_ABI_MAJOR,
                                 .abi_minor = RC_PLUGIN_ABI_MINOR,
                                 .name = "spg",
                                 .version = "1.0",
                                 .n_solvers = 1,
                                 .solvers = solvers};

RC_PLUGIN_ENTRY(spg, host, out) {
  (void)host;
  *out = &plugin;
  return RC_OK;
}
