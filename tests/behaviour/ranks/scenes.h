/* Scenes that every rank can make for its own rows: rough surfaces as sums of waves, from the points' numbers alone. */
#ifndef SCENES_H
#define SCENES_H

#include <math.h>
#include <roughcontact/ranks.h>
#include <stdlib.h>
#include <string.h>

enum masking { whole, holes, half };

typedef struct scene {
  const char* name;
  int64_t nx, ny;
  int32_t boundary, control;
  double target;   /* approach above the lowest gap, load or area */
  double hardness; /* 0: none */
  enum masking mask;
  const char* products; /* haar-cg.products */
  int single;           /* gap and pressures of 4 bytes */
  int stiffness;        /* the option */
  const char* kernel;   /* NULL: auto */
} scene;

static const scene scenes[] = {
    {"free, load", 96, 128, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.08, 0, whole, "mixed", 0, 0, NULL},
    {"free, approach, double", 100, 75, RC_BOUNDARY_FREE, RC_CONTROL_APPROACH, 0.05, 0, whole, "double", 0, 0, NULL},
    {"periodic, load, odd", 81, 99, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD, 0.1, 0, whole, "mixed", 0, 0, NULL},
    {"periodic, approach", 64, 64, RC_BOUNDARY_PERIODIC, RC_CONTROL_APPROACH, 0.04, 0, whole, "mixed", 0, 0, NULL},
    {"holes", 70, 130, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.05, 0, holes, "mixed", 0, 0, NULL},
    {"half the grid masked, single", 64, 96, RC_BOUNDARY_FREE, RC_CONTROL_APPROACH, 0.05, 0, half, "mixed", 1, 0, NULL},
    {"hardness", 64, 80, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.06, 0.15, whole, "mixed", 0, 0, NULL},
    {"hardness, periodic, approach", 64, 64, RC_BOUNDARY_PERIODIC, RC_CONTROL_APPROACH, 0.03, 0.1, holes, "double", 0, 0, NULL},
    {"coarse grids", 300, 260, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.4, 0, whole, "mixed", 0, 0, NULL},
    {"coarse grid of ranks", 2200, 128, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.4, 0, whole, "mixed", 0, 0, NULL},
    {"stiffness", 96, 72, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.06, 0, whole, "mixed", 0, 1, NULL},
    {"stiffness, interval, periodic", 64, 64, RC_BOUNDARY_PERIODIC, RC_CONTROL_APPROACH, 0.03, 0, whole, "mixed", 0, 2, NULL},
    {"stiffness, interval, hardness", 64, 80, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.06, 0.15, holes, "double", 0, 2, NULL},
    {"kernel galerkin", 64, 48, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.04, 0, whole, "mixed", 0, 1, "galerkin"},
    {"kernel disc", 64, 48, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.04, 0, whole, "mixed", 0, 0, "disc"},
    {"kernel eq9", 64, 48, RC_BOUNDARY_FREE, RC_CONTROL_APPROACH, 0.04, 0, whole, "mixed", 0, 0, "eq9"},
    {"kernel punch", 64, 48, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.04, 0, whole, "mixed", 0, 0, "punch"},
    {"area", 70, 130, RC_BOUNDARY_FREE, RC_CONTROL_AREA, 0.3, 0, holes, "mixed", 0, 0, NULL},
    {"area, hardness", 64, 80, RC_BOUNDARY_PERIODIC, RC_CONTROL_AREA, 0.1, 0.15, whole, "double", 0, 0, NULL},
    {"area, few rows", 50, 5, RC_BOUNDARY_FREE, RC_CONTROL_AREA, 0.01, 0, whole, "mixed", 0, 0, NULL},
    {"mean pressure", 64, 64, RC_BOUNDARY_PERIODIC, RC_CONTROL_PRESSURE, 0.02, 0, whole, "mixed", 0, 0, NULL},
    {"few pieces of rows", 36, 32, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.03, 0, whole, "mixed", 0, 2, NULL},
    {"nothing touches", 64, 64, RC_BOUNDARY_FREE, RC_CONTROL_APPROACH, -0.1, 0, whole, "mixed", 0, 0, NULL},
    {"few rows", 50, 5, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 0, NULL},
    {"one row", 40, 1, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.001, 0, whole, "mixed", 0, 0, NULL},
    {"narrow", 2, 60, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.002, 0, whole, "mixed", 0, 0, NULL},
    {"sparse, load", 640, 520, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 0, NULL},
    {"sparse, approach, single", 516, 530, RC_BOUNDARY_FREE, RC_CONTROL_APPROACH, 0.01, 0, whole, "mixed", 1, 0, NULL},
    {"sparse, holes, stiffness", 640, 520, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, holes, "mixed", 0, 2, NULL},
    {"sparse, hardness", 640, 520, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0.15, holes, "mixed", 0, 0, NULL},
    {"sparse, coarse grid of ranks", 1100, 1060, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, holes, "mixed", 0, 0, NULL},
    {"sparse, few pieces of rows", 1300, 256, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 0, NULL},
    {"sparse, periodic, load", 640, 520, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 2, NULL},
    {"sparse, periodic, approach, odd, single", 517, 531, RC_BOUNDARY_PERIODIC, RC_CONTROL_APPROACH, 0.012, 0, whole, "mixed", 1,
     0, NULL},
    {"sparse, periodic, hardness", 640, 520, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD, 0.01, 0.15, holes, "mixed", 0, 0, NULL},
    {"sparse, periodic, coarse grid of ranks", 1101, 1063, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD, 0.01, 0, holes, "double", 0, 0,
     NULL},
};
enum { scene_count = sizeof scenes / sizeof scenes[0] };

static const double lowest = 0.3; /* gap at the highest peak, about */

enum { waves = 12, factors = 4 };

/* For every x, or y, and wave: cosine and sine of its share of a, and of its share of 2.7 a. */
static double* shares(int64_t n, int of_x) {
  double* const all = (double*)malloc((size_t)(n * waves * factors) * sizeof(double));
  for (int64_t i = 0; i < n; ++i)
    for (int k = 1; k <= waves; ++k) {
      const double a = 2 * 3.14159265358979 * (of_x ? k : 13 - k) * (double)i / (double)n;
      double* const to = all + (i * waves + k - 1) * factors;
      to[0] = cos(a + (of_x ? k * k : 0));
      to[1] = sin(a + (of_x ? k * k : 0));
      to[2] = cos(2.7 * a - (of_x ? k : 0));
      to[3] = sin(2.7 * a - (of_x ? k : 0));
    }
  return all;
}

/* The sum over k of cos(a + k k) / (3 + k) + sin(2.7 a - k) / (9 + 2 k), a = 2 pi (k x / nx + (13 - k) y / ny). */
static double gap_at(const scene* s, int64_t x, int64_t y) {
  static int64_t nx, ny;
  static double *of_x, *of_y;
  double height = 0;
  if (nx != s->nx || ny != s->ny) {
    free(of_x);
    free(of_y);
    nx = s->nx;
    ny = s->ny;
    of_x = shares(nx, 1);
    of_y = shares(ny, 0);
  }
  for (int k = 0; k < waves; ++k) {
    const double *const u = of_x + (x * waves + k) * factors, *const v = of_y + (y * waves + k) * factors;
    height += (u[0] * v[0] - u[1] * v[1]) / (4 + k) + (u[3] * v[2] + u[2] * v[3]) / (11 + 2 * k);
  }
  return lowest + 0.05 * (1 - height);
}

static int included(const scene* s, int64_t x, int64_t y) {
  if (s->mask == holes) return (x / 7 + y / 5) % 3 != 0;
  return s->mask != half || y >= s->ny / 2;
}

static rc_system system_of(const scene* s) {
  rc_system system = RC_SYSTEM_INIT;
  system.nx = s->nx;
  system.ny = s->ny;
  system.boundary = s->boundary;
  system.hx = 1.0 / 64;
  system.hy = 1.0 / 64;
  system.modulus = 1;
  system.hardness = s->hardness;
  return system;
}

/* Rows first .. first + count - 1 of the gap and the mask; NaN where that is 0. */
static void fill_rows(const scene* s, int64_t first, int64_t count, double* gap, uint8_t* mask) {
  for (int64_t i = 0; i < s->nx * count; ++i) {
    const int64_t x = i % s->nx, y = first + i / s->nx;
    mask[i] = (uint8_t)included(s, x, y);
    gap[i] = mask[i] ? gap_at(s, x, y) : NAN;
  }
}

/* An approach is counted from the lowest gap of the whole surface. */
static double target_of(const scene* s) {
  double least = INFINITY;
  if (s->control != RC_CONTROL_APPROACH) return s->target;
  for (int64_t y = 0; y < s->ny; ++y)
    for (int64_t x = 0; x < s->nx; ++x)
      if (included(s, x, y)) least = fmin(least, gap_at(s, x, y));
  return least + s->target;
}

/* The arrays of a rank's rows. */
typedef struct rows {
  double *gap, *p, *deformed;
  float *gap_single, *p_single;
  uint8_t* mask;
} rows;

static rows rows_of(const scene* s, int64_t first, int64_t count) {
  const size_t n = (size_t)(s->nx * count) + 1;
  rows r = {(double*)malloc(n * sizeof(double)), (double*)malloc(n * sizeof(double)), (double*)malloc(n * sizeof(double)),
            (float*)malloc(n * sizeof(float)),   (float*)malloc(n * sizeof(float)),   (uint8_t*)malloc(n)};
  fill_rows(s, first, count, r.gap, r.mask);
  for (int64_t i = 0; i < s->nx * count; ++i) r.gap_single[i] = (float)r.gap[i];
  return r;
}

static void free_rows(rows r) {
  free(r.gap);
  free(r.p);
  free(r.deformed);
  free(r.gap_single);
  free(r.p_single);
  free(r.mask);
}

static void prepare(const scene* s, const rows* r, rc_step* step, rc_result* result) {
  const rc_step first = RC_STEP_INIT;
  const rc_result none = RC_RESULT_INIT;
  *step = first;
  *result = none;
  step->control = s->control;
  step->target = target_of(s);
  step->undeformed_gap.data = s->single ? (const void*)r->gap_single : r->gap;
  step->undeformed_gap.type = result->p.type = s->single ? RC_SINGLE : RC_NATIVE;
  if (s->mask != whole) step->mask.data = r->mask;
  result->p.data = s->single ? (void*)r->p_single : (void*)r->p;
  result->gap.data = r->deformed;
}

static rc_options* options_of(const scene* s, int64_t threads) {
  rc_options* options = NULL;
  rc_options_create(NULL, &options);
  rc_options_set_number(options, RC_OPT_THREADS, (double)threads);
  rc_options_set_text(options, "haar-cg.products", s->products);
  rc_options_set_number(options, RC_OPT_STIFFNESS, s->stiffness);
  if (s->kernel) rc_options_set_text(options, RC_OPT_KERNEL, s->kernel);
  return options;
}

/* A step of this rank. */
typedef struct job {
  rc_system system;
  rc_step step;
  rc_result result;
  rc_options* options;
  rows of;
  double *gap, *p;
  int64_t first, count;
} job;

static job job_of(const rc_exchange* exchange, const scene* s, int64_t threads) {
  job j;
  j.system = system_of(s);
  rc_ranks_rows(exchange, &j.system, &j.first, &j.count);
  j.of = rows_of(s, j.first, j.count);
  j.gap = j.of.gap;
  j.p = j.of.p;
  prepare(s, &j.of, &j.step, &j.result);
  j.options = options_of(s, threads);
  return j;
}

static void free_job(job j) {
  rc_options_destroy(j.options);
  free_rows(j.of);
}

#endif
