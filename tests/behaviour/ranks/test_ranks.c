/* test_ranks [THREADS [SCENE...]]: solves scenes on the ranks of MPI_COMM_WORLD. Prints lines that
 * must be the same for every number of ranks and threads: digests of pressures, gaps and all numbers of the result. One rank of
 * one thread compares with the serial library. */
#include <roughcontact/mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include "scenes.h"

static int rank, ranks, failures;
static rc_exchange exchange = RC_EXCHANGE_INIT;

static void check(int holds, const char* scene_name, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "rank %d: %s: %s: %s\n", rank, scene_name, what, rc_last_error());
}

static uint64_t digest(const void* data, size_t bytes, uint64_t hash) {
  const unsigned char* at = data;
  for (size_t i = 0; i < bytes; ++i) hash = (hash ^ at[i]) * 0x100000001b3u;
  return hash;
}

/* What must not depend on the number of ranks: all but times. */
static uint64_t digest_of(rc_result result) {
  const double numbers[] = {result.load,         result.approach,        result.mean_pressure,   result.contact_area,
                            result.energy,       result.kkt_primal,      result.kkt_dual,        result.kkt_complementarity,
                            result.kkt_control,  result.duality_gap,     result.load_lower,      result.load_upper,
                            result.area_lower,   result.area_upper,      result.plastic_volume,  result.tolerance,
                            result.stiffness,    result.stiffness_lower, result.stiffness_upper, result.area_fraction,
                            result.max_pressure, result.mean_gap};
  const int64_t counts[] = {result.status,   result.iterations,      result.products,     result.points,    result.candidates,
                            result.modelled, result.contacts,        result.proven_open,  result.undecided, result.capped,
                            result.levels,   result.proven_contacts, result.proven_capped};
  uint64_t hash = 0xcbf29ce484222325u;
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i)
    hash = digest(isnan(numbers[i]) ? "nan" : (const void*)&numbers[i], isnan(numbers[i]) ? 3 : sizeof numbers[i], hash);
  hash = digest(counts, sizeof counts, hash);
  return digest(result.note, strlen(result.note), hash);
}

/* Rows of all ranks, on all of them. */
static void* all_rows(const void* mine, size_t bytes_of_row, int64_t count, int64_t ny) {
  int *counts = malloc((size_t)ranks * 2 * sizeof(int)), own = (int)((size_t)count * bytes_of_row), at = 0;
  void* all = malloc((size_t)ny * bytes_of_row);
  MPI_Allgather(&own, 1, MPI_INT, counts, 1, MPI_INT, MPI_COMM_WORLD);
  for (int r = 0; r < ranks; ++r) {
    counts[ranks + r] = at;
    at += counts[r];
  }
  MPI_Allgatherv(mine, own, MPI_BYTE, all, counts, counts + ranks, MPI_BYTE, MPI_COMM_WORLD);
  free(counts);
  return all;
}

/* The serial library's answer is another one within the certificates of both. */
static void compare(const scene* s, const rc_result* mine, const void* p_all) {
  const rows r = rows_of(s, 0, s->ny);
  const rc_system system = system_of(s);
  rc_options* options = options_of(s, 1);
  rc_step step;
  rc_result result;
  double most = 0, off = 0;
  prepare(s, &r, &step, &result);
  const rc_status status = rc_solve(&system, &step, options, &result);
  check(status == mine->status, s->name, "the status of one process");
  for (int64_t i = 0; i < s->nx * s->ny; ++i) {
    const double one = s->single ? r.p_single[i] : r.p[i],
                 other = s->single ? ((const float*)p_all)[i] : ((const double*)p_all)[i];
    most = fmax(most, one);
    off = fmax(off, fabs(one - other));
  }
  if (s->control == RC_CONTROL_AREA) { /* loads that give the area may differ, and so pressures do */
    check(fabs(result.contact_area - mine->contact_area) <= 2e-3 * s->target, s->name, "the area of one process");
    free_rows(r);
    rc_options_destroy(options);
    return;
  }
  check(off <= 1e-4 * most, s->name, "the pressures of one process");
  check(fabs(result.load - mine->load) <= 1e-6 * result.load, s->name, "the load of one process");
  check(fabs(result.approach - mine->approach) <= 1e-6 * fabs(result.approach), s->name, "the approach of one process");
  if (s->stiffness > 0)
    check(fabs(result.stiffness - mine->stiffness) <= 1e-6 * result.stiffness, s->name, "the stiffness of one process");
  if (s->stiffness > 1)
    check(mine->stiffness_lower <= result.stiffness_upper && result.stiffness_lower <= mine->stiffness_upper, s->name,
          "intervals of the stiffness that meet");
  if (s->stiffness > 1)
    check(mine->stiffness_lower <= mine->stiffness && mine->stiffness <= mine->stiffness_upper, s->name, "its interval");
  if (result.load_upper >= result.load_lower)
    check(mine->load_upper >= result.load_lower && mine->load_lower <= result.load_upper, s->name, "intervals that meet");
  free_rows(r);
  rc_options_destroy(options);
}

static void run(const scene* s, int64_t threads) {
  job j = job_of(&exchange, s, threads);
  const rows r = j.of;
  const int64_t count = j.count;
  rc_contact* contact = NULL;
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, s->name, "create");
  if (!contact) MPI_Abort(MPI_COMM_WORLD, 1);
  const rc_status status = rc_contact_solve(contact, &j.step, &j.result);
  check(status == RC_OK, s->name, "solve");
  const size_t of_row = (size_t)s->nx * (s->single ? sizeof(float) : sizeof(double));
  void* p = all_rows(s->single ? (void*)r.p_single : (void*)r.p, of_row, count, s->ny);
  double* gap = all_rows(r.deformed, (size_t)s->nx * sizeof(double), count, s->ny);
  for (int64_t i = 0; i < s->nx * s->ny; ++i)
    if (!included(s, i % s->nx, i / s->nx)) gap[i] = 0;
  const uint64_t hash = digest_of(j.result);
  if (rank == 0) {
    printf(
        "%s: status %d, backend %s, contacts %lld, p %016llx, gap %016llx, result %016llx\n", s->name, status, j.result.backend,
        (long long)j.result.contacts, (unsigned long long)digest(p, of_row * (size_t)s->ny, 0xcbf29ce484222325u),
        (unsigned long long)digest(gap, (size_t)(s->nx * s->ny) * sizeof(double), 0xcbf29ce484222325u), (unsigned long long)hash);
    if (ranks == 1 && threads == 1) compare(s, &j.result, p); /* on other numbers of ranks p has the same digest */
  }
  uint64_t first_hash = hash;
  MPI_Bcast(&first_hash, sizeof first_hash, MPI_BYTE, 0, MPI_COMM_WORLD);
  check(first_hash == hash, s->name, "the same numbers on every rank");

  /* Two transpositions a product, in parts on large grids, one for the eigenvalues of a free surface; three sums an iteration,
   * and some for the certificate. */
  rc_ranks_counts counts = RC_RANKS_COUNTS_INIT;
  check(rc_ranks_contact_counts(contact, &counts) == RC_OK, s->name, "counts");
  if (counts.products > 0) {
    check(s->nx > 500 || counts.transpositions == 2 * counts.products + (s->boundary == RC_BOUNDARY_FREE), s->name,
          "two transpositions a product");
    const int64_t loads = s->control == RC_CONTROL_AREA ? 40 : 1; /* at most, each with a certificate */
    check(counts.reductions <= 3 * counts.iterations + 100 * loads + s->stiffness * 90, s->name, "three sums an iteration");
    if (getenv("RC_TEST_COUNTS") && rank == 0)
      fprintf(stderr, "%s: %lld iterations, %lld products, %lld sums, %lld gathers, %lld shifts\n", s->name,
              (long long)counts.iterations, (long long)counts.products, (long long)counts.reductions, (long long)counts.gathers,
              (long long)counts.shifts);
  }

  /* Sparse contact is solved without a product of all ranks but for the gap at all points, or, where it is periodic, without a
   * row that one rank gives another; ranks agree on stops once an iteration, and on tiles a few times. */
  if (strncmp(s->name, "sparse", 6) == 0) {
    const int periodic = s->boundary == RC_BOUNDARY_PERIODIC;
    check(strcmp(j.result.backend, periodic ? "fft" : "split") == 0, s->name, "the backend of sparse contact");
    check(periodic || counts.products == 1, s->name, "the product of the gap");
    check(counts.shifts == 0, s->name, "unknowns that every rank has");
    check(counts.gathers <= (periodic ? 4 : 2) * counts.iterations + 150, s->name, "gathers of sparse contact");
  }

  /* What was solved is certified as it is: but for rounded pressures, and an indentation that the step has left. */
  const double load = j.result.load;
  if (s->control == RC_CONTROL_AREA) {
    check(fabs(j.result.contact_area - s->target) <= fmax(1e-3 * s->target, 0.51 * j.system.hx * j.system.hy), s->name,
          "the area");
    j.step.control = RC_CONTROL_LOAD;
    j.step.target = load;
  }
  const rc_status certified = s->single || s->hardness > 0 ? RC_UNCERTIFIED : RC_OK;
  rc_result again = RC_RESULT_INIT;
  again.p = j.result.p;
  const rc_status status_again = rc_contact_certify(contact, &j.step, &again);
  check(status_again == RC_OK || status_again == certified, s->name, "certify");
  check(fabs(again.load - load) <= 1e-6 * load, s->name, "certified load");
  free(p);
  free(gap);
  rc_contact_destroy(contact);
  free_job(j);
}

typedef struct watched {
  const scene* s;
  int64_t count;
  int creeps;
} watched;

static int32_t watch(int64_t step, const rc_result* result, void* user) {
  const watched* of = user;
  double* p = all_rows(((double*)result->p.data), (size_t)of->s->nx * sizeof(double), of->count, of->s->ny);
  if (rank == 0)
    printf("%s, %s, step %d: contacts %lld, p %016llx, result %016llx\n", of->creeps ? "creep" : "history", of->s->name,
           (int)step, (long long)result->contacts,
           (unsigned long long)digest(p, (size_t)(of->s->nx * of->s->ny) * sizeof(double), 0xcbf29ce484222325u),
           (unsigned long long)digest_of(*result));
  free(p);
  return 0;
}

/* Loads that rise and fall, from one warm start to the next; with a hardness each step leaves an indentation, with creep a
 * deflection. */
static void history(const scene* s, int creeps) {
  enum { steps = 4, terms = 2 };
  const double shares[steps] = {0.4, 0.8, 1, 0.6}, times[steps] = {1, 1.5, 4, 4};
  static const double ratio[terms] = {0.6, 1.5}, relaxing[terms] = {0.5, 7};
  rc_system system = system_of(s);
  rc_contact* contact = NULL;
  double approach[steps];
  if (creeps) {
    system.creep_terms = terms;
    system.creep_ratio = RC_IN(ratio);
    system.creep_time = RC_IN(relaxing);
  }
  double targets[steps], loads[steps], stiffness[steps], mean_gap[steps], energy[steps];
  double lower[steps], upper[steps], less[steps], more[steps];
  int64_t first = 0, count = 0;
  rc_ranks_rows(&exchange, &system, &first, &count);
  const rows r = rows_of(s, first, count);
  watched of = {s, count, creeps};
  for (int i = 0; i < steps; ++i) targets[i] = shares[i] * s->target;
  rc_history path = RC_HISTORY_INIT;
  path.control = s->control;
  path.n = steps;
  path.targets = RC_IN(targets);
  path.undeformed_gap = RC_IN(r.gap);
  path.mask = RC_IN(s->mask == whole ? NULL : r.mask);
  path.times = RC_IN(times);
  path.columns.load = RC_OUT(loads);
  path.columns.approach = RC_OUT(approach);
  path.columns.mean_gap = RC_OUT(mean_gap);
  path.columns.energy = RC_OUT(energy);
  path.columns.stiffness = RC_OUT(stiffness);
  path.columns.load_lower = RC_OUT(lower);
  path.columns.load_upper = RC_OUT(upper);
  if (s->hardness > 0) { /* few scenes: it doubles the solves on the contact set */
    path.columns.stiffness_lower = RC_OUT(less);
    path.columns.stiffness_upper = RC_OUT(more);
  }
  path.fn = watch;
  path.user = &of;
  check(rc_ranks_contact_create(&exchange, &system, NULL, &contact) == RC_OK, s->name, "create");
  check(rc_contact_solve_history(contact, &path) == RC_OK, s->name, "history");
  check(path.completed == steps, s->name, "steps");
  for (int i = 0; i < steps; ++i) {
    check(fabs(loads[i] - targets[i]) <= 1e-7 * targets[i], s->name, "loads");
    check(stiffness[i] > 0, s->name, "stiffness");
    check(mean_gap[i] > 0 && energy[i] < 0, s->name, "mean gap and energy");
    check(lower[i] <= loads[i] && loads[i] <= upper[i], s->name, "interval of the load");
    check(s->hardness == 0 || (less[i] <= stiffness[i] && stiffness[i] <= more[i]), s->name, "interval of the stiffness");
  }
  rc_contact_destroy(contact);
  if (creeps && ranks == 1) { /* on other numbers of ranks the digests are the same */
    double alone[steps];
    path.columns = (rc_columns){.approach = RC_OUT(alone)};
    path.fn = NULL;
    check(rc_contact_create(&system, NULL, &contact) == RC_OK, s->name, "create");
    check(rc_contact_solve_history(contact, &path) == RC_OK, s->name, "history of one process");
    for (int i = 0; i < steps; ++i)
      check(fabs(approach[i] - alone[i]) <= 1e-6 * fabs(alone[i]), s->name, "the approach of one process that creeps");
    rc_contact_destroy(contact);
  }
  free_rows(r);
}

/* What a solve of the first scene counts that ends after so many iterations. */
static rc_ranks_counts counted(int64_t iterations) {
  const scene* s = &scenes[0];
  job j = job_of(&exchange, s, 1);
  rc_contact* contact = NULL;
  rc_ranks_counts counts = RC_RANKS_COUNTS_INIT;
  rc_options_set_number(j.options, "haar-cg.nested", 0);
  rc_options_set_number(j.options, RC_OPT_MAX_ITER, (double)iterations);
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, s->name, "create");
  check(rc_contact_solve(contact, &j.step, &j.result) == RC_STOP_MAX_ITER, s->name, "few iterations");
  check(rc_ranks_contact_counts(contact, &counts) == RC_OK, s->name, "counts");
  rc_contact_destroy(contact);
  free_job(j);
  return counts;
}

static void an_iteration_makes_three_sums(void) {
  const rc_ranks_counts few = counted(4), more = counted(9);
  const int64_t iterations = more.iterations - few.iterations;
  check(iterations == 5, "five more iterations", "counts");
  check(more.reductions - few.reductions <= 3 * iterations, "five more iterations", "three sums an iteration");
}

/* Pressures that only one rank has changed are judged as by one process. */
static void one_rank_violates(int changed) {
  enum { kinds = 3 };
  static const char* const names[kinds] = {"too much pressure", "a negative pressure", "a pressure that is not finite"};
  const scene* s = &scenes[0];
  job j = job_of(&exchange, s, 1);
  const rows r = j.of, all = rows_of(s, 0, s->ny);
  const int64_t count = j.count;
  rc_contact* contact = NULL;
  int64_t highest = 0;
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, s->name, "create");
  check(rc_contact_solve(contact, &j.step, &j.result) == RC_OK, s->name, "solve");
  for (int64_t i = 1; i < s->nx * count; ++i)
    if (r.p[i] > r.p[highest]) highest = i;
  const double before = count > 0 ? r.p[highest] : 0;
  for (int kind = 0; kind < kinds; ++kind) {
    const double values[kinds] = {1.5 * before, -0.1 * before, NAN};
    if (rank == changed && count > 0) r.p[highest] = values[kind];
    rc_result mine = RC_RESULT_INIT;
    mine.p.data = r.p;
    const rc_status status = rc_contact_certify(contact, &j.step, &mine);
    double* p = all_rows(r.p, (size_t)s->nx * sizeof(double), count, s->ny);
    if (rank == 0) {
      rc_contact* one = NULL;
      rc_step alone;
      rc_result theirs;
      prepare(s, &all, &alone, &theirs);
      check(rc_contact_create(&j.system, j.options, &one) == RC_OK, names[kind], "create");
      memcpy(all.p, p, (size_t)(s->nx * s->ny) * sizeof(double));
      const rc_status expected = rc_contact_certify(one, &alone, &theirs);
      check(status == expected, names[kind], "the status of one process");
      if (expected == RC_OK || expected == RC_UNCERTIFIED) {
        check(fabs(mine.kkt_primal - theirs.kkt_primal) <= 1e-6 * theirs.kkt_primal, names[kind], "primal");
        check(fabs(mine.kkt_dual - theirs.kkt_dual) <= 1e-6 * theirs.kkt_dual + 1e-9, names[kind], "dual");
        check(fabs(mine.kkt_complementarity - theirs.kkt_complementarity) <= 1e-6 * theirs.kkt_complementarity + 1e-9,
              names[kind], "complementarity");
      }
      rc_contact_destroy(one);
    }
    free(p);
  }
  rc_contact_destroy(contact);
  free_job(j);
  free_rows(all);
}

int main(int argc, char** argv) {
  int worst = 0, provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  check(rc_mpi_exchange_create(MPI_COMM_WORLD, &exchange) == RC_OK, "all", "exchange");
  const int64_t threads = argc > 1 ? atoll(argv[1]) : 1;
  for (int i = 0; i < scene_count; ++i) {
    int wanted = argc < 3;
    for (int k = 2; k < argc; ++k) wanted = wanted || strcmp(argv[k], scenes[i].name) == 0;
    if (!wanted) continue;
    run(&scenes[i], threads);
    if (scenes[i].control == RC_CONTROL_LOAD && !scenes[i].single && !scenes[i].kernel &&
        (scenes[i].nx < 200 || scenes[i].nx == 640)) {
      history(&scenes[i], 0);
      history(&scenes[i], 1);
    }
  }
  for (int changed = 0; changed < ranks && argc < 3; ++changed) one_rank_violates(changed);
  if (argc < 3) an_iteration_makes_three_sums();
  MPI_Allreduce(&failures, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  rc_mpi_exchange_destroy(&exchange);
  MPI_Finalize();
  return worst > 0;
}
