/* What one rank does wrong, or what fails there, is known to all: the same status and message everywhere, and no rank waits for
 * ever. */
#define _GNU_SOURCE /* memmem */
#include <roughcontact/mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include "patient.h"
#include "scenes.h"

static int rank, ranks, failures;
static rc_exchange exchange = RC_EXCHANGE_INIT;
static int calls, fail_at; /* calls to MPI since `calls` was 0; the one that fails here, 0: none */

static int other_version; /* this rank says that its library has another version */

/* The call is made, and then reported as failed: what a rank hears of it first. */
static int reported(int code) { return ++calls == fail_at ? MPI_ERR_OTHER : code; }
int MPI_Allgatherv(const void* from, int n, MPI_Datatype type, void* to, const int* counts, const int* places,
                   MPI_Datatype to_type, MPI_Comm comm) {
  char* const said = other_version ? memmem(from, (size_t)n, ", ABI ", 6) : NULL;
  if (said) said[6] = '9';
  return reported(patient_allgatherv(from, n, type, to, counts, places, to_type, comm));
}
int MPI_Sendrecv(const void* from, int n, MPI_Datatype type, int to, int tag, void* into, int m, MPI_Datatype into_type,
                 int source, int into_tag, MPI_Comm comm, MPI_Status* status) {
  (void)status;
  return reported(patient_sendrecv(from, n, type, to, tag, into, m, into_type, source, into_tag, comm));
}

int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  (void)statuses;
  return reported(patient_waitall(count, requests));
}

static void check(int holds, const char* what) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "rank %d: %s: %s\n", rank, what, rc_last_error());
}

/* Every rank has this status and the same message, which has these words. */
static void check_failed(rc_status status, rc_status wanted, const char* words, const char* what) {
  char mine[400] = "", first[400] = "";
  snprintf(mine, sizeof mine, "%d %s", (int)status, rc_last_error());
  memcpy(first, mine, sizeof first);
  MPI_Bcast(first, sizeof first, MPI_CHAR, 0, MPI_COMM_WORLD);
  check(status == wanted, what);
  check(strcmp(mine, first) == 0, what);
  check(strstr(mine, words) != NULL, what);
}

static void disagreements(const scene* s) {
  job j = job_of(&exchange, s, 1);
  rc_contact* contact = NULL;
  const int last = ranks - 1;
  if (rank == last) j.system.nx += 1;
  check_failed(rc_ranks_contact_create(&exchange, &j.system, NULL, &contact), ranks > 1 ? RC_ERR_ARGUMENT : RC_OK,
               ranks > 1 ? "disagree on rc_system.nx: 65 and 64" : "", "another nx");
  rc_contact_destroy(contact);
  if (rank == last) j.system.nx -= 1;
  if (rank == last) rc_options_set_number(j.options, RC_OPT_TOL, 1e-6);
  check_failed(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact), ranks > 1 ? RC_ERR_ARGUMENT : RC_OK,
               ranks > 1 ? "disagree on option tol" : "", "another tol");
  rc_contact_destroy(contact);
  other_version = rank == last;
  check_failed(rc_ranks_contact_create(&exchange, &j.system, NULL, &contact), ranks > 1 ? RC_ERR_ARGUMENT : RC_OK,
               ranks > 1 ? "disagree on the library's version" : "", "another version");
  rc_contact_destroy(contact);
  other_version = 0;
  check_failed(rc_ranks_contact_create(&exchange, rank == last ? NULL : &j.system, NULL, &contact), RC_ERR_ARGUMENT,
               "rc_system is null", "no system on one rank");
  rc_options_set_number(j.options, RC_OPT_TOL, 1e-8);
  rc_options_set_number(j.options, RC_OPT_ACCURACY, 0.1);
  check_failed(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact), RC_ERR_INCOMPATIBLE, "no accuracy goal",
               "an accuracy goal");
  check(rc_ranks_contact_create(&exchange, &j.system, NULL, &contact) == RC_OK, "create");
  const double target = j.step.target;
  if (rank == last) j.step.target *= 1.5;
  check_failed(rc_contact_solve(contact, &j.step, &j.result), ranks > 1 ? RC_ERR_ARGUMENT : RC_OK,
               ranks > 1 ? "disagree on rc_step.target" : "", "another target");
  j.step.target = target;
  if (rank == last) j.step.mask.data = j.of.mask;
  check_failed(rc_contact_solve(contact, &j.step, &j.result), ranks > 1 ? RC_ERR_ARGUMENT : RC_OK,
               ranks > 1 ? "disagree on rc_step.mask: given and none" : "", "a mask on one rank");
  j.step.mask.data = NULL;
  const double good = j.gap[3];
  if (rank == last) j.gap[3] = NAN;
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_ERR_ARGUMENT, "not finite, first at ix=", "NaN on one rank");
  j.gap[3] = good;
  j.step.p0.data = j.p;
  for (int64_t i = 0; i < s->nx * j.count; ++i) j.p[i] = 0;
  if (rank == last) j.p[5] = INFINITY;
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_ERR_ARGUMENT, "rc_step.p0[5]", "an infinite start on one rank");
  j.step.p0.data = NULL;
  if (rank == last) j.step.undeformed_gap.memory = "cuda";
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_ERR_ARGUMENT, "arrays in the host's memory only",
               "a device's memory on one rank");
  j.step.undeformed_gap.memory = NULL;
  j.step.target = -1;
  j.step.control = RC_CONTROL_LOAD;
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_ERR_INFEASIBLE, "negative", "a negative load");
  check_failed(rc_contact_solve(contact, rank == 0 ? NULL : &j.step, &j.result), RC_ERR_ARGUMENT, "rank 0: rc_step is null",
               "no step on one rank");
  j.step.target = s->control == RC_CONTROL_LOAD ? s->target : 0.5;
  check(rc_contact_solve(contact, &j.step, &j.result) == RC_OK, "a good step after failures");
  rc_contact_destroy(contact);
  free_job(j);
}

/* No exchange: rows and contacts are then refused with the same words. */
static void check_refused(MPI_Comm comm, const char* words, const scene* s) {
  const rc_system system = system_of(s);
  rc_exchange none = RC_EXCHANGE_INIT;
  rc_contact* contact = NULL;
  int64_t first = 0, count = 0;
  check_failed(rc_mpi_exchange_create(comm, &none), RC_ERR_ARGUMENT, words, "an exchange");
  check_failed(rc_ranks_rows(&none, &system, &first, &count), RC_ERR_ARGUMENT, words, "rows");
  check_failed(rc_ranks_contact_create(&none, &system, NULL, &contact), RC_ERR_ARGUMENT, words, "a contact");
  rc_mpi_exchange_destroy(&none);
}

static void communicators(const scene* s) {
  rc_exchange larger = RC_EXCHANGE_INIT, smaller = RC_EXCHANGE_INIT;
  check_refused(MPI_COMM_NULL, "MPI_COMM_NULL", s);
  if (ranks > 1) {
    MPI_Comm part, inter;
    MPI_Comm_split(MPI_COMM_WORLD, rank % 2, rank, &part);
    MPI_Intercomm_create(part, 0, MPI_COMM_WORLD, (rank + 1) % 2, 7, &inter);
    check_refused(inter, "intercommunicator", s);
    MPI_Comm_free(&inter);
    MPI_Comm_free(&part);
  }
  if (rank == ranks - 1) smaller.struct_size -= sizeof(void*);
  check_failed(rc_mpi_exchange_create(MPI_COMM_WORLD, &smaller), RC_ERR_ARGUMENT, "RC_EXCHANGE_INIT",
               "a smaller struct on one rank");
  check_failed(rc_mpi_exchange_create(MPI_COMM_WORLD, rank == 0 ? NULL : &larger), RC_ERR_ARGUMENT, "RC_EXCHANGE_INIT",
               "no struct on one rank");
  check(rc_mpi_exchange_create_f(MPI_Comm_c2f(MPI_COMM_WORLD), &larger) == RC_OK, "a Fortran handle");
  check(larger.rank == rank && larger.ranks == ranks && !larger.refused, "the ranks of the communicator");
  rc_mpi_exchange_destroy(&larger);
  rc_mpi_exchange_destroy(&larger); /* again: nothing happens */
  rc_mpi_exchange_destroy(NULL);
}

static void stops(const scene* s) {
  job j = job_of(&exchange, s, 1);
  rc_contact* contact = NULL;
  rc_options_set_number(j.options, RC_OPT_MAX_ITER, 3);
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, "create");
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_STOP_MAX_ITER, "max_iter", "few iterations");
  rc_contact_destroy(contact);
  rc_options_set_number(j.options, RC_OPT_MAX_ITER, 10000);
  rc_options_set_number(j.options, RC_OPT_TIME_LIMIT, 1e-9);
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, "create");
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_STOP_TIME, "time_limit", "no time");
  rc_contact_destroy(contact);
  free_job(j);
}

/* The flag of one rank ends the calls of all, whenever it is set: before a history, or in one of its steps. */
static int32_t flag;
static int32_t set_flag(int64_t step, const rc_result* result, void* user) {
  (void)result, (void)user;
  flag = step == 1 && rank == ranks - 1;
  return 0;
}
static void flags(const scene* s) {
  job j = job_of(&exchange, s, 1);
  rc_contact* contact = NULL;
  const double targets[] = {0.5 * j.step.target, 0.7 * j.step.target, j.step.target};
  rc_history path = RC_HISTORY_INIT;
  path.control = j.step.control;
  path.n = 3;
  path.targets = RC_IN(targets);
  path.undeformed_gap = RC_IN(j.gap);
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, "create");
  if (rank == ranks - 1) rc_contact_cancel(contact);
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_STOP_CANCELLED, "rc_contact_cancel", "a step that one cancels");
  rc_stop_when(&flag);
  flag = rank == ranks - 1;
  check_failed(rc_contact_solve(contact, &j.step, &j.result), RC_STOP_CANCELLED, "rc_stop_when", "a flag before a step");
  check_failed(rc_contact_solve_history(contact, &path), RC_STOP_CANCELLED, "rc_stop_when", "a flag before a history");
  check(rank < ranks - 1 || path.completed == 0, "no step");
  flag = 0;
  path.fn = set_flag;
  check_failed(rc_contact_solve_history(contact, &path), RC_STOP_CANCELLED, "rc_stop_when", "a flag in a history");
  check(path.completed >= 2, "two steps");
  rc_stop_when(NULL);
  check(rc_contact_solve(contact, &j.step, &j.result) == RC_OK, "a good step after a flag");
  check_failed(rc_contact_reset(contact), RC_ERR_INCOMPATIBLE, "ranks share the contact", "a reset");
  rc_contact_destroy(contact);
  free_job(j);
}

/* Every call of a solve fails once, each time on another rank. step: between those that are tried. */
static void every_call(const scene* s, int step) {
  job j = job_of(&exchange, s, 1);
  rc_contact* contact = NULL;
  int all = 0;
  calls = 0;
  check(rc_ranks_contact_create(&exchange, &j.system, j.options, &contact) == RC_OK, "create");
  int creating = calls, own = 0;
  check(rc_contact_solve(contact, &j.step, &j.result) == RC_OK, "solve");
  rc_contact_destroy(contact);
  own = calls;
  MPI_Allreduce(&calls, &all, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  for (int at = 1; at <= all; at += step) {
    const int victim = at / step % ranks;
    rc_step again = j.step;
    rc_result result = j.result;
    calls = 0;
    fail_at = rank == victim ? at : 0;
    rc_status status = rc_ranks_contact_create(&exchange, &j.system, j.options, &contact);
    if (status == RC_OK) status = rc_contact_solve(contact, &again, &result);
    int made = own >= at;                      /* the victim may make fewer calls than others, */
    if (at == creating || at == own) made = 0; /* and after the last one it has nobody to tell */
    MPI_Bcast(&made, 1, MPI_INT, victim, MPI_COMM_WORLD);
    fail_at = 0;
    char words[64];
    snprintf(words, sizeof words, "rank %d: MPI_", victim);
    if (made)
      check_failed(status, RC_ERR_EXTERNAL, words, "a failed call");
    else
      check(status == RC_OK, "no failed call");
    if (contact) check(rc_contact_solve(contact, &again, &result) == RC_OK, "a good step after a failed call");
    rc_contact_destroy(contact);
    contact = NULL;
  }
  if (rank == 0) printf("%d calls of MPI, every %d. failed once\n", all, step);
  free_job(j);
}

int main(int argc, char** argv) {
  int worst = 0;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const scene s = {"", 64, 64, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.8, 0, whole, "mixed", 0, 0, NULL};
  const scene small = {"", 8, 6, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.05, 0, whole, "mixed", 0, 0, NULL};
  const scene sparse = {"", 520, 512, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 0, NULL};
  const scene periodic = {"", 520, 512, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 0, NULL};
  check(rc_mpi_exchange_create(MPI_COMM_WORLD, &exchange) == RC_OK, "an exchange");
  disagreements(&s);
  communicators(&s);
  stops(&s);
  stops(&sparse);
  stops(&periodic);
  flags(&small);
  flags(&s);
  flags(&sparse);
  flags(&periodic);
  every_call(&small, 1);
  every_call(&s, getenv("RC_TEST_QUICK") ? 23 : 1);
  every_call(&sparse, getenv("RC_TEST_QUICK") ? 29 : 5);
  every_call(&periodic, getenv("RC_TEST_QUICK") ? 61 : 7);
  MPI_Allreduce(&failures, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  rc_mpi_exchange_destroy(&exchange);
  MPI_Finalize();
  return worst > 0;
}
