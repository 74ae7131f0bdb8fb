/* answers FILE BACKEND...: solves contacts with these backends and every solver, makes mistakes, and writes
 * statuses, messages and every number, bit for bit, as lines of text. compare.py compares two such files.
 * Surfaces come from operations that every machine rounds in the same way. */
#include <fenv.h>
#include <roughcontact/direct.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 24 * 20, SMALL = 30 };

static FILE* out;
static double gap[MOST], p[MOST], deformed[MOST];

static void number(const char* name, double value) {
  uint64_t bits = 0;
  memcpy(&bits, &value, sizeof bits);
  fprintf(out, "%s %016llx\n", name, (unsigned long long)bits);
}

static void numbers(const char* name, const double* values, int64_t n) {
  for (int64_t i = 0; i < n; ++i) number(name, values[i]);
}

static void outcome(rc_status status) { fprintf(out, "status %s: %s\n", rc_status_name(status), rc_last_error()); }

/* Two waves of parabolas, or a roughness of several sizes from a generator of integers. */
static void make_surface(const rc_system* system, int rough) {
  uint32_t state = 12345;
  for (int64_t k = 0; k < system->nx * system->ny; ++k) gap[k] = 0;
  for (int64_t cell = rough ? 1 : 8; cell <= 8; cell *= 2) {
    double level[MOST];
    for (int64_t k = 0; k < MOST; ++k) {
      state = state * 1664525u + 1013904223u;
      level[k] = (double)(state >> 8) / 16777216.0;
    }
    for (int64_t iy = 0; iy < system->ny; ++iy)
      for (int64_t ix = 0; ix < system->nx; ++ix) {
        const double x = (double)(ix % cell) / (double)cell - 0.5, y = (double)(iy % cell) / (double)cell - 0.5;
        gap[iy * system->nx + ix] += 0.1 * (double)cell * (level[iy / cell * system->nx + ix / cell] + x * x + y * y);
      }
  }
  rc_gap_from_heights(system->nx * system->ny, RC_IN(gap), RC_IN(NULL), RC_OUT(gap));
}

static void solve(const rc_system* system, const char* solver, const char* backend, int32_t control, double target) {
  rc_options* options = NULL;
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  step.control = control;
  step.target = target;
  step.undeformed_gap.data = gap;
  result.p.data = p;
  result.gap.data = deformed;
  rc_options_create(NULL, &options);
  rc_options_set_text(options, RC_OPT_SOLVER, solver);
  rc_options_set_text(options, RC_OPT_BACKEND, backend);
  rc_options_set_number(options, RC_OPT_TOL, 1e-12);
  rc_options_set_number(options, RC_OPT_MAX_ITER, 20000);
  const rc_status status = rc_solve(system, &step, options, &result);
  rc_options_destroy(options);
  fprintf(out, "case %lld x %lld, boundary %d, control %d, hardness %g: %s on %s\n", (long long)system->nx, (long long)system->ny,
          (int)system->boundary, (int)control, system->hardness, solver, backend);
  outcome(status);
  if (status < 0) return;
  fprintf(out, "by %s on %s, %lld in contact, %lld capped; %s\n", result.solver, result.backend, (long long)result.contacts,
          (long long)result.capped, result.note);
  number("load", result.load);
  number("approach", result.approach);
  number("energy", result.energy);
  numbers("p", p, system->nx * system->ny);
  numbers("gap", deformed, system->nx * system->ny);
}

static void solve_all(const char* backend) {
  /* greedy last: on the regular surface rounding errors decide in which order it takes points. */
  static const char* const solvers[] = {"auto", "haar-cg", "polonsky-keer", "nnls", "gp", "admm", "cmr", "greedy"};
  for (int periodic = 0; periodic < 2; ++periodic)
    for (int rough = 0; rough < 2; ++rough)
      for (int hard = 0; hard < 2; ++hard) {
        rc_system system = RC_SYSTEM_INIT;
        system.boundary = periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
        system.nx = rough ? 24 : 16;
        system.ny = rough ? 20 : 16;
        system.hx = 1;
        system.hy = rough ? 1.5 : 1;
        system.modulus = 2;
        system.hardness = hard ? 0.25 : 0;
        make_surface(&system, rough);
        for (size_t i = 0; i + (rough == 0) < sizeof solvers / sizeof *solvers; ++i) {
          solve(&system, solvers[i], backend, RC_CONTROL_APPROACH, periodic ? 0.3 : 0.5);
          solve(&system, solvers[i], backend, RC_CONTROL_LOAD, 10);
        }
      }
}

/* The caller's rounding changes no bit of an answer, and the call leaves it as it was. */
static void solve_while_rounding_upward(const char* backend) {
  static double to_nearest[MOST];
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = 24;
  system.ny = 20;
  system.hx = system.hy = system.modulus = 1;
  make_surface(&system, 1);
  solve(&system, "auto", backend, RC_CONTROL_APPROACH, 0.4);
  memcpy(to_nearest, p, sizeof p);
  fesetround(FE_UPWARD);
  solve(&system, "auto", backend, RC_CONTROL_APPROACH, 0.4);
  fprintf(out, "rounding %s, pressures %s\n", fegetround() == FE_UPWARD ? "kept" : "changed",
          memcmp(to_nearest, p, sizeof p) == 0 ? "the same" : "others");
  fesetround(FE_TONEAREST);
}

static void solve_directly(void) {
  static double H[SMALL * SMALL], u[SMALL], w[SMALL];
  for (int i = 0; i < SMALL; ++i) {
    for (int j = 0; j < SMALL; ++j) H[i * SMALL + j] = 1.0 / (1 + (i > j ? i - j : j - i));
    u[i] = 1 - 0.01 * (i - 12) * (i - 12) + (i % 3) * 0.2;
  }
  rc_status (*const routines[])(int64_t, const double*, int64_t, const double*, double*, double*, double, int64_t, rc_direct*) = {
      rc_greedy, rc_polonsky_keer, rc_nnls, rc_gp};
  for (int i = 0; i < 4; ++i) {
    memset(p, 0, sizeof p);
    fprintf(out, "case direct %d\n", i);
    outcome(routines[i](SMALL, H, SMALL, u, p, w, 1e-12, 10000, NULL));
    numbers("p", p, SMALL);
    numbers("w", w, SMALL);
  }
}

static void make_mistakes(void) {
  static const double wrong[] = {0, -1, 1e-320, 1e308};
  rc_system system = RC_SYSTEM_INIT;
  rc_options* options = NULL;
  fprintf(out, "case mistakes\n");
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = 8;
  system.hx = system.hy = system.modulus = 1;
  make_surface(&system, 1);
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    rc_system spoilt = system;
    spoilt.hx = wrong[i];
    solve(&spoilt, "auto", "auto", RC_CONTROL_LOAD, 1);
    solve(&system, "auto", "auto", RC_CONTROL_LOAD, -wrong[i]);
  }
  gap[3] = -gap[1] / 0.0;
  solve(&system, "auto", "auto", RC_CONTROL_APPROACH, 1);
  solve(&system, "autp", "auto", RC_CONTROL_APPROACH, 1);
  solve(&system, "auto", "../dense", RC_CONTROL_APPROACH, 1);
  system.nx = INT64_MAX;
  solve(&system, "auto", "auto", RC_CONTROL_APPROACH, 1);
  rc_options_create(NULL, &options);
  static const char* const pairs[][2] = {{"tol", "2,5"},     {"tol", "1e-400"},          {"tol", " 1"},
                                         {"threads", "0"},   {"threads", "99999999999"}, {"max_iter", "9223372036854775808"},
                                         {"tolerance", "1"}, {"time_limit", "nan"}};
  for (size_t i = 0; i < sizeof pairs / sizeof *pairs; ++i) outcome(rc_options_set_text(options, pairs[i][0], pairs[i][1]));
  rc_options_destroy(options);
}

int main(int count, char** words) {
  if (count < 3) return fprintf(stderr, "answers FILE BACKEND...\n"), 2;
  out = fopen(words[1], "wb");
  if (!out) return perror(words[1]), 2;
  for (int i = 2; i < count; ++i) {
    solve_all(words[i]);
    solve_while_rounding_upward(words[i]);
  }
  solve_directly();
  make_mistakes();
  const int failed = ferror(out);
  return fclose(out) != 0 || failed ? 1 : 0;
}
