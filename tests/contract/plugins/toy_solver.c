/* A complete solver as a plugin: projected gradient steps, approach control only. */
#include <math.h>
#include <roughcontact/plugin.h>
#include <stdlib.h>

enum { bound_steps = 5, most_steps = 100000 };

static rc_status iterate(const rc_problem* problem, double* p, double* w, double* x) {
  const int64_t n = problem->n;
  double largest = 0; /* Collatz: for positive H, the greatest ratio (Hx)_i / x_i bounds its eigenvalues */
  rc_status status = RC_OK;
  int64_t i, k;
  for (i = 0; i < n; ++i) x[i] = 1;
  for (k = 0; k < bound_steps; ++k) {
    if ((status = problem->apply(problem, x, w)) != RC_OK) return status;
    for (largest = 0, i = 0; i < n; ++i) largest = fmax(largest, w[i] / x[i]);
    for (i = 0; i < n; ++i) x[i] = w[i] / largest;
  }
  for (k = 0; k < most_steps; ++k) {
    double residual = 0;
    if ((status = problem->apply(problem, p, w)) != RC_OK) return status;
    for (i = 0; i < n; ++i) {
      w[i] -= problem->u[i];
      residual = fmax(residual, p[i] > 0 ? fabs(w[i]) : -w[i]);
    }
    if ((status = problem->poll(problem, k, residual)) != RC_OK) return status;
    if (residual <= problem->tol) return RC_OK;
    for (i = 0; i < n; ++i) p[i] = fmax(0, p[i] - w[i] / largest);
  }
  return RC_STOP_STALLED;
}

static rc_status solve(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  double* const work = malloc(2 * (size_t)problem->n * sizeof *work);
  rc_status status = RC_OK;
  (void)options;
  (void)d;
  if (!work) return host->fail(host, RC_ERR_MEMORY, "toy-solver: out of memory");
  status = iterate(problem, p, work, work + problem->n);
  free(work);
  return status;
}

static const rc_solver solver = {.struct_size = sizeof(rc_solver),
                                 .name = "toy-solver",
                                 .summary = "projected gradient",
                                 .license = "BSD-3-Clause",
                                 .controls = RC_CONTROL_APPROACH,
                                 .n_options = 0,
                                 .solve = solve};
static const rc_solver* const solvers[] = {&solver};
static const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                                 .abi_major = RC_PLUGIN_ABI_MAJOR,
                                 .abi_minor = RC_PLUGIN_ABI_MINOR,
                                 .name = "toy-solver",
                                 .version = "1.0",
                                 .n_solvers = 1,
                                 .solvers = solvers};

RC_PLUGIN_ENTRY(toy_solver, host, out) {
  (void)host;
  *out = &plugin;
  return RC_OK;
}
