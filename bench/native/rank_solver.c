/* rank_solver N THREADS ranks|process mixed|double: one cold solve of a rough surface of N x N points, about a
   tenth of them in contact, by load control. double: products in double precision alone, and no coarser grids, so that counters
   can be said. The surface is made row by row from the points' numbers. Rank 0 prints a line of JSON. `process`: by rc_contact,
   on one rank. Seconds are those of MPI_Wtime: of the clock, or of the simulation where SMPI runs the program; without those of
   making the contact, which SMPI takes longer for than any MPI: it duplicates a communicator. */
#include <math.h>
#include <mpi.h>
#include <roughcontact/mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#ifdef RC_RECORDED
#include "recorded_exchange.h"
#else
static void record_begin(void) {}
static void record_end(void) {}
#endif

static uint64_t mixed(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

static double node(int64_t x, int64_t y, int octave) {
  return (double)(mixed((uint64_t)x * 0x9e3779b97f4a7c15u + (uint64_t)y * 0xd1b54a32d192ed03u + (uint64_t)octave) >> 11) *
             0x1p-53 -
         0.5;
}

/* Octaves of smooth noise from 8 cells a side to N / 16 of them; amplitudes fall as those of a self-affine surface with H = 0.8.
 */
static void make_row(int64_t n, int64_t iy, double* row) {
  memset(row, 0, (size_t)n * sizeof *row);
  for (int64_t cells = 8; cells <= n / 16 || cells == 8; cells *= 2) {
    const double amplitude = pow((double)cells, -0.8), y = (double)iy * (double)cells / (double)n, v = y - floor(y);
    const double sy = v * v * v * (v * (v * 6 - 15) + 10);
    const int64_t jy = (int64_t)y;
    int64_t before = -1;
    double left = 0, right = 0;
    for (int64_t ix = 0; ix < n; ++ix) {
      const double x = (double)ix * (double)cells / (double)n, u = x - floor(x), sx = u * u * u * (u * (u * 6 - 15) + 10);
      const int64_t jx = (int64_t)x;
      if (jx != before) {
        left = node(jx, jy, (int)cells) * (1 - sy) + node(jx, jy + 1, (int)cells) * sy;
        right = node(jx + 1, jy, (int)cells) * (1 - sy) + node(jx + 1, jy + 1, (int)cells) * sy;
        before = jx;
      }
      row[ix] += amplitude * (left * (1 - sx) + right * sx);
    }
  }
}

static void stop(const char* what) {
  fprintf(stderr, "rank_solver: %s: %s\n", what, rc_last_error());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

static double total(double value, MPI_Op how) {
  double all = 0;
  MPI_Allreduce(&value, &all, 1, MPI_DOUBLE, how, MPI_COMM_WORLD);
  return all;
}

static double peak(void) {
  struct rusage used;
  getrusage(RUSAGE_SELF, &used);
  return 1024.0 * (double)used.ru_maxrss;
}

static double cpu_seconds(void) {
  struct rusage used;
  getrusage(RUSAGE_SELF, &used);
  return (double)used.ru_utime.tv_sec + 1e-6 * (double)used.ru_utime.tv_usec;
}

int main(int argc, char** argv) {
  int rank, ranks, level;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (argc != 5) {
    if (rank == 0) fprintf(stderr, "usage: rank_solver N THREADS ranks|process mixed|double\n");
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  const int64_t n = atoll(argv[1]);
  const int alone = strcmp(argv[3], "process") == 0;
  const double base = peak();
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = n;
  system.hx = system.hy = 1.0 / (double)n;
  system.modulus = 1;
  int64_t first = 0, count = n;
  rc_exchange exchange = RC_EXCHANGE_INIT;
  if (!alone && rc_mpi_exchange_create(MPI_COMM_WORLD, &exchange) != RC_OK) stop("exchange");
  if (!alone && rc_ranks_rows(&exchange, &system, &first, &count) != RC_OK) stop("rows");

  const size_t points = (size_t)(n * count);
  double *gap = malloc((points + 1) * sizeof *gap), *p = calloc(points + 1, sizeof *p), highest = -INFINITY, squares = 0;
  if (!gap || !p) stop("no memory");
  for (int64_t iy = 0; iy < count; ++iy) make_row(n, first + iy, gap + iy * n);
  for (size_t i = 0; i < points; ++i) {
    highest = fmax(highest, gap[i]);
    if ((int64_t)(i % (size_t)n) > 0) squares += (gap[i] - gap[i - 1]) * (gap[i] - gap[i - 1]);
  }
  highest = total(highest, MPI_MAX);
  /* Rounded, so that it does not depend on who has added what. */
  const double slope = (float)((double)n * sqrt(2 * total(squares, MPI_SUM) / ((double)n * (double)n)));
  for (size_t i = 0; i < points; ++i) gap[i] = highest - gap[i];

  rc_options* options = NULL;
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  rc_ranks_counts counts = RC_RANKS_COUNTS_INIT;
  if (rc_options_create(NULL, &options) != RC_OK || rc_options_set_text(options, RC_OPT_THREADS, argv[2]) != RC_OK ||
      rc_options_set_text(options, RC_OPT_SOLVER, "haar-cg") != RC_OK ||
      rc_options_set_text(options, RC_OPT_BACKEND, "fft") != RC_OK ||
      rc_options_set_text(options, "haar-cg.products", argv[4]) != RC_OK ||
      rc_options_set_text(options, "haar-cg.nested", strcmp(argv[4], "double") == 0 ? "0" : "1") != RC_OK)
    stop("options");
  step.control = RC_CONTROL_LOAD;
  step.target =
      0.05 * slope; /* Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope), a little less in full solutions */
  step.undeformed_gap.data = gap;
  step.borrow = 1;
  result.p.data = p;

  MPI_Barrier(MPI_COMM_WORLD);
  const double cpu = cpu_seconds();
  double made;
  if (alone) {
    rc_contact* contact = NULL;
    if (rc_contact_create(&system, options, &contact) != RC_OK) stop("create");
    made = MPI_Wtime();
    if (rc_contact_solve(contact, &step, &result) < 0) stop("solve");
    rc_contact_destroy(contact);
  } else {
    rc_contact* contact = NULL;
    if (rc_ranks_contact_create(&exchange, &system, options, &contact) != RC_OK) stop("create");
    made = MPI_Wtime();
    record_begin();
    if (rc_contact_solve(contact, &step, &result) < 0) stop("solve");
    record_end();
    if (rc_ranks_contact_counts(contact, &counts) != RC_OK) stop("counts");
    rc_contact_destroy(contact);
    rc_mpi_exchange_destroy(&exchange);
  }
  const double seconds = total(MPI_Wtime() - made, MPI_MAX), busy = total(cpu_seconds() - cpu, MPI_SUM);
  uint64_t bits = 0, all_bits = 0;
  for (size_t i = 0; i < points; ++i) {
    uint64_t word;
    memcpy(&word, p + i, sizeof word);
    bits += mixed(word ^ mixed((uint64_t)first * (uint64_t)n + i));
  }
  MPI_Reduce(&bits, &all_bits, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  const double transposed = total((double)counts.transposed, MPI_SUM), reduced = total((double)counts.reduced, MPI_SUM),
               gathered = total((double)counts.gathered, MPI_SUM), memory = total(peak() - base, MPI_SUM);
  if (rank == 0)
    printf(
        "{\"status\": \"%s\", \"products\": %lld, \"seconds\": %.6g, \"cpu_seconds\": %.6g, \"bits\": \"%016llx\", "
        "\"transpositions\": %lld, \"transposed\": %.0f, \"reductions\": %lld, \"reduced\": %.0f, \"gathers\": %lld, "
        "\"gathered\": %.0f, \"distributed_iterations\": %lld, \"peak_bytes\": %.0f}\n",
        rc_status_name(result.status), (long long)result.products, seconds, busy, (unsigned long long)all_bits,
        (long long)counts.transpositions, transposed, (long long)counts.reductions, reduced, (long long)counts.gathers, gathered,
        (long long)counts.iterations, memory);
  free(gap);
  free(p);
  rc_options_destroy(options);
  MPI_Finalize();
  return 0;
}
